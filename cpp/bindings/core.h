// SPDX-License-Identifier: LGPL-2.1-or-later
// One function a room of cpp/nmgs, each in core_<room>.cpp.
#pragma once

#include <pybind11/pybind11.h>

namespace nmgs::bindings {

void bind_blocking(pybind11::module_ &module);
void bind_plc(pybind11::module_ &module);
void bind_formats(pybind11::module_ &module);
void bind_convert(pybind11::module_ &module);
void bind_mesh(pybind11::module_ &module);
void bind_quality(pybind11::module_ &module);

} // namespace nmgs::bindings
