// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cad_cuts.h"

#include "nmgs_cad/cut_list.h"

#include <pybind11/stl.h>

#include <stdexcept>

namespace nmgs::bindings {
namespace {

namespace py = pybind11;

// [(name, entities, resolves, origin, direction, radius)] of a solid, from 1.
py::list cut_list(const cad::CadShape &shape, int solid) {
    if (solid < 1 || solid > shape.solids.Extent()) {
        throw py::value_error("solid: expected 1 to " + std::to_string(shape.solids.Extent()) +
                              ", got " + std::to_string(solid));
    }
    std::vector<cad::CutFigures> cuts;
    {
        const py::gil_scoped_release release;
        cuts = cad::cut_list(shape, solid);
    }
    py::list result;
    const auto triple = [](Vec3 v) { return py::make_tuple(v.x, v.y, v.z); };
    for (const auto &cut : cuts) {
        result.append(py::make_tuple(cut.name, cut.entities, cut.resolves, triple(cut.origin),
                                     triple(cut.direction), cut.radius));
    }
    return result;
}

} // namespace

void bind_cuts(py::module_ &module) {
    module.def("cut_list", &cut_list, py::arg("shape"), py::arg("solid"));
}

} // namespace nmgs::bindings
