// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/predicates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using nmgs::orient2d;
using nmgs::orient3d;
using nmgs::Vec3;

TEST(Predicates, SignsFollowTheDeterminant) {
    EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
    EXPECT_EQ(orient3d({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
    EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0}), 0);
    EXPECT_EQ(orient2d(0, 0, 1, 0, 0, 1), 1);
    EXPECT_EQ(orient2d(0, 0, 0, 1, 1, 0), -1);
}

// 0.1 + t * (0.1, 0.2) by doubling is exact, so the points are collinear to the bit; one unit in
// the last place off they are not.
TEST(Predicates, OneUnitInTheLastPlaceDecides) {
    const double x = 0.1;
    const double y = 0.2;
    EXPECT_EQ(orient2d(0, 0, x, y, 4 * x, 4 * y), 0);
    EXPECT_EQ(orient2d(0, 0, x, y, 4 * x, std::nextafter(4 * y, 1)), 1);
    EXPECT_EQ(orient2d(0, 0, x, y, 4 * x, std::nextafter(4 * y, 0)), -1);
    const Vec3 a{x, y, 0.3};
    const Vec3 b{0.7, 0.5, 0.9};
    const Vec3 o{0, 0, 0};
    EXPECT_EQ(orient3d(o, a, b, 8 * a), 0);
    EXPECT_EQ(orient3d(o, a, b, {8 * a.x, 8 * a.y, std::nextafter(8 * a.z, 9)}),
              -orient3d(o, a, b, {8 * a.x, 8 * a.y, std::nextafter(8 * a.z, 0)}));
    EXPECT_NE(orient3d(o, a, b, {8 * a.x, 8 * a.y, std::nextafter(8 * a.z, 9)}), 0);
}

TEST(Predicates, FarAndTinyCoordinates) {
    const double far = 1e100;
    EXPECT_EQ(orient3d({far, 0, 0}, {0, far, 0}, {0, 0, far}, {far, far, far}), 1);
    const double tiny = 1e-100;
    EXPECT_EQ(orient3d({tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}, {0, 0, 0}), -1);
}

} // namespace
