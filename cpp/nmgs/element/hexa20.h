// SPDX-License-Identifier: LGPL-2.1-or-later
// The 20-node serendipity brick (thesis, Table 2.2 with its misprints in N4 and N6 mended;
// Zienkiewicz and Taylor, The Finite Element Method, vol. 1, ch. 8). Nodes 0-3 are the corners at
// zeta = -1, counter-clockwise, 4-7 those at zeta = 1; 8-11 the bottom mid-edges 0-1, 1-2, 2-3,
// 3-0; 12-15 the same on top; 16-19 the vertical edges 0-4, 1-5, 2-6, 3-7. VTK and Abaqus order
// alike.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <span>

namespace nmgs::hexa20 {

constexpr int nodes = 20;
// Natural coordinates of the nodes.
constexpr std::array<std::array<double, 3>, 20> natural{{
    {-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
    {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
    {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0},
}};

// Values of the shape functions at (xi, eta, zeta).
std::array<double, 20> shape(double xi, double eta, double zeta);
// Derivatives by xi, eta and zeta.
struct Derivatives {
    std::array<double, 20> xi, eta, zeta;
};
Derivatives derivatives(double xi, double eta, double zeta);

// Point of the block at (xi, eta, zeta).
Vec3 map(std::span<const Vec3, 20> nodes, double xi, double eta, double zeta);
// Determinant of the Jacobian matrix of map().
double jacobian(std::span<const Vec3, 20> nodes, double xi, double eta, double zeta);

} // namespace nmgs::hexa20
