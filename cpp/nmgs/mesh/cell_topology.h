// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges and faces of each cell type in local node numbers, VTK's node orders (vtkCell.h and its
// subclasses), right-handed: the Jacobian of a good volume cell is positive.
#pragma once

#include "nmgs/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <span>

namespace nmgs {

// All cells of one type, in memory that somebody else owns.
struct CellView {
    CellType type;
    std::span<const std::int32_t> nodes;
    [[nodiscard]] std::size_t size() const {
        return nodes.size() / static_cast<std::size_t>(node_count(type));
    }
};

// End nodes, and the mid-side node of a quadratic cell or -1.
struct LocalEdge {
    int a, b, mid;
};

// type: triangle, triangle6, quad or quad8; nodes in its order, seen from outside of the cell.
struct LocalFace {
    CellType type;
    std::array<int, 8> nodes;
};

// The line of a line cell counts as its edge.
std::span<const LocalEdge> edges(CellType type);
// Faces of a volume cell; none for the others.
std::span<const LocalFace> faces(CellType type);

// The linear type with the same corners; the type itself where it is linear.
CellType linear_type(CellType type);
// The quadratic type with the same corners; the type itself where it is quadratic.
CellType quadratic_type(CellType type);
bool is_quadratic(CellType type);
int corner_count(CellType type);

// Raises ArgumentError naming the first cell whose nodes are not all in [0, points).
void check_nodes(std::span<const CellView> cells, std::size_t points);

} // namespace nmgs
