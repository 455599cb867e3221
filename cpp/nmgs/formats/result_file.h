// SPDX-License-Identifier: LGPL-2.1-or-later
// NMGS result files: N2R (a surface's quads, thesis Table C.3) and N3R (a solid's hexahedra and
// their tetrahedra, C.4). They hold the problem setup, the zones with their nodes' numbers and
// places, related nodes, and the nodes.
#pragma once

#include "nmgs/formats/setup_file.h"
#include "nmgs/mesh/mesh.h"
#include "nmgs/support/progress.h"

#include <cstdint>
#include <span>
#include <string>

namespace nmgs {

struct ResultFile {
    BlockModel model;
    std::string reference;
    Array<Vec3> points;
    Array<std::int32_t> cells; // 4 nodes a quad or 8 a hexahedron, 0-based
};

// dimension: 2 for N2R, 3 for N3R. The nodes section gives the points; a zone whose places differ
// from it by more than 1e-6 of the setup's size, or counts that do not follow from the divisions,
// are errors. The diagonals, related nodes and tetrahedra are checked and left out: they follow
// from the rest. Raises FormatError, std::filesystem::filesystem_error, Cancelled.
ResultFile read_result_file(const std::string &path, int dimension,
                            Numbering numbering = Numbering::corners_first,
                            const Progress &progress = {});

// points and cells: the mesh of the model, cells block by block as generate() orders them.
// Raises ArgumentError when their number does not follow from the model, or a cell's node is not
// in [0, points.size()).
void write_result_file(const std::string &path, const BlockModel &model,
                       const std::string &reference, std::span<const Vec3> points,
                       std::span<const std::int32_t> cells, const Progress &progress = {});

} // namespace nmgs
