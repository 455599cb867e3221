// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace nmgs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(Vec3 p) {
    return {p.x, p.y, p.z};
}

} // namespace

int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

int orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
    return static_cast<int>(CGAL::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by),
                                              Kernel::Point_2(cx, cy)));
}

} // namespace nmgs
