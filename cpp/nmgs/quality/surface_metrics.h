// SPDX-License-Identifier: LGPL-2.1-or-later
// Quality of one linear triangle or quadrilateral. Definitions: C. J. Stimpson, C. D. Ernst,
// P. Knupp, P. P. Pebay, D. Thompson, The Verdict Geometric Quality Library, SAND2007-1751.
// Angles in degrees. Without a definition for a flat or otherwise degenerate cell, ratios that
// should be small are infinite and those that should be large are 0.
#pragma once

#include "nmgs/support/vec3.h"

namespace nmgs::triangle {
double area(const Vec3 *p);
// 2 / sqrt(3) J / max(Li Lj); not negative, since a triangle in space has no outside.
double scaled_jacobian(const Vec3 *p);
double shape(const Vec3 *p);
// Lmax (L0 + L1 + L2) / (4 sqrt(3) A).
double aspect_ratio(const Vec3 *p);
double min_angle(const Vec3 *p);
double max_angle(const Vec3 *p);
// Circumradius by shortest edge (Shewchuk; TetGen's measure).
double radius_edge_ratio(const Vec3 *p);
} // namespace nmgs::triangle

namespace nmgs::quad {
double area(const Vec3 *p);
// Least over the corners of J / (Li Lj), signed by the normal at the centre.
double scaled_jacobian(const Vec3 *p);
double shape(const Vec3 *p);
// Lmax (L0 + L1 + L2 + L3) / (4 A).
double aspect_ratio(const Vec3 *p);
// |cos| of the angle between the principal axes.
double skew(const Vec3 *p);
// 1 - min((n0 . n2)^3, (n1 . n3)^3) of the unit normals at the corners; 0 when flat.
double warpage(const Vec3 *p);
double min_angle(const Vec3 *p);
double max_angle(const Vec3 *p);
} // namespace nmgs::quad
