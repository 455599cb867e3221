// SPDX-License-Identifier: LGPL-2.1-or-later
// Mid-point subdivision of the tetrahedra between a solid's middle and its faces.
#pragma once

#include "nmgs/support/vec3.h"
#include "nmgs_cad/layout.h"
#include "nmgs_cad/refusal.h"

#include <vector>

namespace nmgs::cad {

// One side of a face: the vertex at its start and the edge from there.
struct FaceSide {
    int vertex, edge;
};

struct FaceSides {
    int face;
    bool reversed; // against the face as the shape has it
    std::vector<FaceSide> sides;
};

// For solids that are seen whole from their middle, with any number of edges at a vertex: each face
// of three sides is one triangle, one of more sides a triangle a side; each triangle and the middle
// make a tetrahedron of four hexahedra. False and why: an edge or a face is laid out already, or a
// face has two sides.
bool fill_star(const CadShape &shape, int solid, const std::vector<FaceSides> &faces,
               Layout &layout, Refusal &refusal);

} // namespace nmgs::cad
