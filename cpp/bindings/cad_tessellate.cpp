// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cad_tessellate.h"

#include "arrays.h"

#include "nmgs_cad/tessellate.h"

namespace nmgs::bindings {
namespace {

py::dict tessellation(const cad::CadShape &shape, double deviation, double angle,
                      const py::object &progress) {
    cad::Tessellation mesh;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        mesh = cad::tessellate(shape, deviation, angle, listener);
    }
    py::dict result;
    result["points"] = table<double>(mesh.points);
    result["triangles"] = table<std::int32_t>(mesh.triangles);
    const auto count = static_cast<py::ssize_t>(mesh.faces.size());
    result["faces"] = give(std::move(mesh.faces), {count});
    result["solid_points"] = table<double>(mesh.solid_points);
    result["void_points"] = table<double>(mesh.void_points);
    return result;
}

} // namespace

void bind_tessellate(py::module_ &module) {
    module.def("tessellate", &tessellation, py::arg("shape"), py::arg("deviation"),
               py::arg("angle") = 0.5, py::arg("progress") = py::none(),
               "Closed triangulation of all faces, a point in each solid and in each cavity.");
}

} // namespace nmgs::bindings
