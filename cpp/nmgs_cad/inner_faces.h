// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces between the solids of a shape.
#pragma once

#include "nmgs_cad/cad_shape.h"

#include <map>
#include <vector>

namespace nmgs::cad {

// Faces that two solids share, and these.
std::map<int, std::vector<int>> inner_faces(const CadShape &cad);

// Whether a face runs along a direction everywhere, as the walls of a sweep do.
bool runs_along(const TopoDS_Face &face, Vec3 direction);

} // namespace nmgs::cad
