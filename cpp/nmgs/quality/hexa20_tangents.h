// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangents of a 20-node hexahedron as polynomials in Bernstein form: the one along a direction
// is linear in it and quadratic in the other two, so 18 control vectors hold it whole.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <span>

namespace nmgs::curved {

struct Hexa20Tangents {
    static constexpr std::size_t controls = 18;
    // [3 * direction + coordinate]; coefficients i + n0 * (j + n1 * k), where n is 2 along the
    // tangent's own direction and 3 along the others. Natural coordinates run from -1 to 1.
    std::array<std::array<double, controls>, 9> coefficients;

    [[nodiscard]] Vec3 control(std::size_t direction, std::size_t i) const {
        const auto *c = &coefficients[3 * direction];
        return {c[0][i], c[1][i], c[2][i]};
    }
    // The tangent at a corner, numbered by bits: 1 for xi, 2 for eta, 4 for zeta.
    [[nodiscard]] Vec3 at_corner(std::size_t direction, std::size_t corner) const;
};

Hexa20Tangents hexa20_tangents(const Vec3 *nodes);

// Points a direction of the grid on which the Jacobian, of degree 5 a direction, is determined.
constexpr std::size_t hexa20_grid = 6;

// Values at the grid's points, natural coordinates rising, the first fastest:
// out[(3 * direction + coordinate) * 216 + point].
void sample(const Hexa20Tangents &tangents, std::span<double, 9 * 216> out);

// Bounds from the control vectors alone: a tangent differs from their mean by no more than they do.
// They are close where the hexahedron is nearly a parallelepiped.
struct ScaledJacobianBounds {
    double lower; // not above the scaled Jacobian anywhere in the cell; -1 where nothing is known
    double upper; // its least value at the corners
};
ScaledJacobianBounds scaled_jacobian_bounds(const Hexa20Tangents &tangents);

} // namespace nmgs::curved
