// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections of solids whose caps are not all across the sweep: chamfers, countersinks, slopes,
// domes.
#pragma once

#include "nmgs_cad/section.h"

namespace nmgs::cad {

// As section_along(), but a cap may be any face of which each line along the direction meets a part
// once. Caps that meet in edges make one level, which follows them.
bool section_over(const CadShape &shape, int solid, const gp_Dir &direction, const Layout &layout,
                  Section &section, Refusal &refusal);

} // namespace nmgs::cad
