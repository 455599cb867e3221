// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that no other strategy fills as they are, cut into pieces that meet face to face.
#pragma once

#include "nmgs_cad/layout_options.h"

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

// The edges of the solid that stand in the way of blocks: concave, smooth or closed ones, and
// seams, in ascending order. Empty when none does, or when the solid's faces do not enclose it.
std::vector<int> obstacles(const CadShape &shape, int solid);

// Cuts through the obstacles, those that resolve most first: by the planes and cylinders of the
// faces and edges there, and by planes through the axes of round faces.
std::vector<Cut> propose_cuts(const CadShape &shape, int solid);

// The cut as a face that reaches beyond the solids.
TopoDS_Face cut_face(const CadShape &shape, const Cut &cut);

// Adds one proposed cut after the other, that which leaves fewest obstacles first, until every
// piece can be filled; see FillSolid.
bool fill_cut(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
              Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
