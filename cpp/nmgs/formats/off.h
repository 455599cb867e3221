// SPDX-License-Identifier: LGPL-2.1-or-later
// Geomview's .off: points and polygons. Colours and normals are left out.
#pragma once

#include "nmgs/plc/plc.h"

#include <string>

namespace nmgs {

// Each polygon becomes a facet. Raises FormatError with file and line, filesystem_error.
Plc read_off(const std::string &path);

// Raises ArgumentError for a facet of several polygons or with holes.
void write_off(const std::string &path, const Plc &plc);

} // namespace nmgs
