// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/layout_quality.h"

#include "nmgs/blocking/cusp.h"
#include "nmgs/blocking/divisions.h"
#include "nmgs/quality/quality.h"
#include "nmgs/support/at.h"
#include "nmgs/support/error.h"
#include "nmgs_cad/generate_on_cad.h"
#include "nmgs_cad/split_tips.h"

#include <algorithm>
#include <numeric>

namespace nmgs::cad {
namespace {

// What a block's worst corner is.
enum class Tip : char { none, straight, knife };

// One division for the chains that any other number would spoil.
std::vector<Tip> keep_tips_whole(BlockModel &model) {
    std::vector<Tip> tip(model.size(), Tip::none);
    std::vector<std::array<bool, 3>> spoilt(model.size());
    bool any = false;
    for (std::size_t b = 0; b < model.size(); ++b) {
        spoilt[b] = spoilt_by_division(model.element(b).first<20>());
        if (spoilt[b][0] || spoilt[b][1] || spoilt[b][2]) {
            tip[b] = ends_in_knife(model.element(b).first<20>()) ? Tip::knife : Tip::straight;
            any = true;
        }
    }
    if (any) {
        const Chains chains = find_chains(model, find_topology(model));
        std::vector<char> whole(at(chains.count), 0);
        for (std::size_t i = 0; i < chains.chain.size(); ++i) {
            char &mark = whole[at(chains.chain[i])];
            mark = spoilt[i / 3][i % 3] ? 1 : mark;
        }
        for (std::size_t i = 0; i < chains.chain.size(); ++i) {
            if (whole[at(chains.chain[i])] != 0) {
                model.divisions[i / 3][i % 3] = 1;
            }
        }
    }
    return tip;
}

} // namespace

LayoutQuality layout_quality(const CadShape &shape, const Layout &layout, std::size_t first,
                             int divisions) {
    Layout part = layout;
    part.hexas.erase(part.hexas.begin(), part.hexas.begin() + static_cast<std::ptrdiff_t>(first));
    CadBlocks blocks = split_tips(shape, blocks_of(shape, part, 3), shape.diagonal() / 30);
    std::fill(blocks.model.divisions.begin(), blocks.model.divisions.end(),
              std::array<std::int32_t, 3>{divisions, divisions, divisions});
    const std::vector<Tip> tip = keep_tips_whole(blocks.model);
    try {
        const Mesh mesh =
            generate_on_cad(shape, blocks, 1, {.tolerance = -1, .force = true, .improve = false});
        const CellView hexas{CellType::hexahedron,
                             {mesh.cells.front().nodes.data(), mesh.cells.front().nodes.size()}};
        const auto all =
            quality({mesh.points.data(), mesh.points.size()}, hexas, Metric::scaled_jacobian);
        const auto volumes =
            quality({mesh.points.data(), mesh.points.size()}, hexas, Metric::volume);
        LayoutQuality result;
        result.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
        if (all.size() > 0) {
            result.worst = result.avoidable = 1;
        }
        // Smoothing takes tips that are nearly good to 0.2; no straight corner comes to much more
        // (see cusp.h).
        constexpr double nearly = 0.15;
        constexpr double smoothed = 0.203;
        constexpr double straight = 0.25;
        std::size_t cell = 0;
        for (std::size_t b = 0; b < blocks.model.size(); ++b) {
            const auto &g = blocks.model.divisions[b];
            double least = tip[b] == Tip::straight ? straight : 1;
            for (const std::size_t end = cell + at(g[0] * g[1] * g[2]); cell < end; ++cell) {
                least = std::min(least, all[cell]);
            }
            if (tip[b] != Tip::none && least > nearly) {
                least = std::max(least, smoothed);
            }
            result.worst = std::min(result.worst, least);
            if (tip[b] != Tip::knife) {
                result.avoidable = std::min(result.avoidable, least);
            }
        }
        return result;
    } catch (const Error &) {
        return {}; // blocks that cannot be meshed are no good
    }
}

} // namespace nmgs::cad
