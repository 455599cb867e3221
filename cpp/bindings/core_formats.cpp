// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"
#include "block_model.h"
#include "core.h"

#include "nmgs/formats/result_file.h"
#include "nmgs/formats/setup_file.h"

namespace nmgs::bindings {
namespace {

Numbering numbering_of(const std::string &name) {
    if (name != "corners-first" && name != "perimeter") {
        throw py::value_error("numbering: expected 'corners-first' or 'perimeter', got '" + name +
                              "'");
    }
    return name == "perimeter" ? Numbering::perimeter : Numbering::corners_first;
}

py::dict read_setup(const std::string &path, int dimension, const std::string &numbering) {
    const Numbering order = numbering_of(numbering);
    SetupFile file;
    {
        const py::gil_scoped_release release;
        file = read_setup_file(path, dimension, order);
    }
    py::dict result = give_model(std::move(file.model));
    result["reference"] = file.reference;
    return result;
}

void write_setup(const std::string &path, const DoubleArray &nodes, const IntArray &divisions,
                 const py::object &spacing, const std::string &reference) {
    const BlockModel model = block_model_of(nodes, divisions, spacing);
    const py::gil_scoped_release release;
    write_setup_file(path, model, reference);
}

py::dict read_result(const std::string &path, int dimension, const std::string &numbering,
                     const py::object &progress) {
    const Numbering order = numbering_of(numbering);
    ResultFile file;
    {
        const Progress listener = progress_of(progress);
        const py::gil_scoped_release release;
        file = read_result_file(path, dimension, order, listener);
    }
    py::dict result = give_model(std::move(file.model));
    result["reference"] = file.reference;
    result["points"] = give_points(std::move(file.points));
    result["cells"] = give_cells(std::move(file.cells), dimension == 3 ? 8 : 4);
    return result;
}

void write_result(const std::string &path, const DoubleArray &nodes, const IntArray &divisions,
                  const py::object &spacing, const std::string &reference,
                  const DoubleArray &points, const IntArray &cells, const py::object &progress) {
    const BlockModel model = block_model_of(nodes, divisions, spacing);
    const auto places = points_of(points);
    const auto numbers = cells_of(cells, model.dimension == 3 ? 8 : 4, "cells");
    const Progress listener = progress_of(progress);
    const py::gil_scoped_release release;
    write_result_file(path, model, reference, places, numbers, listener);
}

} // namespace

void bind_formats(py::module_ &module) {
    module.def("read_result", &read_result, py::arg("path"), py::arg("dimension"),
               py::arg("numbering"), py::arg("progress") = py::none(),
               "An N2R (dimension 2) or N3R (3) file: the model's dict with points and cells.");
    module.def("write_result", &write_result, py::arg("path"), py::arg("nodes"),
               py::arg("divisions"), py::arg("spacing"), py::arg("reference"), py::arg("points"),
               py::arg("cells"), py::arg("progress") = py::none(), "Writes an N2R or N3R file.");
    module.def("read_setup", &read_setup, py::arg("path"), py::arg("dimension"),
               py::arg("numbering"), "An N2S (dimension 2) or N3S (3) file as a model's dict.");
    module.def("write_setup", &write_setup, py::arg("path"), py::arg("nodes"), py::arg("divisions"),
               py::arg("spacing"), py::arg("reference"), "Writes an N2S or N3S file.");
}

} // namespace nmgs::bindings
