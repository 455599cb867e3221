// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"
#include "block_model.h"
#include "core.h"
#include "mesh.h"

#include "nmgs/blocking/block_check.h"
#include "nmgs/blocking/generate.h"
#include "nmgs/blocking/grading.h"
#include "nmgs/support/parallel.h"

#include <optional>

namespace nmgs::bindings {
namespace {

py::dict generate_mesh(const DoubleArray &nodes, const IntArray &divisions,
                       const py::object &spacing, double tolerance, bool force,
                       const py::object &progress) {
    const BlockModel model = block_model_of(nodes, divisions, spacing);
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
                     double tolerance) {
    const BlockModel model = block_model_of(nodes, divisions, spacing);
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
               py::arg("tolerance") = -1.0, "What is wrong with a model; see block_check.h.");
    module.def("grading_positions", &grading_positions, py::arg("kind"), py::arg("count"),
               py::arg("ratio"), py::arg("first"), py::arg("last"), py::arg("values"),
               py::arg("reverse"), "Positions from 0 to 1 of a grading; see blocking/grading.h.");
    module.def("generate", &generate_mesh, py::arg("nodes"), py::arg("divisions"),
               py::arg("spacing") = py::none(), py::arg("tolerance") = -1.0,
               py::arg("force") = false, py::arg("progress") = py::none(),
               "Structured mesh of blocks: {'points': (N, 3), 'cells': {name: (M, k)}}.");
}

} // namespace nmgs::bindings
