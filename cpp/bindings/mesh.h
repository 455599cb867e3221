// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "arrays.h"

namespace nmgs::bindings {

// {'points': (N, 3), 'cells': {name: (M, k)}, 'groups': {name: (cell name | 'node', indices)}}.
inline py::dict give_mesh(Mesh &&mesh) {
    py::dict cells;
    for (CellBlock &block : mesh.cells) {
        cells[py::str(std::string(name(block.type)))] =
            give_cells(std::move(block.nodes), node_count(block.type));
    }
    py::dict groups;
    for (auto &[key, group] : mesh.groups) {
        const std::string kind = group.on_nodes ? "node" : std::string(name(group.type));
        const auto size = static_cast<py::ssize_t>(group.indices.size());
        groups[py::str(key)] =
            py::make_tuple(kind, give<std::int32_t>(std::move(group.indices), {size}));
    }
    py::dict result;
    result["points"] = give_points(std::move(mesh.points));
    result["cells"] = cells;
    result["groups"] = groups;
    return result;
}

} // namespace nmgs::bindings
