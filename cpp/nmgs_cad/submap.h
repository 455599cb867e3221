// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills solids that can be taken for ones made of cubes: six logical sides of several faces each,
// and rectilinear solids with steps, slots, pockets and holes (submapping, as cited in
// logical_directions.h). Planes of the lattice go through the whole solid.
#pragma once

#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// See FillSolid. Curved sides, edges that were laid out before, and faces whose quads are a grid
// are kept; points inside faces and the solid come from Laplace's equation over the lattice.
bool fill_submap(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
