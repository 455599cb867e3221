// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace nmgs::bindings {

// cad.Skin, cad.make_skin and cad.tets_to_hexas.
void bind_tets(pybind11::module_ &module);

} // namespace nmgs::bindings
