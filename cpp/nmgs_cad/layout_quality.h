// SPDX-License-Identifier: LGPL-2.1-or-later
// How good the mesh will be that a layout leads to, measured on a mesh made from it.
#pragma once

#include "nmgs_cad/layout.h"

namespace nmgs::cad {

struct LayoutQuality {
    double worst = -1; // scaled Jacobian (Verdict's) of the worst hexahedron
    double volume = 0; // of the mesh
};

// Meshes the blocks of the layout's hexahedra from number `first` on, each with the given divisions
// along every direction, nodes on the CAD. -1 where no mesh can be made.
LayoutQuality layout_quality(const CadShape &shape, const Layout &layout, std::size_t first = 0,
                             int divisions = 3);

} // namespace nmgs::cad
