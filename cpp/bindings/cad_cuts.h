// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace nmgs::bindings {

// cad.cut_list.
void bind_cuts(pybind11::module_ &module);

} // namespace nmgs::bindings
