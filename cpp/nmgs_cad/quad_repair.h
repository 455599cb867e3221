// SPDX-License-Identifier: LGPL-2.1-or-later
// Mends the worst quads over a face, one after the other.
#pragma once

#include "nmgs_cad/face_mesh.h"

#include <array>
#include <cstdint>
#include <set>

namespace nmgs::cad {

// For each quad with a corner whose sine is below `good`, the worst first: rotates its edges,
// closes it, opens its nodes, or wraps it (and one that is beside it) in a ring of quads, smooths
// what is near, and keeps the change that leaves least below `good`, if one does. A quad
// whose corner is the boundary's own straight line is cured like that: wrapped, it has a node
// inside instead. The boundary stays, and so do the edges that are kept (ends ascending). Wrapping
// is after S. A. Mitchell, T. J. Tautges, Pillowing doublets, 1995.
void repair_quads(FaceMesh &mesh, const FaceSurface &surface,
                  const std::set<std::array<std::int32_t, 2>> &kept, double good);

} // namespace nmgs::cad
