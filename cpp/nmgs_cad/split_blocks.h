// SPDX-License-Identifier: LGPL-2.1-or-later
// Blocks over CAD cut into smaller ones along their directions.
#pragma once

#include "nmgs/blocking/lattice.h"
#include "nmgs/support/progress.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/snap.h"

#include <array>
#include <vector>

namespace nmgs::cad {

// Of a block: for each direction where it is cut, ascending in (0, 1).
using BlockCuts = std::array<std::vector<double>, 3>;

// The nodes of the blocks with the divisions and the spacing of `model`, on the CAD.
struct SnappedBlocks {
    BlockModel model;
    Topology topology;
    Lattice lattice;
    std::vector<Vec3> points;

    SnappedBlocks(const CadShape &shape, const CadBlocks &blocks,
                  std::vector<std::array<std::int32_t, 3>> divisions, SnapParts parts,
                  const Progress &progress, std::vector<std::vector<double>> spacing = {});
    [[nodiscard]] Vec3 at(std::size_t block, LatticeIndex index) const {
        return points[static_cast<std::size_t>(lattice.node(block, index))];
    }
};

// Blocks that share an edge must be cut alike along it. New nodes lie on the CAD as snap() puts
// them. Each piece has one division a direction.
CadBlocks split_blocks(const CadShape &shape, const CadBlocks &blocks,
                       const std::vector<BlockCuts> &cuts, const Progress &progress = {});

} // namespace nmgs::cad
