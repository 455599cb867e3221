// SPDX-License-Identifier: LGPL-2.1-or-later
// Signs of determinants, exact for every input (CGAL's filtered kernel; Bronnimann, Burnikel, Pion
// 2001). The only header of the project that stands before CGAL.
#pragma once

#include "nmgs/support/vec3.h"

namespace nmgs {

// Sign (-1, 0, 1) of det(b - a, c - a, d - a): positive when d is on the side of the plane a, b, c
// from which they are seen counter-clockwise.
int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// Sign of the area of the triangle a, b, c in the plane: positive when counter-clockwise.
int orient2d(double ax, double ay, double bx, double by, double cx, double cy);

} // namespace nmgs
