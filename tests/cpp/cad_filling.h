// SPDX-License-Identifier: LGPL-2.1-or-later
// What a strategy made of a solid: checked against the CAD, and its mesh measured.
#pragma once

#include "cad_layout_checks.h"

#include "nmgs/quality/quality.h"
#include "nmgs_cad/generate_on_cad.h"
#include "nmgs_cad/layout_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace nmgs::cad {

struct Filling {
    bool filled = false;
    Refusal refusal;
    std::size_t hexas = 0;
    double worst = -1, volume = 0; // of a mesh of `divisions` elements a block and direction
};

inline Filling fill_all(FillSolid fill, const CadShape &shape, int divisions = 8) {
    Filling result;
    Layout layout(shape);
    for (int s = 1; s <= shape.solids.Extent(); ++s) {
        result.filled = fill(shape, s, layout, {}, result.refusal, {});
        if (!result.filled) {
            EXPECT_FALSE(result.refusal.reason.empty());
            EXPECT_TRUE(layout.hexas.empty() || s > 1);
            return result;
        }
    }
    expect_sound(shape, layout, 0.12);
    result.hexas = layout.hexas.size();
    CadBlocks blocks = blocks_of(shape, layout, 3);
    std::fill(blocks.model.divisions.begin(), blocks.model.divisions.end(),
              std::array<std::int32_t, 3>{divisions, divisions, divisions});
    const Mesh mesh = generate_on_cad(shape, blocks, 1, {});
    const CellView cells{CellType::hexahedron,
                         {mesh.cells.front().nodes.data(), mesh.cells.front().nodes.size()}};
    const auto worst =
        quality({mesh.points.data(), mesh.points.size()}, cells, Metric::scaled_jacobian);
    const auto volumes = quality({mesh.points.data(), mesh.points.size()}, cells, Metric::volume);
    result.worst = *std::min_element(worst.begin(), worst.end());
    result.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    return result;
}

} // namespace nmgs::cad
