// SPDX-License-Identifier: LGPL-2.1-or-later
// NumPy arrays in and out of the kernel. Inputs are C-contiguous arrays whose memory is viewed;
// outputs own the kernel's memory through a capsule: neither way copies.
#pragma once

#include "nmgs/mesh/mesh.h"
#include "nmgs/support/progress.h"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>

#include <cstring>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace nmgs::bindings {

namespace py = pybind11;

using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using IntArray = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

template <class A>
std::string shape_text(const A &array) {
    std::string text = "(";
    for (py::ssize_t d = 0; d < array.ndim(); ++d) {
        text += (d > 0 ? ", " : "") + std::to_string(array.shape(d));
    }
    return text + ")";
}

// The (N, 3) array as N points; raises ValueError that names the argument.
inline std::span<const Vec3> points_of(const DoubleArray &array, const char *argument = "points") {
    if (array.ndim() < 2 || array.shape(array.ndim() - 1) != 3) {
        throw py::value_error(std::string(argument) + ": expected shape (..., 3), got " +
                              shape_text(array));
    }
    // Vec3 is three doubles without padding (static_assert beside it).
    return {reinterpret_cast<const Vec3 *>(array.data()),
            static_cast<std::size_t>(array.size() / 3)};
}

// The (M, k) array as M * k node numbers; raises ValueError that names the argument.
inline std::span<const std::int32_t> cells_of(const IntArray &array, int k, const char *argument) {
    if (array.ndim() != 2 || array.shape(1) != k) {
        throw py::value_error(std::string(argument) + ": expected shape (M, " + std::to_string(k) +
                              "), got " + shape_text(array));
    }
    return {array.data(), static_cast<std::size_t>(array.size())};
}

// Moves values into an array of the given shape; T is read as consecutive scalars.
template <class Scalar, class T>
py::array_t<Scalar> give(Array<T> &&values, std::vector<py::ssize_t> shape) {
    auto owner = std::make_unique<Array<T>>(std::move(values));
    auto *data = reinterpret_cast<Scalar *>(owner->data());
    const py::capsule capsule(owner.release(), [](void *memory) {
        const std::unique_ptr<Array<T>> end(static_cast<Array<T> *>(memory));
    });
    return py::array_t<Scalar>(std::move(shape), data, capsule);
}

template <class T>
py::array_t<T> give(std::vector<T> &&values, std::vector<py::ssize_t> shape) {
    auto owner = std::make_unique<std::vector<T>>(std::move(values));
    T *data = owner->data();
    const py::capsule capsule(owner.release(), [](void *memory) {
        const std::unique_ptr<std::vector<T>> end(static_cast<std::vector<T> *>(memory));
    });
    return py::array_t<T>(std::move(shape), data, capsule);
}

inline py::array_t<double> give_points(Array<Vec3> &&points) {
    const auto n = static_cast<py::ssize_t>(points.size());
    return give<double>(std::move(points), {n, 3});
}

inline py::array_t<std::int32_t> give_cells(Array<std::int32_t> &&nodes, int k) {
    const auto n = static_cast<py::ssize_t>(nodes.size());
    return give<std::int32_t>(std::move(nodes), {n / k, k});
}

// A Python callable (fraction) -> bool | None as the kernel's Progress; None or no answer goes on,
// False stops, and so does an exception, which then reaches the caller. Without a callable the
// interpreter's signals are still looked at, so Ctrl-C works.
inline Progress progress_of(const py::object &callable) {
    return [callable](double fraction) {
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
        if (callable.is_none()) {
            return true;
        }
        const py::object answer = callable(fraction);
        return answer.is_none() || answer.cast<bool>();
    };
}

// A copy of rows as an array (N, Scalars a row).
template <class Scalar, class T>
py::array_t<Scalar> table(const std::vector<T> &rows) {
    // NOLINTNEXTLINE(bugprone-sizeof-expression): rows may be single numbers, of one column.
    constexpr auto columns = static_cast<py::ssize_t>(sizeof(T) / sizeof(Scalar));
    py::array_t<Scalar> array({static_cast<py::ssize_t>(rows.size()), columns});
    if (!rows.empty()) {
        std::memcpy(array.mutable_data(), rows.data(), rows.size() * sizeof(T));
    }
    return array;
}

} // namespace nmgs::bindings
