// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cad_tets.h"

#include "arrays.h"

#include "nmgs_cad/skin.h"

#include <pybind11/stl.h>

#include <cstring>
#include <memory>

namespace nmgs::bindings {
namespace {

template <class Scalar, class T>
py::array_t<Scalar> table(const std::vector<T> &rows) {
    constexpr auto columns = static_cast<py::ssize_t>(sizeof(T) / sizeof(Scalar));
    py::array_t<Scalar> array({static_cast<py::ssize_t>(rows.size()), columns});
    if (!rows.empty()) {
        std::memcpy(array.mutable_data(), rows.data(), rows.size() * sizeof(T));
    }
    return array;
}

// limits: (N, 5) x, y, z, radius, size.
std::shared_ptr<cad::Skin> make_skin(const cad::CadShape &shape, const std::vector<int> &faces,
                                     double size, double angle, const DoubleArray &limits,
                                     const py::object &progress) {
    cad::SkinOptions options;
    options.size = size;
    options.angle = angle;
    if (limits.size() % 5 != 0) {
        throw py::value_error("limits: expected shape (N, 5), got " + shape_text(limits));
    }
    for (py::ssize_t i = 0; i < limits.size(); i += 5) {
        const double *row = limits.data() + i;
        options.limits.push_back({{row[0], row[1], row[2]}, row[3], row[4]});
    }
    const Progress listener = progress_of(progress);
    const py::gil_scoped_release release;
    return std::make_shared<cad::Skin>(cad::make_skin(shape, faces, options, listener));
}

} // namespace

void bind_tets(py::module_ &module) {
    py::class_<cad::Skin, std::shared_ptr<cad::Skin>>(
        module, "Skin", "Well-shaped triangles over CAD faces, points tagged with their entity.")
        .def_property_readonly("points", [](const cad::Skin &s) { return table<double>(s.points); })
        .def_property_readonly("on",
                               [](const cad::Skin &s) { return table<std::int32_t>(s.on); })
        .def_property_readonly("triangles",
                               [](const cad::Skin &s) { return table<std::int32_t>(s.triangles); })
        .def_property_readonly("faces",
                               [](const cad::Skin &s) {
                                   return table<std::int32_t>(s.faces).reshape({-1});
                               })
        .def_property_readonly("edges", [](const cad::Skin &s) { return s.edges; });
    module.def("make_skin", &make_skin, py::arg("shape"), py::arg("faces"), py::arg("size") = 0.0,
               py::arg("angle") = 0.45, py::arg("limits") = DoubleArray(),
               py::arg("progress") = py::none(), "Coarse triangles over faces that meet at edges.");
}

} // namespace nmgs::bindings
