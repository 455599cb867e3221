// SPDX-License-Identifier: LGPL-2.1-or-later
// The points that a layout has along the boundary of a face, in the order of the face's loops.
#pragma once

#include "nmgs_cad/face_loops.h"
#include "nmgs_cad/layout.h"

#include <numbers>
#include <vector>

namespace nmgs::cad {

// A place on the boundary. A seam's points appear once on each side, a pole's once at each end of
// its degenerated edge: with the same number and other parameters.
struct BoundaryNode {
    std::int32_t point = -1; // in the layout
    Uv uv{};
    Vec3 at{};
    double angle = std::numbers::pi; // of the face's inside; pi between the vertices
    std::size_t use = 0;             // the use of an edge that starts here or goes on here
    bool vertex = false;             // starts a use
    bool pole = false;               // what follows is a degenerated edge
    // Unit tangents of the boundary into the node and out of it; zero along degenerated edges.
    Vec3 in{}, out{};
    Vec3 middle{}; // of the segment that starts here
};

using BoundaryLoop = std::vector<BoundaryNode>;

// Every edge of the loops that is not degenerated must be laid out; raises GeometryError where the
// layout's points do not lie on the edge.
std::vector<BoundaryLoop> boundary_of(const CadShape &shape, const FaceLoops &loops,
                                      const Layout &layout);

// The same for one edge: from its start as the use runs, the end excluded.
BoundaryLoop nodes_along(const CadShape &shape, const EdgeUse &use, const Layout &layout);

} // namespace nmgs::cad
