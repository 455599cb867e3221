// SPDX-License-Identifier: LGPL-2.1-or-later
// Moves the inner nodes of quads along a CAD surface.
#pragma once

#include "nmgs_cad/face_mesh.h"

#include <span>

namespace nmgs::cad {

// Laplace's rule first, then, node by node, a direct search for the least sum of about exp(-6 q)
// over the corners of the quads at the node, q the sines of their angles (corner_quality): the
// worst corners weigh most, and turned over ones come right. Nodes stay on the surface and within
// the face's range of parameters. After L. A. Freitag, C. Ollivier-Gooch, Tetrahedral mesh
// improvement using swapping and smoothing, 1997.
void smooth_quads(FaceMesh &mesh, const FaceSurface &surface, int laplace_rounds,
                  int search_rounds);
// Only of these nodes, as far as they are free.
void smooth_quads(FaceMesh &mesh, const FaceSurface &surface, int laplace_rounds, int search_rounds,
                  std::span<const std::size_t> nodes);

} // namespace nmgs::cad
