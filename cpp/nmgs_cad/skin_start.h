// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "nmgs_cad/skin_mesh.h"

namespace nmgs::cad {

// Fills the mesh with OpenCASCADE's triangulation of the faces, such that no two points are joined
// by two curves. Raises GeometryError that names faces without triangulation.
void start_skin(const CadShape &shape, std::span<const int> faces, const SkinOptions &options,
                SkinMesh &mesh, const Progress &progress);

} // namespace nmgs::cad
