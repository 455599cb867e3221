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

// The enumeration lists each linear type with its quadratic one behind it.
constexpr bool is_quadratic(CellType type) {
    return static_cast<int>(type) % 2 == 1;
}
// The linear type with the same corners; the type itself where it is linear.
constexpr CellType linear_type(CellType type) {
    return static_cast<CellType>(static_cast<int>(type) / 2 * 2);
}
// The quadratic type with the same corners; the type itself where it is quadratic.
constexpr CellType quadratic_type(CellType type) {
    return static_cast<CellType>(static_cast<int>(type) / 2 * 2 + 1);
}
int corner_count(CellType type);

namespace tables {
inline constexpr LocalEdge line_edges[] = {{0, 1, 2}};
inline constexpr LocalEdge triangle_edges[] = {{0, 1, 3}, {1, 2, 4}, {2, 0, 5}};
inline constexpr LocalEdge quad_edges[] = {{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}};
inline constexpr LocalEdge tetra_edges[] = {{0, 1, 4}, {1, 2, 5}, {2, 0, 6},
                                            {0, 3, 7}, {1, 3, 8}, {2, 3, 9}};
inline constexpr LocalEdge pyramid_edges[] = {{0, 1, 5}, {1, 2, 6},  {2, 3, 7},  {3, 0, 8},
                                              {0, 4, 9}, {1, 4, 10}, {2, 4, 11}, {3, 4, 12}};
inline constexpr LocalEdge wedge_edges[] = {{0, 1, 6},  {1, 2, 7},  {2, 0, 8},
                                            {3, 4, 9},  {4, 5, 10}, {5, 3, 11},
                                            {0, 3, 12}, {1, 4, 13}, {2, 5, 14}};
inline constexpr LocalEdge hexahedron_edges[] = {{0, 1, 8},  {1, 2, 9},  {2, 3, 10}, {3, 0, 11},
                                                 {4, 5, 12}, {5, 6, 13}, {6, 7, 14}, {7, 4, 15},
                                                 {0, 4, 16}, {1, 5, 17}, {2, 6, 18}, {3, 7, 19}};
} // namespace tables

// The line of a line cell counts as its edge.
constexpr std::span<const LocalEdge> edges(CellType type) {
    switch (linear_type(type)) {
    case CellType::line:
        return tables::line_edges;
    case CellType::triangle:
        return tables::triangle_edges;
    case CellType::quad:
        return tables::quad_edges;
    case CellType::tetra:
        return tables::tetra_edges;
    case CellType::pyramid:
        return tables::pyramid_edges;
    case CellType::wedge:
        return tables::wedge_edges;
    default:
        return tables::hexahedron_edges;
    }
}

// Faces of a volume cell; none for the others.
std::span<const LocalFace> faces(CellType type);

// Raises ArgumentError naming the first cell whose nodes are not all in [0, points).
void check_nodes(std::span<const CellView> cells, std::size_t points);

} // namespace nmgs
