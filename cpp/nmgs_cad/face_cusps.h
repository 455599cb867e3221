// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of faces at which two edges leave in the same direction.
#pragma once

#include "nmgs_cad/edge_sizes.h"

namespace nmgs::cad {

// Sets the lengths of the segments at cusps (EdgeSize::tip): the same on both edges, as short as
// the angle between the chords is wide enough for a good quad in the tip, or where it is widest. A
// corner between straight edges is no cusp, however sharp: there all lengths have one angle. Nor so
// long that the chords there take or leave more than 0.006 of the face's area. Whether the face has
// any.
bool size_cusps(const CadShape &shape, int face, const FaceLoops &loops, EdgeSizes &sizes);

// Sizes of a face with cusps as its final elements: what goes through the quad in a tip is not
// divided any further. longest: of a segment; turn: along it, in radians.
void size_as_elements(const FaceLoops &loops, EdgeSizes &sizes, double longest, double turn = 0.18);

} // namespace nmgs::cad
