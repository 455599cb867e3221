// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core.h"
#include "mesh_arrays.h"

#include "nmgs/mesh/boundary.h"
#include "nmgs/mesh/related_nodes.h"

namespace nmgs::bindings {
namespace {

py::tuple related(std::size_t points, const py::dict &cells, const py::object &progress) {
    const CellArrays input = cell_arrays_of(cells);
    RelatedNodes result;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        result = related_nodes(points, input.views, listener);
    }
    const auto rows = static_cast<py::ssize_t>(result.offsets.size());
    const auto count = static_cast<py::ssize_t>(result.neighbours.size());
    return py::make_tuple(give<std::int64_t>(std::move(result.offsets), {rows}),
                          give<std::int32_t>(std::move(result.neighbours), {count}));
}

py::dict outer(std::size_t points, const py::dict &cells, const py::object &progress) {
    const CellArrays input = cell_arrays_of(cells);
    std::vector<BoundaryBlock> blocks;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        blocks = boundary(points, input.views, listener);
    }
    py::dict result;
    for (BoundaryBlock &block : blocks) {
        const auto count = static_cast<py::ssize_t>(block.cells.size());
        result[py::str(std::string(name(block.type)))] =
            py::make_tuple(give_cells(std::move(block.nodes), node_count(block.type)),
                           give<std::int32_t>(std::move(block.blocks), {count}),
                           give<std::int32_t>(std::move(block.cells), {count}));
    }
    return result;
}

} // namespace

void bind_mesh(py::module_ &module) {
    module.def("related_nodes", &related, py::arg("points"), py::arg("cells"),
               py::arg("progress") = py::none(),
               "(offsets, neighbours) of nodes that an edge of a cell joins; points: how many.");
    module.def("boundary", &outer, py::arg("points"), py::arg("cells"),
               py::arg("progress") = py::none(),
               "{name: (nodes, block, cell)} of the outer faces, or of a surface's free edges.");
}

} // namespace nmgs::bindings
