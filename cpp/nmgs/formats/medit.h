// SPDX-License-Identifier: LGPL-2.1-or-later
// Medit's .mesh as text (Frey, Medit: an interactive mesh visualization software, INRIA RT-0253,
// 2001): points, cells and their reference numbers, in double precision whatever the version says.
#pragma once

#include "nmgs/mesh/mesh.h"

#include <string>
#include <vector>

namespace nmgs {

struct MeditCells {
    CellType type;
    std::vector<std::int32_t> nodes; // 0-based
    std::vector<std::int32_t> references;
};

struct MeditMesh {
    std::vector<Vec3> points;
    std::vector<std::int32_t> point_references;
    std::vector<MeditCells> cells; // in the file's order
};

// Other parts of the file (corners, normals, ...) are left out.
// Raises FormatError with file and line, filesystem_error.
MeditMesh read_medit(const std::string &path);

} // namespace nmgs
