// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids of revolution: cylinders, cones, balls, shells, tori, and turned parts of any profile.
#pragma once

#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// For solids all of whose faces are surfaces of revolution about one axis, whatever their kind. The
// profile is laid out in quads and turned about the axis; along the axis runs a core of an O-grid.
bool fill_primitive(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                    Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
