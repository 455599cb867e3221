// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cad_refit.h"

#include "arrays.h"
#include "block_model.h"
#include "mesh.h"

#include "nmgs_cad/refit.h"

namespace nmgs::bindings {
namespace {

// (nodes, [(error, place)]) of the ranges of blocks.
py::tuple refit(const cad::CadShape &before, const cad::CadShape &after, const DoubleArray &nodes,
                const IntArray &divisions, const IntArray &offsets, const IntArray &entities,
                const std::vector<std::array<std::int32_t, 2>> &ranges,
                const py::object &progress) {
    cad::CadBlocks blocks;
    blocks.model = block_model_of(nodes, divisions, py::none());
    blocks.binding.offsets.assign(offsets.data(), offsets.data() + offsets.size());
    const auto view = entities.unchecked<2>();
    for (py::ssize_t e = 0; e < view.shape(0); ++e) {
        blocks.binding.entities.push_back({view(e, 0), view(e, 1)});
    }
    for (const auto &[first, count] : ranges) {
        cad::FitEntry entry;
        entry.method = "refit";
        entry.first_block = first;
        entry.blocks = count;
        blocks.report.push_back(entry);
    }
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        blocks = cad::refit(before, after, blocks, listener);
    }
    py::list errors;
    for (const auto &entry : blocks.report) {
        errors.append(py::make_tuple(
            entry.error, py::make_tuple(entry.place[0], entry.place[1], entry.place[2])));
    }
    return py::make_tuple(give_model(std::move(blocks.model))["nodes"], errors);
}

} // namespace

void bind_refit(py::module_ &module) {
    module.def("refit", &refit, py::arg("before"), py::arg("after"), py::arg("nodes"),
               py::arg("divisions"), py::arg("offsets"), py::arg("entities"), py::arg("ranges"),
               py::arg("progress") = py::none());
}

} // namespace nmgs::bindings
