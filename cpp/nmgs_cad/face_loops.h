// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundary of a CAD face as closed loops of oriented edges with the angles between them.
#pragma once

#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/face_surface.h"
#include "nmgs_cad/refusal.h"

#include <Geom2d_Curve.hxx>

#include <optional>
#include <vector>

namespace nmgs::cad {

// An edge as a loop runs along it.
struct EdgeUse {
    int edge = 0;             // EdgeN
    bool forward = true;      // along the edge's curve, as EdgeCurve and Layout::edges run
    bool degenerated = false; // a point in space, a line of parameters: a pole
    bool seam = false;        // the same face has the edge once more, on its other side
    int vertex = 0;           // VertexN at the start of the use
    Vec3 start{};             // its place
    // Interior angle of the face at the start, between the use before and this one, in (0, 2 pi),
    // measured in the surface's tangent plane; pi where the boundary is smooth. At a pole it is
    // the angle in the plane of the parameters.
    double angle = 0;
    // The edge in the plane of the parameters; runs as the edge's curve does, over first ... last.
    Handle(Geom2d_Curve) parameters;
    double first = 0, last = 0;

    // Parameters of the surface at the parameter t of the edge's curve.
    [[nodiscard]] Uv at(double t) const;
    [[nodiscard]] Uv begin() const { return at(forward ? first : last); }
    [[nodiscard]] Uv end() const { return at(forward ? last : first); }
};

using FaceLoop = std::vector<EdgeUse>;

struct FaceLoops {
    // The face is on the left of each, seen against its normal: the outer loop is the first and
    // runs counter-clockwise, holes run clockwise.
    std::vector<FaceLoop> loops;
    // Edges that lie inside the face and bound nothing.
    std::vector<EdgeUse> inner;
    // VertexN that lie inside the face, on no edge of it.
    std::vector<int> points;
};

// The face's own orientation counts. None, and why, when the boundary does not close, the face has
// none, or an edge has no curve in the parameters.
std::optional<FaceLoops> face_loops(const CadShape &shape, int face, Refusal &refusal);

// Loops that meet at a vertex become one that goes through it twice: the corners between them are
// then the face's own. (A hole that touches the rim leaves two cusps.)
void join_touching_loops(const CadShape &shape, int face, FaceLoops &loops);

} // namespace nmgs::cad
