// SPDX-License-Identifier: LGPL-2.1-or-later
// The mapped strategy: a solid with six four-sided faces is one block.
#pragma once

#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// One block for a solid with six faces of four sides each. xi, eta, zeta run along x, y, z as
// nearly as can be.
bool fill_mapped(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
