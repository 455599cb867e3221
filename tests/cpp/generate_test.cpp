// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/generate.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace {

using nmgs::BlockModel;
using nmgs::Vec3;

BlockModel boxes(int count, std::array<std::int32_t, 3> divisions) {
    BlockModel model;
    for (int b = 0; b < count; ++b) {
        for (const auto &p : nmgs::hexa20::natural) {
            model.nodes.push_back({0.5 * (p[0] + 1) + b, 0.5 * (p[1] + 1), 0.5 * (p[2] + 1)});
        }
        model.divisions.push_back(divisions);
    }
    return model;
}

TEST(Generate, OneBlockHasTheLatticesCounts) {
    const auto mesh = nmgs::generate(boxes(1, {2, 3, 4}));
    EXPECT_EQ(mesh.points.size(), 3U * 4 * 5);
    EXPECT_EQ(mesh.cells[0].size(), 2U * 3 * 4);
}

TEST(Generate, NeighboursShareTheNodesOfTheirFace) {
    const auto mesh = nmgs::generate(boxes(3, {2, 3, 4}));
    EXPECT_EQ(mesh.points.size(), 7U * 4 * 5);
    std::set<std::array<double, 3>> places;
    for (const Vec3 &p : mesh.points) {
        places.insert({p.x, p.y, p.z});
    }
    EXPECT_EQ(places.size(), mesh.points.size());
}

// Any of the 24 rotations of a block's numbering gives the same shared nodes.
TEST(Generate, RotatedNumberingSharesToo) {
    const std::array<std::array<int, 3>, 6> permutations{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
    for (const auto &permutation : permutations) {
        for (int signs = 0; signs < 8; ++signs) {
            const bool odd = permutation == permutations[3] || permutation == permutations[4] ||
                             permutation == permutations[5];
            const int flips = (signs & 1) + (signs >> 1 & 1) + (signs >> 2 & 1);
            if ((flips % 2 == 1) != odd) {
                continue; // mirrored
            }
            BlockModel model = boxes(2, {3, 3, 3});
            for (std::size_t n = 0; n < 20; ++n) {
                std::array<double, 3> p{};
                for (std::size_t d = 0; d < 3; ++d) {
                    const auto axis = static_cast<std::size_t>(permutation[d]);
                    p[axis] = nmgs::hexa20::natural[n][d] * ((signs >> d & 1) != 0 ? -1 : 1);
                }
                model.nodes[20 + n] = {0.5 * (p[0] + 1) + 1, 0.5 * (p[1] + 1), 0.5 * (p[2] + 1)};
            }
            const auto mesh = nmgs::generate(model);
            EXPECT_EQ(mesh.points.size(), 7U * 4 * 4);
            double volume = 0;
            for (std::size_t c = 0; c < mesh.cells[0].size(); ++c) {
                const auto *h = mesh.cells[0].nodes.data() + 8 * c;
                const auto p = [&](std::size_t i) {
                    return mesh.points[static_cast<std::size_t>(h[i])];
                };
                const double v = nmgs::determinant(p(1) - p(0), p(3) - p(0), p(4) - p(0));
                EXPECT_GT(v, 0);
                volume += v;
            }
            EXPECT_NEAR(volume, 2.0, 1e-12);
        }
    }
}

TEST(Generate, DisagreeingDivisionsNameBothBlocks) {
    BlockModel model = boxes(2, {2, 3, 4});
    model.divisions[1] = {2, 5, 4};
    try {
        nmgs::generate(model);
        FAIL() << "expected BlockingError";
    } catch (const nmgs::BlockingError &e) {
        EXPECT_NE(std::string(e.what()).find("Block2"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("Block1"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find('5'), std::string::npos) << e.what();
    }
}

TEST(Generate, SameBytesForAnyNumberOfThreads) {
    const BlockModel model = boxes(3, {17, 19, 23});
    nmgs::set_threads(1);
    const auto one = nmgs::generate(model);
    nmgs::set_threads(7);
    const auto seven = nmgs::generate(model);
    nmgs::set_threads(0);
    ASSERT_EQ(one.points.size(), seven.points.size());
    EXPECT_EQ(std::memcmp(one.points.data(), seven.points.data(), 24 * one.points.size()), 0);
    EXPECT_EQ(std::memcmp(one.cells[0].nodes.data(), seven.cells[0].nodes.data(),
                          4 * one.cells[0].nodes.size()),
              0);
}

TEST(Generate, CancelStops) {
    EXPECT_THROW(nmgs::generate(boxes(1, {50, 50, 50}), {}, [](double) { return false; }),
                 nmgs::Cancelled);
}

TEST(Generate, RefusesWhatCannotFit) {
    EXPECT_THROW(nmgs::generate(boxes(1, {10000, 10000, 10000})), nmgs::ArgumentError);
    EXPECT_THROW(nmgs::generate(boxes(1, {0, 1, 1})), nmgs::ArgumentError);
}

} // namespace
