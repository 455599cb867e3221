// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "nmgs_cad/tessellate.h"

namespace nmgs::cad {

// A point inside each solid, and one in each cavity of a solid that no other solid fills, by the
// triangles: midway from one to the next along its normal, proved by counting triangles to the
// outside. Raises GeometryError that names a solid without volume.
void add_inner_points(const CadShape &shape, Tessellation &result, const Progress &progress);

} // namespace nmgs::cad
