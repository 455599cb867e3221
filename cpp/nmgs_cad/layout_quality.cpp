// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/layout_quality.h"

#include "nmgs/quality/quality.h"
#include "nmgs/support/error.h"
#include "nmgs_cad/generate_on_cad.h"

#include <algorithm>
#include <numeric>

namespace nmgs::cad {

LayoutQuality layout_quality(const CadShape &shape, const Layout &layout, std::size_t first,
                             int divisions) {
    Layout part = layout;
    part.hexas.erase(part.hexas.begin(), part.hexas.begin() + static_cast<std::ptrdiff_t>(first));
    CadBlocks blocks = blocks_of(shape, part, 3);
    std::fill(blocks.model.divisions.begin(), blocks.model.divisions.end(),
              std::array<std::int32_t, 3>{divisions, divisions, divisions});
    try {
        const Mesh mesh =
            generate_on_cad(shape, blocks, 1, {.tolerance = -1, .force = true, .improve = false});
        const CellView hexas{CellType::hexahedron,
                             {mesh.cells.front().nodes.data(), mesh.cells.front().nodes.size()}};
        const auto worst =
            quality({mesh.points.data(), mesh.points.size()}, hexas, Metric::scaled_jacobian);
        const auto volumes =
            quality({mesh.points.data(), mesh.points.size()}, hexas, Metric::volume);
        return {worst.size() == 0 ? -1 : *std::min_element(worst.begin(), worst.end()),
                std::accumulate(volumes.begin(), volumes.end(), 0.0)};
    } catch (const Error &) {
        return {}; // blocks that cannot be meshed are no good
    }
}

} // namespace nmgs::cad
