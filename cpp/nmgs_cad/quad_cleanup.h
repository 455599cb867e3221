// SPDX-License-Identifier: LGPL-2.1-or-later
// Better connectivity for quads over a face: rotates edges, closes and opens quads until no step
// brings the numbers of quads at the nodes nearer to what their angles ask for. After P. Kinney,
// CleanUp: improving quadrilateral finite element meshes, 1997.
#pragma once

#include "nmgs_cad/face_mesh.h"

#include <array>
#include <cstdint>
#include <set>

namespace nmgs::cad {

// Inside four quads are wanted at a node, on the boundary one a right angle; the boundary stays,
// and so do the edges that are kept (ends ascending).
void clean_up_quads(FaceMesh &mesh, const FaceSurface &surface,
                    const std::set<std::array<std::int32_t, 2>> &kept = {});

} // namespace nmgs::cad
