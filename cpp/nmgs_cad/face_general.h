// SPDX-License-Identifier: LGPL-2.1-or-later
// Quads over any face: a triangulation whose triangles are paired.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/face_mesh.h"
#include "nmgs_cad/layout_options.h"
#include "nmgs_cad/refusal.h"

#include <optional>

namespace nmgs::cad {

// The boundary keeps its nodes; nodes inside are spaced as the boundary near them is, at most as
// the surface's curvature allows. Triangles are paired by a matching of the greatest weight
// (J.-F. Remacle and others, Blossom-Quad, 2012); what is left over walks through the quads until
// two meet. Then the connectivity is cleaned up and the nodes are smoothed. Of several spacings the
// best result is taken. Refuses an odd number of segments on the boundary, and a boundary that
// crosses itself in the plane of the parameters.
std::optional<FaceMesh> general_quads(const FaceSurface &surface,
                                      const std::vector<BoundaryLoop> &boundary,
                                      const std::vector<BoundaryLoop> &inner,
                                      const LayoutOptions &options, Refusal &refusal,
                                      const Progress &progress = {});

} // namespace nmgs::cad
