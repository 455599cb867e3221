// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces between two loops: a ring of quads.
#pragma once

#include "nmgs_cad/face_mesh.h"
#include "nmgs_cad/refusal.h"

#include <optional>

namespace nmgs::cad {

// Joins the nodes of two loops with equal numbers of segments, turned so that the joints are
// shortest; more than one quad from loop to loop where the way is long. Refuses other boundaries.
std::optional<FaceMesh> ring_quads(const FaceSurface &surface,
                                   const std::vector<BoundaryLoop> &boundary, Refusal &refusal);

} // namespace nmgs::cad
