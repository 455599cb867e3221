// SPDX-License-Identifier: LGPL-2.1-or-later
// Sweeping from one face through rings of four-sided faces to another: lofts, bent pipes, sectors
// of revolutions, helical and bevel gears.
#pragma once

#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// The source face is laid out; its boundary is carried along the rings of faces, the inside by the
// affine map that fits the boundary best and a harmonic correction (Knupp, Next-generation sweep
// tool: a method for generating all-hex meshes on two-and-one-half dimensional geometries, 7th
// International Meshing Roundtable, 1998, for the affine part).
bool fill_loft(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
               Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
