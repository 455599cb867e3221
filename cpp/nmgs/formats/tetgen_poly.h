// SPDX-License-Identifier: LGPL-2.1-or-later
// TetGen's .poly and .smesh: a PLC whole (TetGen manual 5.2.2, 5.2.3). A .smesh has one polygon a
// facet and no holes in facets.
#pragma once

#include "nmgs/plc/plc.h"

#include <string>

namespace nmgs {

enum class PolyKind { poly, smesh };

// Where the file says that it has no points, they come from the .node file of the same name.
// Raises FormatError with file and line, filesystem_error.
Plc read_poly(const std::string &path, PolyKind kind);

// Numbers from `first`. Raises ArgumentError when a .smesh cannot hold a facet.
void write_poly(const std::string &path, const Plc &plc, PolyKind kind, std::int32_t first = 1);

} // namespace nmgs
