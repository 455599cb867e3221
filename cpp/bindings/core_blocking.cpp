// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"
#include "block_model.h"
#include "core.h"
#include "mesh.h"

#include "nmgs/blocking/generate.h"
#include "nmgs/support/parallel.h"

namespace nmgs::bindings {
namespace {

py::dict generate_mesh(const DoubleArray &nodes, const IntArray &divisions,
                       const py::object &spacing, double tolerance, bool ignore_conflicts,
                       const py::object &progress) {
    const BlockModel model = block_model_of(nodes, divisions, spacing);
    Mesh mesh;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        mesh = generate(model, {tolerance, ignore_conflicts}, listener);
    }
    return give_mesh(std::move(mesh));
}

} // namespace

void bind_blocking(py::module_ &module) {
    module.def("set_threads", &set_threads, py::arg("count"),
               "Threads of the kernel; 0 for as many as the machine has.");
    module.def("generate", &generate_mesh, py::arg("nodes"), py::arg("divisions"),
               py::arg("spacing") = py::none(), py::arg("tolerance") = -1.0,
               py::arg("ignore_conflicts") = false, py::arg("progress") = py::none(),
               "Structured mesh of blocks: {'points': (N, 3), 'cells': {name: (M, k)}}.");
}

} // namespace nmgs::bindings
