// SPDX-License-Identifier: LGPL-2.1-or-later
// What neighbours have laid over a solid's edges and faces, carried over to its section.
#pragma once

#include "nmgs_cad/section.h"

namespace nmgs::cad {

// Levels along the direction of points inside edges that run along it and are laid out already.
std::vector<double> levels_of_neighbours(const CadShape &shape, int solid, Vec3 direction,
                                         double tolerance, const Layout &layout);

// Divides the section's edges as the solid's edges over them are divided, and takes the quads of
// caps over the section's faces. For sections along a direction.
void take_over(const CadShape &shape, int solid, const Section &section, const Layout &layout,
               Layout &flat);

} // namespace nmgs::cad
