// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/default_divisions.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace nmgs;
using std::numbers::pi;

// An angle of a ring with radii 1 and 2, height 1: xi radially, eta round, zeta up.
BlockModel sector(double angle) {
    BlockModel model;
    for (const auto &at : hexa20::natural) {
        const double r = 1.5 + 0.5 * at[0];
        const double a = 0.5 * angle * (1 + at[1]);
        model.nodes.push_back({r * std::cos(a), r * std::sin(a), 0.5 * at[2]});
    }
    model.divisions.push_back({1, 1, 1});
    return model;
}

std::array<std::int32_t, 3> divide(const BlockModel &model, double size,
                                   const DefaultDivisions &options = {}) {
    return default_divisions(model, find_topology(model), size, options)[0];
}

TEST(DefaultDivisions, FollowTheCurvatureAndTheSize) {
    // A parabola through three points of an arc of 30 degrees turns by nearly that.
    const BlockModel model = sector(pi / 6);
    EXPECT_EQ(divide(model, 10), (std::array<std::int32_t, 3>{1, 3, 1}));
    EXPECT_EQ(divide(model, 0.25), (std::array<std::int32_t, 3>{4, 5, 4})); // arc 2 pi / 6
    EXPECT_THROW(divide(model, 0), ArgumentError);
    EXPECT_THROW(divide(model, -1), ArgumentError);
}

TEST(DefaultDivisions, StayBelowTheNumberOfCells) {
    const BlockModel model = sector(pi / 6);
    DefaultDivisions options;
    options.most_cells = 100;
    const auto g = divide(model, 0.01, options);
    EXPECT_LE(g[0] * g[1] * g[2], 100);
    EXPECT_GT(g[0] * g[1] * g[2], 30);
    options.most_cells = 0;
    EXPECT_EQ(divide(model, 0.01, options), (std::array<std::int32_t, 3>{1, 1, 1}));
}

// A lens as high as its curvature makes it: the angle alone would allow one element.
TEST(DefaultDivisions, KeepTheVolume) {
    BlockModel model;
    for (const auto &at : hexa20::natural) {
        const double high = 0.02 * (2 - at[0] * at[0]);
        model.nodes.push_back({at[0], 0.2 * at[1], at[2] > 0 ? high : at[2] == 0 ? high / 2 : 0});
    }
    model.divisions.push_back({1, 1, 1});
    const auto g = divide(model, 10);
    // Chords under a parabola with second derivative 0.04 miss h^3 0.04 / 12 each; the area is
    // 1/15.
    const double missing = std::pow(2.0 / g[0], 3) * g[0] * 0.04 / 12;
    EXPECT_LT(missing / (1.0 / 15), 0.0061);
}

// A lens beside a large box: by the volume of both it could do with one element.
TEST(DefaultDivisions, KeepTheVolumeOfEachPart) {
    BlockModel model;
    for (const auto &at : hexa20::natural) {
        const double high = 0.02 * (2 - at[0] * at[0]);
        model.nodes.push_back({at[0], 0.2 * at[1], at[2] > 0 ? high : at[2] == 0 ? high / 2 : 0});
    }
    for (const auto &at : hexa20::natural) {
        model.nodes.push_back({10 + at[0], at[1], at[2]});
    }
    model.divisions.assign(2, {1, 1, 1});
    DefaultDivisions options;
    EXPECT_EQ(default_divisions(model, find_topology(model), 10, options)[0][0], 1);
    options.part = {0, 1};
    const auto g = default_divisions(model, find_topology(model), 10, options);
    EXPECT_LT(std::pow(2.0 / g[0][0], 3) * g[0][0] * 0.04 / 12 / (1.0 / 15), 0.0061);
    EXPECT_EQ(g[1], (std::array<std::int32_t, 3>{1, 1, 1}));
    options.part = {0};
    EXPECT_THROW(default_divisions(model, find_topology(model), 10, options), ArgumentError);
    options.part = {0, -1};
    EXPECT_THROW(default_divisions(model, find_topology(model), 10, options), ArgumentError);
    options.part = {0, 1};
    options.structured = {1};
    EXPECT_THROW(default_divisions(model, find_topology(model), 10, options), ArgumentError);
}

// Structured blocks follow the curvature whatever their number.
TEST(DefaultDivisions, ManyUnstructuredBlocksAreCoarser) {
    const BlockModel model = sector(pi / 3);
    DefaultDivisions options;
    options.many_blocks = 1;
    options.volume_error = 1;
    EXPECT_EQ(divide(model, 10, options)[1], 2);
    options.structured = {1};
    EXPECT_EQ(divide(model, 10, options)[1], 6);
}

TEST(DefaultDivisions, KeepTheAreaOfThinPatches) {
    // It turns by less than 7 degrees, but the bulge is a sixth of its area.
    BlockModel model;
    model.dimension = 2;
    for (const auto &at : quad8::natural) {
        const double y = 0.05 * (1 + at[1]);
        model.nodes.push_back(
            {5 * (1 + at[0]), y + (at[1] > 0 ? 0.03 * (1 - at[0] * at[0]) : 0), 0});
    }
    model.divisions.push_back({1, 1, 0});
    // n chords leave 1 / n^2 of the segment's area of 0.2 out.
    const auto g = divide(model, 100);
    EXPECT_LT(0.2 / (g[0] * g[0]), 0.006 * 1.2);
    EXPECT_LE(g[0], 12);
}

} // namespace
