// SPDX-License-Identifier: LGPL-2.1-or-later
// The 8-node serendipity quadrilateral (thesis, Table 2.1; Zienkiewicz and Taylor, The Finite
// Element Method, vol. 1, ch. 8). Nodes 0-3 are the corners, counter-clockwise from (-1, -1);
// 4-7 the mid-sides of edges 0-1, 1-2, 2-3, 3-0. VTK orders a quad8 alike.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <span>

namespace nmgs::quad8 {

constexpr int nodes = 8;
// Natural coordinates of the nodes.
constexpr std::array<std::array<double, 2>, 8> natural{
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

// Values of the shape functions at (xi, eta).
std::array<double, 8> shape(double xi, double eta);
// Derivatives by xi and eta.
struct Derivatives {
    std::array<double, 8> xi, eta;
};
Derivatives derivatives(double xi, double eta);

// Point of the patch at (xi, eta).
Vec3 map(std::span<const Vec3, 8> nodes, double xi, double eta);
// Tangents of the patch; their cross product is the normal, its length the surface Jacobian.
struct Tangents {
    Vec3 xi, eta;
};
Tangents tangents(std::span<const Vec3, 8> nodes, double xi, double eta);

} // namespace nmgs::quad8
