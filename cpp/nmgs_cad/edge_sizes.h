// SPDX-License-Identifier: LGPL-2.1-or-later
// How finely the edges of faces are to be divided.
#pragma once

#include "nmgs_cad/face_loops.h"
#include "nmgs_cad/layout_options.h"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace nmgs::cad {

// Wanted length of a segment at equal steps of an edge's length, from its start to its end.
struct EdgeSize {
    double length = 0;
    double turn = 0; // of the tangent from start to end, in radians
    bool closed = false;
    std::array<int, 2> vertex{}; // VertexN at its start and end
    std::vector<Vec3> at;        // where the sizes are asked for
    std::vector<double> wanted;  // there
    // Length of the first and the last segment; 0: as wanted.
    std::array<double, 2> tip{0, 0};
    [[nodiscard]] int tips() const { return (tip[0] > 0 ? 1 : 0) + (tip[1] > 0 ? 1 : 0); }
    [[nodiscard]] double segments() const; // as a fraction: the integral of 1 / wanted
    // The fractions of the length that divide the edge into n segments as the sizes ask for.
    [[nodiscard]] std::vector<double> fractions(int n) const;
};

using EdgeSizes = std::map<int, EdgeSize>; // by EdgeN

// By the edge's own turn and the longest segment that the options allow.
EdgeSize size_of_edge(const CadShape &shape, int edge, const LayoutOptions &options);

// Makes segments shorter where another part of the face's boundary is near, and lets lengths grow
// only slowly along and across the face.
void size_by_neighbourhood(const FaceLoops &loops, EdgeSizes &sizes);

} // namespace nmgs::cad
