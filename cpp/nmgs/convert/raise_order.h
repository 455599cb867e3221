// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear cells into quadratic ones: a mid-side node on each edge.
#pragma once

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/support/progress.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace nmgs {

struct QuadraticMesh {
    Array<Vec3> points; // the corners, then one point an edge in the order of first appearance
    std::vector<CellBlock> cells;
    // End nodes of the edge on which mid-side node corners + e lies, the lower first.
    std::vector<std::array<std::int32_t, 2>> ends;
};

// Where the mid-side node of an edge goes: block and number of the first cell that has the edge,
// and the edge's number in the cell. Called from any thread.
using PlaceOnEdge = std::function<Vec3(std::size_t block, std::size_t cell, std::size_t edge)>;

// Every block of linear cells becomes its quadratic type, in VTK's node order. Without `place` the
// new nodes are the middles of straight edges.
// Raises ArgumentError for quadratic cells, nodes not in [0, points), or more than 2147483647
// nodes.
QuadraticMesh raise_order(std::span<const Vec3> points, std::span<const CellView> cells,
                          const PlaceOnEdge &place = {}, const Progress &progress = {});

} // namespace nmgs
