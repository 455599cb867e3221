// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"
#include "block_model.h"
#include "core.h"
#include "mesh.h"

#include "nmgs/blocking/block_check.h"
#include "nmgs/blocking/default_divisions.h"
#include "nmgs/blocking/divisions.h"
#include "nmgs/blocking/generate.h"
#include "nmgs/blocking/grading.h"
#include "nmgs/support/parallel.h"

#include <optional>
#include <tuple>

namespace nmgs::bindings {
namespace {

py::dict generate_mesh(const DoubleArray &nodes, const IntArray &divisions,
                       const py::object &spacing, double tolerance, bool force,
                       const py::object &progress, const std::optional<IntArray> &corners) {
    const BlockModel model = block_model_of(nodes, divisions, spacing, corners);
    Mesh mesh;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        mesh = generate(model, {tolerance, force}, listener);
    }
    return give_mesh(std::move(mesh));
}

// Each as (kind, block, other block or -1, (x, y, z), text); blocks from 0 on.
py::list check_model(const DoubleArray &nodes, const IntArray &divisions, const py::object &spacing,
                     double tolerance, const std::optional<IntArray> &corners) {
    const BlockModel model = block_model_of(nodes, divisions, spacing, corners);
    std::vector<BlockProblem> problems;
    {
        const py::gil_scoped_release release;
        validate(model);
        problems = check_blocks(model, find_topology(model, tolerance));
    }
    py::list result;
    for (const BlockProblem &p : problems) {
        result.append(py::make_tuple(name(p.kind), p.block_a, p.block_b,
                                     py::make_tuple(p.place.x, p.place.y, p.place.z), p.text));
    }
    return result;
}

// {'chain': (NE, d), 'reversed': (NE, d), 'twisted': (C,), 'length': (NE, d) mean arc lengths}.
py::dict chains(const DoubleArray &nodes, const IntArray &divisions, double tolerance,
                const std::optional<IntArray> &corners) {
    const BlockModel model = block_model_of(nodes, divisions, py::none(), corners);
    validate(model);
    Chains found = find_chains(model, find_topology(model, tolerance));
    std::vector<double> lengths;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int d = 0; d < model.dimension; ++d) {
            lengths.push_back(direction_length(model, b, d).mean);
        }
    }
    const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(model.size()), model.dimension};
    py::dict result;
    result["chain"] = give(std::move(found.chain), shape);
    result["reversed"] =
        give(std::vector<std::int8_t>(found.reversed.begin(), found.reversed.end()), shape);
    result["twisted"] =
        give(std::vector<std::int8_t>(found.twisted.begin(), found.twisted.end()), {found.count});
    result["length"] = give(std::move(lengths), shape);
    return result;
}

// wishes: (block, direction, count, hard) each, blocks and directions from 0 on.
py::array_t<std::int32_t>
solve(const DoubleArray &nodes, const IntArray &divisions,
      const std::vector<std::tuple<std::int32_t, int, std::int32_t, bool>> &wishes, double size,
      double tolerance, const std::optional<IntArray> &corners) {
    const BlockModel model = block_model_of(nodes, divisions, py::none(), corners);
    validate(model);
    std::vector<DivisionWish> list;
    list.reserve(wishes.size());
    for (const auto &[block, direction, count, hard] : wishes) {
        list.push_back({block, direction, count, hard});
    }
    std::vector<std::int32_t> flat;
    for (const auto &g : solve_divisions(model, find_topology(model, tolerance), list, size)) {
        flat.insert(flat.end(), g.begin(), g.begin() + model.dimension);
    }
    return give(std::move(flat), {static_cast<py::ssize_t>(model.size()), model.dimension});
}

py::array_t<std::int32_t> divide_by_default(const DoubleArray &nodes, const IntArray &divisions,
                                            double size, const std::optional<IntArray> &corners,
                                            const IntArray &part,
                                            const std::vector<bool> &structured) {
    const BlockModel model = block_model_of(nodes, divisions, py::none(), corners);
    DefaultDivisions options;
    options.part.assign(part.data(), part.data() + part.size());
    options.structured.assign(structured.begin(), structured.end());
    std::vector<std::int32_t> flat;
    {
        const py::gil_scoped_release release;
        validate(model);
        for (const auto &g : default_divisions(model, find_topology(model), size, options)) {
            flat.insert(flat.end(), g.begin(), g.begin() + model.dimension);
        }
    }
    return give(std::move(flat), {static_cast<py::ssize_t>(model.size()), model.dimension});
}

py::array_t<double> grading_positions(const std::string &kind, std::int32_t count,
                                      std::optional<double> ratio, std::optional<double> first,
                                      std::optional<double> last, const DoubleArray &values,
                                      bool reverse) {
    std::vector<double> positions;
    if (kind == "geometric") {
        positions = ratio   ? grading::geometric(count, *ratio)
                    : first ? grading::geometric_first(count, *first)
                            : grading::geometric_last(count, last.value());
    } else if (kind == "two_sided") {
        positions = ratio ? grading::two_sided(count, *ratio)
                          : grading::two_sided(count, first.value(), last.value());
    } else if (kind == "tanh") {
        positions = first && last ? grading::tanh(count, *first, *last)
                    : first       ? grading::tanh_first(count, *first)
                                  : grading::reversed(grading::tanh_first(count, last.value()));
    } else {
        positions =
            grading::explicit_positions({values.data(), static_cast<std::size_t>(values.size())});
    }
    if (reverse) {
        positions = grading::reversed(positions);
    }
    const auto size = static_cast<py::ssize_t>(positions.size());
    return give(std::move(positions), {size});
}

} // namespace

void bind_blocking(py::module_ &module) {
    module.def("set_threads", &set_threads, py::arg("count"),
               "Threads of the kernel; 0 for as many as the machine has.");
    module.def("check", &check_model, py::arg("nodes"), py::arg("divisions"), py::arg("spacing"),
               py::arg("tolerance") = -1.0, py::arg("corners") = py::none(),
               "What is wrong with a model; see block_check.h.");
    module.def("chains", &chains, py::arg("nodes"), py::arg("divisions"),
               py::arg("tolerance") = -1.0, py::arg("corners") = py::none(),
               "Directions that need one count; see divisions.h.");
    module.def("solve_divisions", &solve, py::arg("nodes"), py::arg("divisions"), py::arg("wishes"),
               py::arg("size") = 0.0, py::arg("tolerance") = -1.0, py::arg("corners") = py::none(),
               "Divisions (NE, 2 | 3) that agree over the whole model; see divisions.h.");
    module.def("default_divisions", &divide_by_default, py::arg("nodes"), py::arg("divisions"),
               py::arg("size"), py::arg("corners") = py::none(), py::arg("part") = IntArray(),
               py::arg("structured") = std::vector<bool>(),
               "Divisions (NE, 2 | 3) by curvature and size; see default_divisions.h.");
    module.def("grading_positions", &grading_positions, py::arg("kind"), py::arg("count"),
               py::arg("ratio"), py::arg("first"), py::arg("last"), py::arg("values"),
               py::arg("reverse"), "Positions from 0 to 1 of a grading; see blocking/grading.h.");
    module.def("generate", &generate_mesh, py::arg("nodes"), py::arg("divisions"),
               py::arg("spacing") = py::none(), py::arg("tolerance") = -1.0,
               py::arg("force") = false, py::arg("progress") = py::none(),
               py::arg("corners") = py::none(),
               "Structured mesh of blocks: {'points': (N, 3), 'cells': {name: (M, k)}}.");
}

} // namespace nmgs::bindings
