// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/mesh.h"

#include "nmgs/support/error.h"

namespace nmgs {
namespace {

struct TypeRow {
    CellType type;
    std::string_view name;
    int nodes;
    int dimension;
};

constexpr TypeRow type_rows[] = {
    {CellType::line, "line", 2, 1},
    {CellType::line3, "line3", 3, 1},
    {CellType::triangle, "triangle", 3, 2},
    {CellType::triangle6, "triangle6", 6, 2},
    {CellType::quad, "quad", 4, 2},
    {CellType::quad8, "quad8", 8, 2},
    {CellType::tetra, "tetra", 4, 3},
    {CellType::tetra10, "tetra10", 10, 3},
    {CellType::pyramid, "pyramid", 5, 3},
    {CellType::pyramid13, "pyramid13", 13, 3},
    {CellType::wedge, "wedge", 6, 3},
    {CellType::wedge15, "wedge15", 15, 3},
    {CellType::hexahedron, "hexahedron", 8, 3},
    {CellType::hexahedron20, "hexahedron20", 20, 3},
};

const TypeRow &row(CellType type) {
    return type_rows[static_cast<std::size_t>(type)];
}

} // namespace

int node_count(CellType type) {
    return row(type).nodes;
}
int dimension(CellType type) {
    return row(type).dimension;
}
std::string_view name(CellType type) {
    return row(type).name;
}

CellType cell_type(std::string_view name) {
    for (const TypeRow &r : type_rows) {
        if (r.name == name) {
            return r.type;
        }
    }
    throw ArgumentError("cell type: no such type '" + std::string(name) + "'");
}

} // namespace nmgs
