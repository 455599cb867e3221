// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrilaterals into triangles by the shorter diagonal (thesis 3.1.1).
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs/support/vec3.h"

#include <cstdint>
#include <span>

namespace nmgs {

// How equal diagonals are told apart: as the thesis does (nodes 2 and 4 are joined), or as the
// faces of volume cells do (see diagonal.h), so that both sides of a face and the quads on it
// agree.
enum class EqualDiagonals { second_and_fourth, lowest_node };

// quads: M * 4 nodes in [0, points.size()); triangles: M * 6. Quad q becomes triangles 2 q and
// 2 q + 1: nodes 1 2 4 and 3 4 2 where nodes 2 and 4 are joined, else 1 2 3 and 3 4 1.
void split_quads(std::span<const Vec3> points, std::span<const std::int32_t> quads,
                 EqualDiagonals rule, std::span<std::int32_t> triangles,
                 const Progress &progress = {}, double from = 0.0, double to = 1.0);

// The thesis's parameter TP of each quad: 1 where nodes 2 and 4 are joined, else 0.
void triangulation_parameters(std::span<const Vec3> points, std::span<const std::int32_t> quads,
                              EqualDiagonals rule, std::span<std::uint8_t> parameters,
                              const Progress &progress = {});

} // namespace nmgs
