// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "arrays.h"

#include "nmgs/plc/plc.h"

namespace nmgs::bindings {

// The arrays of a Plc under the names of the Python class's attributes; those that have no rows
// and may be absent are None.
py::dict give_plc(Plc &&plc);

// A Plc from the Python class's attributes. Raises ValueError that names the array.
Plc plc_of(const py::object &source);

} // namespace nmgs::bindings
