// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes and cylinders that could cut a solid into pieces that blocks fill.
#pragma once

#include "nmgs_cad/midpoint_obstacles.h"

#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>

#include <string>
#include <vector>

namespace nmgs::cad {

// A plane, or a cylinder about an axis, that goes through the whole solid.
struct Cut {
    bool cylinder = false;
    gp_Ax3 place; // the plane's x and y directions; the cylinder's axis and where its seam is
    double radius = 0;
    std::string name;                  // "plane of Face3", "cylinder through Edge7"
    std::vector<std::string> entities; // what it is made from
    int resolves = 0; // how many edges and vertices that stand in the way lie on it
};

// Whether two cuts are one, to a distance.
bool same(const Cut &a, const Cut &b, double tolerance);

// Cuts through the obstacles, those that resolve most first: by the planes and cylinders of the
// faces and edges there, and by planes through the axes of round faces.
std::vector<Cut> propose_cuts(const CadShape &shape, int solid);

// The cuts that the obstacles of some solids suggest, the most promising first; those that together
// resolve as many obstacles as cuts can (greedy set cover), and whether these are all; and a guess
// how many cuts are needed: those, and one each for the obstacles that no cut resolves.
struct Proposals {
    std::vector<Cut> cuts;
    std::vector<Cut> cover;
    bool all = false;
    int needed = 0;
};

Proposals candidates(const CadShape &cad, const std::vector<int> &solids,
                     const std::vector<Obstacles> &obstacles);

// The cut as a face that reaches beyond the solids.
TopoDS_Face cut_face(const CadShape &shape, const Cut &cut);

// Of the bounding box; not the smallest one, but quickly found.
double diagonal_of(const TopoDS_Shape &shape);

} // namespace nmgs::cad
