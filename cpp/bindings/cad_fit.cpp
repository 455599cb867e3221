// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cad_fit.h"

#include "arrays.h"

#include "nmgs_cad/cad_shape.h"

#include <pybind11/stl.h>

namespace nmgs::bindings {
namespace {

py::dict entry_dict(const cad::FitEntry &entry) {
    py::dict d;
    d["entity"] = cad::entity_name(entry.entity.dimension, entry.entity.index);
    d["method"] = entry.method;
    d["reason"] = entry.reason;
    d["blockers"] = entry.blockers;
    d["first_block"] = entry.first_block;
    d["blocks"] = entry.blocks;
    d["error"] = entry.error;
    d["quality"] = entry.quality;
    d["place"] = py::make_tuple(entry.place[0], entry.place[1], entry.place[2]);
    return d;
}

} // namespace

py::dict fit_dict(cad::CadBlocks &&blocks) {
    py::list report;
    for (const auto &entry : blocks.report) {
        report.append(entry_dict(entry));
    }
    std::vector<double> nodes;
    for (const Vec3 &p : blocks.model.nodes) {
        nodes.insert(nodes.end(), {p.x, p.y, p.z});
    }
    std::vector<std::int32_t> entities;
    for (const auto &e : blocks.binding.entities) {
        entities.insert(entities.end(), {e.dimension, e.index});
    }
    const auto size = static_cast<py::ssize_t>(blocks.model.size());
    const auto offsets = static_cast<py::ssize_t>(blocks.binding.offsets.size());
    const auto count = static_cast<py::ssize_t>(blocks.binding.entities.size());
    py::dict result;
    result["nodes"] = give<double>(std::move(nodes), {size, blocks.model.nodes_per_element(), 3});
    result["offsets"] = give<std::int32_t>(std::move(blocks.binding.offsets), {offsets});
    result["entities"] = give<std::int32_t>(std::move(entities), {count, 2});
    if (blocks.model.corners.empty()) {
        result["corners"] = py::none();
    } else {
        const int corners = blocks.model.corners_per_element();
        result["corners"] = give<std::int32_t>(std::move(blocks.model.corners), {size, corners});
    }
    result["report"] = report;
    return result;
}

} // namespace nmgs::bindings
