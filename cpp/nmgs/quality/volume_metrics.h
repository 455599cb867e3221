// SPDX-License-Identifier: LGPL-2.1-or-later
// Quality of one linear volume cell. Definitions: C. J. Stimpson, C. D. Ernst, P. Knupp,
// P. P. Pebay, D. Thompson, The Verdict Geometric Quality Library, SAND2007-1751; what Verdict does
// not define is said here. Angles in degrees. Of a degenerate cell, ratios that should be small are
// infinite and those that should be large are 0.
#pragma once

#include "nmgs/mesh/mesh.h"

namespace nmgs::tetra {
double volume(const Vec3 *p);
double scaled_jacobian(const Vec3 *p);
double shape(const Vec3 *p);
// Lmax / (2 sqrt(6) r), r the radius of the inscribed sphere.
double aspect_ratio(const Vec3 *p);
// Circumradius by shortest edge (Shewchuk; TetGen's measure).
double radius_edge_ratio(const Vec3 *p);
} // namespace nmgs::tetra

namespace nmgs::hexahedron {
// Least over the corners and the centre of J / (L1 L2 L3).
double scaled_jacobian(const Vec3 *p);
double shape(const Vec3 *p);
// Longest by shortest principal axis (Verdict: maximum edge ratio).
double aspect_ratio(const Vec3 *p);
// Largest |cos| between principal axes.
double skew(const Vec3 *p);
} // namespace nmgs::hexahedron

namespace nmgs::wedge {
// Least over the corners of 2 / sqrt(3) J / (L1 L2 L3): 1 for an upright prism on an equilateral
// triangle.
double scaled_jacobian(const Vec3 *p);
} // namespace nmgs::wedge

namespace nmgs::pyramid {
// Least over the corners of the base of sqrt(2) J / (L1 L2 L3), at most 1: 1 for the pyramid of
// equal edges.
double scaled_jacobian(const Vec3 *p);
} // namespace nmgs::pyramid

namespace nmgs::solid {
// Of any linear volume type. Volume: exact for bilinear faces, so for the trilinear hexahedron.
double volume(CellType type, const Vec3 *p);
// Smallest and largest angle between two faces at an end of their common edge.
double min_angle(CellType type, const Vec3 *p);
double max_angle(CellType type, const Vec3 *p);
// The largest warpage of the quadrilateral faces.
double warpage(CellType type, const Vec3 *p);
} // namespace nmgs::solid
