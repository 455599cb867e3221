// SPDX-License-Identifier: LGPL-2.1-or-later
// The place inside a closed surface of triangles that sees all of them from inside.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <optional>
#include <span>

namespace nmgs {

// The point whose least distance to the planes of the triangles, positive on the side to which
// their normals point, is largest: the linear programme max t with n_i . (x - a_i) >= t, solved by
// trying all vertices. For a handful of triangles. None when no point is inside of all planes.
std::optional<Vec3> inner_point(std::span<const std::array<Vec3, 3>> triangles);

} // namespace nmgs
