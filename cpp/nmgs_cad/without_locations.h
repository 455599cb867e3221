// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes whose parts are not placed: their curves and surfaces lie where they are.
#pragma once

#include "nmgs_cad/cad_shape.h"

namespace nmgs::cad {

// The same parts with the same numbers, their placements applied to their curves and surfaces:
// OpenCASCADE multiplies placements whenever it looks at a part that has one, which takes as long
// as all else. The shape as it is where that cannot be done.
CadShape without_locations(const CadShape &shape);

} // namespace nmgs::cad
