// SPDX-License-Identifier: LGPL-2.1-or-later
#include "errors.h"

#include "nmgs/support/error.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <new>

namespace py = pybind11;

namespace nmgs::bindings {
namespace {

template <class... Args>
void raise(const char *type, const Args &...args) {
    try {
        const py::object error =
            py::module_::import("freecad.NMGSWorkbench.nmgs.errors").attr(type)(args...);
        PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
    } catch (py::error_already_set &failure) {
        failure.restore();
    }
}

} // namespace

void register_errors() {
    // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11's signature.
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) {
                std::rethrow_exception(pointer);
            }
        } catch (const FormatError &e) {
            raise("FormatError", std::string(e.what()), e.path, e.line);
        } catch (const GeometryError &e) {
            raise("GeometryError", std::string(e.what()), e.entities);
        } catch (const BlockingError &e) {
            raise("BlockingError", std::string(e.what()), e.entities, e.reasons);
        } catch (const Cancelled &e) {
            raise("Cancelled", std::string(e.what()));
        } catch (const Error &e) {
            raise("Error", std::string(e.what()));
        } catch (const std::filesystem::filesystem_error &e) {
            // OSError picks FileNotFoundError, PermissionError, ... by the number.
            const py::object error = py::reinterpret_borrow<py::object>(PyExc_OSError)(
                e.code().value(), e.code().message(), e.path1().string());
            PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
        } catch (const std::bad_alloc &) {
            PyErr_SetString(PyExc_MemoryError, "not enough memory");
        }
    });
}

} // namespace nmgs::bindings
