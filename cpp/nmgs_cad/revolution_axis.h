// SPDX-License-Identifier: LGPL-2.1-or-later
// The axis about which a solid's faces are surfaces of revolution.
#pragma once

#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/refusal.h"

#include <gp_Ax2.hxx>

#include <optional>
#include <vector>

namespace nmgs::cad {

struct RevolutionAxis {
    gp_Ax2 frame;               // angles are measured from its X direction, about its axis
    std::vector<double> angles; // in [0, 2 pi), ascending: of vertices and edges along the axis
    bool poles = false;         // a vertex lies on the axis
};

// Nothing and why: no axis fits all faces, or an edge runs neither round the axis nor in a plane
// through it.
std::optional<RevolutionAxis> revolution_axis(const CadShape &shape, int solid, Refusal &refusal);

} // namespace nmgs::cad
