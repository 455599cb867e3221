// SPDX-License-Identifier: LGPL-2.1-or-later
// Takes hexahedra that fill a solid into a layout: finds by place what their boundary lies on.
#pragma once

#include "nmgs_cad/layout.h"
#include "nmgs_cad/refusal.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace nmgs::cad {

// Hexahedra by their points' numbers, from 0, in the thesis's order of corners. middles: of edges
// between two points, ascending, that are not straight; of each edge on the boundary that is not
// straight they must be given, and lie on the CAD.
struct HexaMesh {
    std::vector<Vec3> points;
    std::vector<std::array<std::int32_t, 8>> hexas;
    std::map<std::array<std::int32_t, 2>, Vec3> middles;
};

// Adds the hexahedra as those of the solid; inside-out ones are turned. Points on entities that are
// laid out already must be there already. False, a reason, and the layout as it was: the boundary
// does not lie on the solid's faces, leaves a vertex, edge or face out, or is not as it is laid out
// already.
bool add_hexas(const CadShape &shape, int solid, const HexaMesh &mesh, Layout &layout,
               Refusal &refusal);

} // namespace nmgs::cad
