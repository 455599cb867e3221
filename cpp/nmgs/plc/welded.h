// SPDX-License-Identifier: LGPL-2.1-or-later
// A PLC whose duplicate points are one, with the planes of its facets and its edges: what all
// checks work on.
#pragma once

#include "nmgs/plc/facet_plane.h"
#include "nmgs/support/progress.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace nmgs {

// For each point the first one within the tolerance, itself if there is none before it.
std::vector<std::int32_t> first_of_equal(const std::vector<Vec3> &points, double tolerance);

// One side of a facet at an edge. forward: the facet runs from the edge's smaller to its larger
// node. inner: the facet lies on both sides of the edge.
struct EdgeSide {
    std::int32_t facet;
    bool forward;
    bool inner;
};

// An edge between two different nodes, with the sides first to last of Welded::sides.
struct PlcEdge {
    std::int32_t a, b; // a < b
    std::uint32_t first, last;
};

struct Welded {
    Plc plc; // nodes of equal points replaced by the first one
    double tolerance;
    std::vector<std::int32_t> first;
    std::vector<FacetPlane> planes;
    std::vector<FacetRings> rings; // views of plc
    std::vector<EdgeSide> sides;
    std::vector<PlcEdge> edges; // ascending

    Welded(const Plc &source, double tolerance, const Progress &progress);
    Welded(const Welded &) = delete;
    Welded &operator=(const Welded &) = delete;
    // No area worth the name: thinner than the tolerance.
    [[nodiscard]] bool degenerate(std::size_t facet) const {
        return planes[facet].area <= tolerance * planes[facet].size;
    }
    [[nodiscard]] Vec3 point(std::int32_t node) const {
        return plc.points[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] Box box(std::size_t facet) const;
};

} // namespace nmgs
