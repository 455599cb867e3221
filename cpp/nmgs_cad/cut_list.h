// SPDX-License-Identifier: LGPL-2.1-or-later
// Proposed cuts in plain figures, for those who know nothing of OpenCASCADE.
#pragma once

#include "nmgs_cad/layout.h"

#include <string>
#include <vector>

namespace nmgs::cad {

// A plane (radius 0), or a cylinder about an axis. origin: of the plane or axis, the point nearest
// to the middle of the shape's bounding box. direction: the plane's normal or the axis, of
// length 1.
struct CutFigures {
    Vec3 origin, direction;
    double radius = 0;
    std::string name;                  // "plane of Face3"
    std::vector<std::string> entities; // what it is made from
    int resolves = 0;                  // edges and vertices that stand in the way and lie on it
};

// propose_cuts of a solid, from 1; the most promising first.
std::vector<CutFigures> cut_list(const CadShape &shape, int solid);

} // namespace nmgs::cad
