// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts that bring a solid nearer to pieces that can be swept.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/cad_shape.h"

#include <TopTools_ListOfShape.hxx>

#include <string>
#include <vector>

namespace nmgs::cad {

struct SweepCut {
    TopTools_ListOfShape faces; // that cut
    std::string name;           // "plane of Face3", "box round Face7"
    double cost = 0;            // of the pieces that it leaves
};

// What is in the way of sweeping the solids of a shape, each alone, and slivers among their edges;
// under 1 where it is only that they are many. length: of the whole that they are pieces of.
double sweep_cost(const CadShape &shape, double length);

// Cuts of the shape's only solid, best first: planes and cylinders through its concave edges and
// where its faces change the axis that they turn about, boxes round what crosses a sweep. Those
// that make it worse are left out. Takes the faces of the pieces that it looks at from `work`, and
// ends where none is left.
std::vector<SweepCut> sweep_cuts(const CadShape &one, double length, int &work,
                                 const Progress &progress);

} // namespace nmgs::cad
