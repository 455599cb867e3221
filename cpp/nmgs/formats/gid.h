// SPDX-License-Identifier: LGPL-2.1-or-later
// .face.gid and .ele.gid (thesis, Tables C.9 and C.10): a mesh of triangles or tetrahedra as TetGen
// 1.3 wrote it for GiD. GiD's own spelling of the same words is read too.
#pragma once

#include "nmgs/support/vec3.h"

#include <cstdint>
#include <string>
#include <vector>

namespace nmgs {

struct GidMesh {
    std::vector<Vec3> points;
    int columns = 0;                 // nodes of a cell: 3, 4, 6 or 10
    std::vector<std::int32_t> nodes; // 0-based
};

// Raises FormatError with file and line, filesystem_error.
GidMesh read_gid(const std::string &path);
void write_gid(const std::string &path, const GidMesh &mesh);

} // namespace nmgs
