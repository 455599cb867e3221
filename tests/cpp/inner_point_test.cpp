// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/inner_point.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace {

using nmgs::Vec3;
using Triangle = std::array<Vec3, 3>;

// Normals towards the inside.
std::vector<Triangle> tetrahedron(Vec3 shift) {
    const Vec3 o = shift;
    const Vec3 x = shift + Vec3{1, 0, 0};
    const Vec3 y = shift + Vec3{0, 1, 0};
    const Vec3 z = shift + Vec3{0, 0, 1};
    return {{o, x, y}, {o, z, x}, {o, y, z}, {x, z, y}};
}

TEST(InnerPoint, CentreOfTheInscribedSphere) {
    // Of the corner tetrahedron of a unit cube: r = 3 V / A = (1/2) / (3/2 + sqrt(3)/2).
    const double r = 1 / (3 + std::sqrt(3.0));
    for (const Vec3 shift : {Vec3{0, 0, 0}, Vec3{1e6, -2e6, 3e6}}) {
        const auto point = nmgs::inner_point(tetrahedron(shift));
        ASSERT_TRUE(point);
        EXPECT_NEAR(point->x - shift.x, r, 1e-9);
        EXPECT_NEAR(point->y - shift.y, r, 1e-9);
        EXPECT_NEAR(point->z - shift.z, r, 1e-9);
    }
}

TEST(InnerPoint, NoneWhereNothingIsInside) {
    auto inside_out = tetrahedron({0, 0, 0});
    for (Triangle &t : inside_out) {
        std::swap(t[0], t[1]);
    }
    EXPECT_FALSE(nmgs::inner_point(inside_out));
    auto flat = tetrahedron({0, 0, 0});
    flat[0][2] = flat[0][1];
    EXPECT_FALSE(nmgs::inner_point(flat));
    EXPECT_FALSE(nmgs::inner_point({}));
}

} // namespace
