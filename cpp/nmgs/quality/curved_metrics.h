// SPDX-License-Identifier: LGPL-2.1-or-later
// Metrics of quadratic cells (triangle6, quad8, tetra10, hexahedron20) that hold over the whole
// cell, not only at its nodes. The Jacobian and the squared lengths of the tangents are
// polynomials; their Bernstein coefficients bound them, and the cell is halved until the bounds are
// close (Johnen, Remacle, Geuzaine, J. Comput. Phys. 233, 2013; of quality measures: Johnen,
// Geuzaine, Toulorge, Remacle, Efficient computation of the minimum of shape quality measures on
// curvilinear finite elements, Comput.-Aided Des. 103, 2018). Every value is a bound on the safe
// side.
//
// Not of wedge15 and pyramid13: those are measured as straight cells, by their corners, as Verdict
// measures them.
//
// The Jacobian of a surface cell is the part of the cross product of its tangents along the cell's
// mean normal: it becomes negative where the cell turns back on itself.
#pragma once

#include "nmgs/mesh/mesh.h"

namespace nmgs::curved {

bool has_metrics(CellType type);

// Smallest Jacobian times the volume of the reference cell: the cell's volume or area where the
// Jacobian is constant. Not above the true minimum, nor below it by more than 0.1 % of the largest.
double min_jacobian(CellType type, const Vec3 *p);
// Smallest by largest Jacobian: 1 for a constant one, not positive for a folded cell.
double jacobian_ratio(CellType type, const Vec3 *p);
// Smallest value in the cell of Verdict's scaled Jacobian, taken of the tangents in place of the
// edges: 1 for an undistorted cell, Verdict's value for a straight parallelepiped, triangle or
// tetrahedron. Not above the true minimum, nor below it by more than 5 % and
// 0.01.
double scaled_jacobian(CellType type, const Vec3 *p);
// Exact.
double volume(CellType type, const Vec3 *p);
// By Gauss-Legendre quadrature of 6 x 6 points.
double area(CellType type, const Vec3 *p);
// Of a line3, by 6 points.
double length(const Vec3 *p);

} // namespace nmgs::curved
