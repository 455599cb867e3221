// SPDX-License-Identifier: LGPL-2.1-or-later
// Mesh: the one exchange type. Plain contiguous arrays, 24 bytes a point and 4 bytes a node of each
// cell (thesis, eqs. 5.1 and 5.2). Cell types and node orders are VTK's, named as meshio names
// them.
#pragma once

#include "nmgs/support/array.h"
#include "nmgs/support/vec3.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nmgs {

enum class CellType {
    line,
    line3,
    triangle,
    triangle6,
    quad,
    quad8,
    tetra,
    tetra10,
    pyramid,
    pyramid13,
    wedge,
    wedge15,
    hexahedron,
    hexahedron20,
};

// Nodes of one cell of the type.
int node_count(CellType type);
// 1 for lines, 2 for triangles and quads, 3 for volumes.
int dimension(CellType type);
// meshio's name, for example "hexahedron20".
std::string_view name(CellType type);
// Raises ArgumentError when no type has this name.
CellType cell_type(std::string_view name);

// All cells of one type: nodes of cell c are nodes[c * k] ... nodes[c * k + k - 1], 0-based.
struct CellBlock {
    CellType type;
    Array<std::int32_t> nodes;
    [[nodiscard]] std::size_t size() const {
        return nodes.size() / static_cast<std::size_t>(node_count(type));
    }
};

// A named set: cell numbers in the block of `type`, or node numbers when on_nodes.
struct Group {
    bool on_nodes = true;
    CellType type = CellType::line;
    std::vector<std::int32_t> indices;
};

struct Mesh {
    Array<Vec3> points;
    std::vector<CellBlock> cells; // at most one block a type
    std::map<std::string, Group> groups;
};

} // namespace nmgs
