// SPDX-License-Identifier: LGPL-2.1-or-later
// TetGen's .node: points with attributes and markers (TetGen manual 5.2.1).
#pragma once

#include "nmgs/plc/plc.h"
#include "nmgs/support/text_buffer.h"
#include "nmgs/support/text_reader.h"

#include <string>

namespace nmgs {

// Points of a .node file, or of the first part of a .poly or .smesh file; `first` becomes the
// number of its first point, 0 or 1. Raises FormatError.
void read_points(TextReader &reader, Plc &plc, std::int32_t &first);

// The points of a .node file, in a PLC without facets. Raises FormatError, filesystem_error.
Plc read_node(const std::string &path, std::int32_t *first = nullptr);

// Header and points in the shortest form that reads back to the same numbers; numbers from `first`.
void write_node(const std::string &path, const Plc &plc, std::int32_t first = 1);

// One line of a .node file, as it is also in a .poly file.
void add_point_line(TextBuffer &text, const Plc &plc, std::size_t point, std::int32_t first);

} // namespace nmgs
