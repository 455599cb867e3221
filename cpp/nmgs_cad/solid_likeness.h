// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that look the same, so that what is found out about one need not be found out again.
#pragma once

#include "nmgs_cad/cad_shape.h"

#include <array>

namespace nmgs::cad {

// What turning, mirroring and moving a solid leave alone: how many faces, edges and vertices it
// has, its volume, the sums of its faces' areas and of their squares, the same of its edges'
// lengths, and of the distances of its vertices from its centre.
struct SolidLikeness {
    std::array<int, 3> count{};
    std::array<double, 7> size{};
};

SolidLikeness likeness_of(const CadShape &shape, int solid);

// Whether all of it is the same, to a millionth.
bool alike(const SolidLikeness &a, const SolidLikeness &b);

} // namespace nmgs::cad
