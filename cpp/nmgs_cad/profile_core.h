// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts a strip along the axis off the profile of a turned part: the core of its O-grids.
#pragma once

#include "nmgs/support/vec3.h"
#include "nmgs_cad/refusal.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax2.hxx>

#include <functional>
#include <optional>
#include <vector>

namespace nmgs::cad {

// The line between the strip and the rest, from the low end of the axis to the high end. Where the
// profile's end is nearly flat the line runs straight into it; from a dome or a sharp cone it comes
// in at a right angle first, and then turns along the axis.
struct ProfileCore {
    std::vector<Vec3> line; // its corners, the first and the last on the profile's ends
    std::vector<Vec3> axis; // of each corner of the line: its partner on the axis
    TopoDS_Edge low, high;  // the profile's edges that leave the axis at its ends
};

// For each stretch of the axis that bounds the profile, a plane face in a half-plane of the axis.
// scale: of the strip's width.
std::vector<ProfileCore> profile_cores(const TopoDS_Face &profile, const gp_Ax1 &axis,
                                       double tolerance, double scale);

} // namespace nmgs::cad
