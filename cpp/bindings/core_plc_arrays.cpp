// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plc.h"

#include <cstring>

namespace nmgs::bindings {
namespace {

using LongArray = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

template <class Scalar, class T>
py::array_t<Scalar> copied(const std::vector<T> &values, py::ssize_t columns) {
    static_assert(sizeof(T) % sizeof(Scalar) == 0);
    // NOLINTNEXTLINE(bugprone-sizeof-expression): T and Scalar may be the same type.
    const auto scalars = static_cast<py::ssize_t>(values.size() * (sizeof(T) / sizeof(Scalar)));
    std::vector<py::ssize_t> shape{scalars / columns};
    if (columns > 1) {
        shape.push_back(columns);
    }
    py::array_t<Scalar> array(shape);
    if (!values.empty()) {
        std::memcpy(array.mutable_data(), values.data(), values.size() * sizeof(T));
    }
    return array;
}

template <class T>
py::object some(const std::vector<T> &values) {
    return values.empty() ? py::none() : py::object(copied<T>(values, 1));
}

template <class T, class Scalar>
std::vector<T> taken(const py::object &source, const char *name) {
    const py::object value = source.attr(name);
    if (value.is_none()) {
        return {};
    }
    const auto array =
        py::array_t<Scalar, py::array::c_style | py::array::forcecast>::ensure(value);
    if (!array) {
        throw py::error_already_set();
    }
    const auto bytes = static_cast<std::size_t>(array.nbytes());
    if (bytes % sizeof(T) != 0) {
        throw py::value_error(std::string(name) + ": wrong shape " + shape_text(array));
    }
    std::vector<T> values(bytes / sizeof(T));
    if (bytes > 0) {
        std::memcpy(static_cast<void *>(values.data()), array.data(), bytes);
    }
    return values;
}

void check_offsets(const std::vector<std::int64_t> &offsets, std::size_t total, const char *name) {
    bool good = !offsets.empty() && offsets.front() == 0 &&
                offsets.back() == static_cast<std::int64_t>(total);
    for (std::size_t i = 1; good && i < offsets.size(); ++i) {
        good = offsets[i - 1] <= offsets[i];
    }
    if (!good) {
        throw py::value_error(std::string(name) + ": expected ascending numbers from 0 to " +
                              std::to_string(total));
    }
}

} // namespace

py::dict give_plc(Plc &&plc) {
    py::dict arrays;
    arrays["points"] = copied<double>(plc.points, 3);
    arrays["point_markers"] = some(plc.point_markers);
    const auto k = static_cast<py::ssize_t>(plc.attribute_count);
    arrays["point_attributes"] =
        k == 0 ? py::none()
               : py::object(copied<double>(plc.point_attributes, k)
                                .reshape({static_cast<py::ssize_t>(plc.points.size()), k}));
    arrays["polygon_nodes"] = copied<std::int32_t>(plc.polygon_nodes, 1);
    arrays["polygon_offsets"] = copied<std::int64_t>(plc.polygon_offsets, 1);
    arrays["facet_offsets"] = copied<std::int64_t>(plc.facet_offsets, 1);
    arrays["markers"] = some(plc.facet_markers);
    arrays["facet_holes"] = copied<double>(plc.facet_holes, 3);
    arrays["facet_hole_offsets"] = copied<std::int64_t>(plc.facet_hole_offsets, 1);
    arrays["holes"] = copied<double>(plc.holes, 3);
    arrays["regions"] = copied<double>(plc.regions, 5);
    return arrays;
}

Plc plc_of(const py::object &source) {
    Plc plc;
    plc.points = taken<Vec3, double>(source, "points");
    plc.point_markers = taken<std::int32_t, std::int32_t>(source, "point_markers");
    plc.point_attributes = taken<double, double>(source, "point_attributes");
    if (!plc.points.empty()) {
        plc.attribute_count =
            static_cast<std::int32_t>(plc.point_attributes.size() / plc.points.size());
    }
    plc.polygon_nodes = taken<std::int32_t, std::int32_t>(source, "polygon_nodes");
    plc.polygon_offsets = taken<std::int64_t, std::int64_t>(source, "polygon_offsets");
    plc.facet_offsets = taken<std::int64_t, std::int64_t>(source, "facet_offsets");
    plc.facet_markers = taken<std::int32_t, std::int32_t>(source, "markers");
    plc.facet_holes = taken<Vec3, double>(source, "facet_holes");
    plc.facet_hole_offsets = taken<std::int64_t, std::int64_t>(source, "facet_hole_offsets");
    plc.holes = taken<Vec3, double>(source, "holes");
    plc.regions = taken<PlcRegion, double>(source, "regions");

    check_offsets(plc.polygon_offsets, plc.polygon_nodes.size(), "polygon_offsets");
    check_offsets(plc.facet_offsets, plc.polygon_offsets.size() - 1, "facet_offsets");
    check_offsets(plc.facet_hole_offsets, plc.facet_holes.size(), "facet_hole_offsets");
    if (plc.facet_hole_offsets.size() != plc.facet_offsets.size()) {
        throw py::value_error("facet_hole_offsets: expected one a facet and one more");
    }
    if (!plc.facet_markers.empty() && plc.facet_markers.size() != plc.facet_count()) {
        throw py::value_error("markers: expected " + std::to_string(plc.facet_count()));
    }
    if (!plc.point_markers.empty() && plc.point_markers.size() != plc.points.size()) {
        throw py::value_error("point_markers: expected " + std::to_string(plc.points.size()));
    }
    for (const std::int32_t node : plc.polygon_nodes) {
        if (node < 0 || static_cast<std::size_t>(node) >= plc.points.size()) {
            throw py::value_error("polygon_nodes: node " + std::to_string(node) +
                                  " is outside 0 to " + std::to_string(plc.points.size()) + " - 1");
        }
    }
    return plc;
}

} // namespace nmgs::bindings
