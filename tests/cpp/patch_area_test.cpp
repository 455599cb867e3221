// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/patch_area.h"

#include "nmgs/element/quad8.h"

#include <gtest/gtest.h>

namespace {

using namespace nmgs;

// A strip of 10 x 0.1 whose upper side is a parabola that rises by `bulge`.
BlockModel strip(double bulge) {
    BlockModel model;
    model.dimension = 2;
    for (const auto &at : quad8::natural) {
        const double y = 0.05 * (1 + at[1]);
        model.nodes.push_back(
            {5 * (1 + at[0]), y + (at[1] > 0 ? bulge * (1 - at[0] * at[0]) : 0), 3});
    }
    model.divisions.push_back({1, 1, 0});
    return model;
}

TEST(PatchArea, IsExactUnderAParabola) {
    // Archimedes: two thirds of the rectangle round the segment.
    const PatchArea area = patch_area(strip(0.03), 0, {1, 1, 0});
    EXPECT_NEAR(area.exact, 1 + 2.0 / 3 * 10 * 0.03, 1e-12);
    EXPECT_NEAR(area.linear, 1, 1e-12);
}

TEST(PatchArea, OfTheLatticeTendsToIt) {
    const BlockModel model = strip(0.03);
    const double exact = patch_area(model, 0, {1, 1, 0}).exact;
    const double coarse = exact - patch_area(model, 0, {4, 1, 0}).linear;
    const double fine = exact - patch_area(model, 0, {8, 2, 0}).linear;
    EXPECT_NEAR(coarse / fine, 4, 1e-6); // chords of a parabola: exactly of second order
}

} // namespace
