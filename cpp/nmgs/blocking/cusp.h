// SPDX-License-Identifier: LGPL-2.1-or-later
// Patches that end in a cusp.
#pragma once

#include "nmgs/support/vec3.h"

#include <span>

namespace nmgs {

// Whether two sides of an 8-node patch leave one of its corners in about the same direction, though
// its corners are apart: undivided it is a good quad, and the finer it is divided, the nearer the
// angle there comes to nothing. nodes: eight, corners first.
bool ends_in_cusp(std::span<const Vec3> nodes);

} // namespace nmgs
