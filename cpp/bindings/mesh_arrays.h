// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "arrays.h"

#include "nmgs/mesh/cell_topology.h"

#include <string>
#include <utility>
#include <vector>

namespace nmgs::bindings {

// The cells of a Python mesh, {name: (M, k)}, viewed; the arrays stay alive with this.
struct CellArrays {
    std::vector<IntArray> arrays;
    std::vector<CellView> views;
};

inline CellArrays cell_arrays_of(const py::dict &cells) {
    CellArrays result;
    for (const auto &[key, value] : cells) {
        const auto name = key.cast<std::string>();
        const CellType type = cell_type(name);
        result.arrays.push_back(value.cast<IntArray>());
        result.views.push_back({type, cells_of(result.arrays.back(), node_count(type),
                                               ("cells['" + name + "']").c_str())});
    }
    return result;
}

inline py::dict give_blocks(std::vector<CellBlock> &&blocks) {
    py::dict result;
    for (CellBlock &block : blocks) {
        result[py::str(std::string(name(block.type)))] =
            give_cells(std::move(block.nodes), node_count(block.type));
    }
    return result;
}

} // namespace nmgs::bindings
