// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "arrays.h"

#include "nmgs/blocking/block_model.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

namespace nmgs::bindings {

// nodes (NE, 8 | 20, 3), divisions (NE, 2 | 3), spacing None or a sequence of NE * (2 | 3) arrays
// of positions, each empty or None where uniform. corners None or (NE, 4 | 8), see BlockModel.
// Raises ValueError naming the argument.
inline BlockModel block_model_of(const DoubleArray &nodes, const IntArray &divisions,
                                 const py::object &spacing,
                                 const std::optional<IntArray> &corners = std::nullopt) {
    if (nodes.ndim() != 3 || nodes.shape(2) != 3 || (nodes.shape(1) != 8 && nodes.shape(1) != 20)) {
        throw py::value_error("nodes: expected shape (NE, 8, 3) or (NE, 20, 3), got " +
                              shape_text(nodes));
    }
    BlockModel model;
    model.dimension = nodes.shape(1) == 8 ? 2 : 3;
    if (divisions.ndim() != 2 || divisions.shape(1) != model.dimension ||
        divisions.shape(0) != nodes.shape(0)) {
        throw py::value_error("divisions: expected shape (" + std::to_string(nodes.shape(0)) +
                              ", " + std::to_string(model.dimension) + "), got " +
                              shape_text(divisions));
    }
    const auto points = points_of(nodes, "nodes");
    model.nodes.assign(points.begin(), points.end());
    const auto view = divisions.unchecked<2>();
    for (py::ssize_t e = 0; e < view.shape(0); ++e) {
        model.divisions.push_back({view(e, 0), view(e, 1), model.dimension == 3 ? view(e, 2) : 0});
    }
    if (!spacing.is_none()) {
        for (const py::handle item : spacing) {
            model.spacing.push_back(item.is_none() ? std::vector<double>()
                                                   : item.cast<std::vector<double>>());
        }
    }
    if (corners) {
        if (corners->ndim() != 2 || corners->shape(0) != nodes.shape(0) ||
            corners->shape(1) != model.corners_per_element()) {
            throw py::value_error("corners: expected shape (" + std::to_string(nodes.shape(0)) +
                                  ", " + std::to_string(model.corners_per_element()) + "), got " +
                                  shape_text(*corners));
        }
        model.corners.assign(corners->data(), corners->data() + corners->size());
    }
    return model;
}

// A model as {'nodes': (NE, 8 | 20, 3), 'divisions': (NE, 2 | 3), 'spacing': [positions or None]}.
inline py::dict give_model(BlockModel &&model) {
    const auto elements = static_cast<py::ssize_t>(model.size());
    py::list spacing;
    for (std::size_t at = 0; at < model.size() * static_cast<std::size_t>(model.dimension); ++at) {
        if (at < model.spacing.size() && !model.spacing[at].empty()) {
            const auto n = static_cast<py::ssize_t>(model.spacing[at].size());
            spacing.append(give(std::move(model.spacing[at]), {n}));
        } else {
            spacing.append(py::none());
        }
    }
    std::vector<std::int32_t> divisions;
    for (const auto &g : model.divisions) {
        divisions.insert(divisions.end(), g.begin(), g.begin() + model.dimension);
    }
    Array<Vec3> nodes(model.nodes.size());
    std::copy(model.nodes.begin(), model.nodes.end(), nodes.begin());
    py::dict result;
    result["nodes"] = give<double>(std::move(nodes), {elements, model.nodes_per_element(), 3});
    result["divisions"] = give(std::move(divisions), {elements, model.dimension});
    result["spacing"] = spacing;
    return result;
}

} // namespace nmgs::bindings
