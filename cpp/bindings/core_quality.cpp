// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core.h"
#include "mesh_arrays.h"

#include "nmgs/quality/quality.h"

namespace nmgs::bindings {
namespace {

py::dict quality_of(const DoubleArray &points, const py::dict &cells, const std::string &name_of,
                    const py::object &progress) {
    const auto p = points_of(points);
    const CellArrays input = cell_arrays_of(cells);
    const Metric metric = metric_of(name_of);
    py::dict result;
    const Progress listener = progress_of(progress);
    for (const CellView &view : input.views) {
        if (!has_metric(view.type, metric)) {
            continue;
        }
        Array<double> values;
        {
            const py::gil_scoped_release release;
            values = quality(p, view, metric, listener);
        }
        const auto count = static_cast<py::ssize_t>(values.size());
        result[py::str(std::string(name(view.type)))] = give<double>(std::move(values), {count});
    }
    return result;
}

py::dict metric_table() {
    py::dict result;
    for (const MetricRow &row : metrics()) {
        result[py::str(std::string(row.name))] = row.larger_is_better;
    }
    return result;
}

} // namespace

void bind_quality(py::module_ &module) {
    module.def("quality", &quality_of, py::arg("points"), py::arg("cells"), py::arg("metric"),
               py::arg("progress") = py::none(),
               "{name: float64 (M,)} for the cell types for which the metric is defined.");
    module.def("metrics", &metric_table, "{metric: whether larger is better}.");
}

} // namespace nmgs::bindings
