// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces, loops and edges around one solid, with the angles between them.
#pragma once

#include "nmgs/support/vec3.h"
#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/refusal.h"

#include <optional>
#include <utility>
#include <vector>

namespace nmgs::cad {

// One use of an edge by a face of the solid. It runs with the face on its left, seen from outside
// of the solid.
struct Coedge {
    int edge;       // 1-based number in the shape
    bool forward;   // runs as the edge's curve does
    int face;       // place in SolidBoundary::faces
    int next, prev; // in its loop: places in SolidBoundary::coedges
    int mate;       // the same edge in the face on its right
    int vertex;     // where it starts: 1-based number in the shape
    double corner;  // angle of the face there, from the coedge before, in (0, 2 pi)
    // Angle of the solid along the edge, half-way: under pi convex, above pi concave.
    double dihedral;
    bool degenerated; // a pole: no length, no mate, no angle
};

struct SolidBoundary {
    int solid;
    std::vector<int> faces;     // 1-based numbers in the shape
    std::vector<char> reversed; // the solid sees it from the other side than shape.face() does
    std::vector<std::vector<int>> loops; // of each face: the first coedge of each loop
    std::vector<Coedge> coedges;

    [[nodiscard]] bool seam(int coedge) const {
        const Coedge &c = coedges[static_cast<std::size_t>(coedge)];
        return c.mate >= 0 && coedges[static_cast<std::size_t>(c.mate)].face == c.face;
    }
};

// Nothing and the refusal for a solid with a face inside it or with an edge where other than two
// faces meet.
std::optional<SolidBoundary> boundary_of(const CadShape &shape, int solid, Refusal &refusal);

// (n of FaceN, whether it bounds the solid) of each face of a solid, ascending. A face inside the
// solid, which has it on both sides, does not.
std::vector<std::pair<int, bool>> solid_faces(const CadShape &shape, int solid);

// Unit tangent of an edge's curve at a parameter, and its turning in radians along the whole edge.
Vec3 tangent_at(const TopoDS_Edge &edge, double parameter);
double turning(const TopoDS_Edge &edge);

} // namespace nmgs::cad
