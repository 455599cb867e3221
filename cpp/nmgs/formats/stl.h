// SPDX-License-Identifier: LGPL-2.1-or-later
// Stereolithography's .stl, as text and binary: triangles without a common point.
#pragma once

#include "nmgs/plc/plc.h"

#include <string>

namespace nmgs {

// Every triangle becomes a facet with three points of its own, in the file's order. Text or binary
// is told by the size: a binary file may begin with "solid" too.
// Raises FormatError (in binary files the line is 0), filesystem_error.
Plc read_stl(const std::string &path);

// Triangles only, else ArgumentError. Binary files hold single precision.
void write_stl(const std::string &path, const Plc &plc, bool binary = true);

} // namespace nmgs
