// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/split_tips.h"

#include "nmgs/blocking/cusp.h"
#include "nmgs/blocking/default_divisions.h"
#include "nmgs/blocking/divisions.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/cad_geometry.h"
#include "nmgs_cad/refine.h"
#include "nmgs_cad/split_blocks.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace nmgs::cad {
namespace {

// Where a direction is cut whose first and last piece have at least these shares; nothing where one
// piece is left.
std::vector<double> cuts_of(double low, double high) {
    constexpr double whole = 0.75; // as good as all of it
    constexpr double least = 0.5;  // of the shorter piece, what is left between two
    if (low <= 0 && high <= 0) {
        return {};
    }
    if (low <= 0 || high <= 0) {
        const double share = std::max(low, high);
        return share > whole ? std::vector<double>() : std::vector{low > 0 ? share : 1 - share};
    }
    if (low + high > 1) {
        return {};
    }
    if (1 - low - high < least * std::min(low, high)) {
        return {low / (low + high)};
    }
    return {low, 1 - high};
}

std::vector<double> turned(const std::vector<double> &cuts) {
    std::vector<double> result(cuts.rbegin(), cuts.rend());
    for (double &t : result) {
        t = 1 - t;
    }
    return result;
}

// The edges of a block where they lie on the CAD: quadratics miss its tangents.
EdgePlace edges_on_cad(const CadBlocks &blocks, std::size_t b, CadGeometry &geometry) {
    return [&blocks, b, &geometry, quadratic = edges_of(blocks.model.element(b).first<20>())](
               std::size_t c, std::size_t d, double f) {
        std::array<int, 3> digits{};
        for (std::size_t i = 0; i < 3; ++i) {
            digits[i] = i == d ? 1 : static_cast<int>(hexa20::natural[c][i]) + 1;
        }
        const auto on = blocks.binding.of(b, part::code(digits[0], digits[1], digits[2]));
        const Vec3 p = quadratic(c, d, f);
        if (f <= 0 || on.size() != 1 || on[0].dimension == 3) {
            return p;
        }
        if (on[0].dimension == 1) {
            const EdgeCurve &curve = geometry.curve(on[0].index);
            const auto [from, to] =
                curve.part(quadratic(c, d, 0), quadratic(c, d, 0.5), quadratic(c, d, 1));
            return curve.at(from + f * (to - from));
        }
        FaceProjection &face = geometry.face(on[0].index);
        face.start(quadratic(c, d, 0));
        return face.nearest(p);
    };
}

} // namespace

CadBlocks split_tips(const CadShape &shape, CadBlocks blocks, double size, const Progress &progress,
                     std::size_t most_blocks) {
    if (blocks.model.dimension != 3 || blocks.model.size() == 0) {
        return blocks;
    }
    const std::size_t n = blocks.model.size();
    const Topology topology = find_topology(blocks.model);
    const Chains chains = find_chains(blocks.model, topology);
    DefaultDivisions options;
    options.volume_error = std::numeric_limits<double>::infinity(); // dear, and of no help here
    options.part.assign(n, 0);
    options.structured.assign(blocks.report.size() + 1, 1);
    for (std::size_t e = 0; e < blocks.report.size(); ++e) {
        const FitEntry &entry = blocks.report[e];
        std::fill_n(options.part.begin() + entry.first_block, entry.blocks,
                    static_cast<std::int32_t>(e));
    }
    const auto divisions = default_divisions(blocks.model, topology, size, options);
    BorrowedGeometry geometry(shape);
    std::vector<std::array<double, 2>> ends(at(chains.count), {0, 0});
    for (std::size_t b = 0; b < n; ++b) {
        const auto nodes = blocks.model.element(b).first<20>();
        const auto shares = shares_of_ends(nodes, edges_on_cad(blocks, b, *geometry), divisions[b]);
        for (std::size_t d = 0; d < 3; ++d) {
            const bool back = chains.reversed[3 * b + d] != 0;
            auto &end = ends[at(chains.chain[3 * b + d])];
            end[0] = std::max(end[0], shares[d][back ? 1 : 0]);
            end[1] = std::max(end[1], shares[d][back ? 0 : 1]);
        }
    }
    std::vector<std::vector<double>> cuts(at(chains.count));
    bool any = false;
    std::vector<std::size_t> pieces(n, 1);
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        if (chains.twisted[c] != 0) {
            ends[c][0] = ends[c][1] = std::max(ends[c][0], ends[c][1]);
        }
        cuts[c] = cuts_of(ends[c][0], ends[c][1]);
        if (cuts[c].empty()) {
            continue;
        }
        auto then = pieces;
        for (std::size_t i = 0; i < chains.chain.size(); ++i) {
            then[i / 3] *= at(chains.chain[i]) == c ? cuts[c].size() + 1 : 1;
        }
        if (std::accumulate(then.begin(), then.end(), std::size_t{0}) > most_blocks) {
            cuts[c].clear();
            continue;
        }
        pieces = std::move(then);
        any = true;
    }
    if (!any) {
        return blocks;
    }
    std::vector<BlockCuts> of_block(n);
    for (std::size_t i = 0; i < chains.chain.size(); ++i) {
        const auto &along = cuts[at(chains.chain[i])];
        of_block[i / 3][i % 3] = chains.reversed[i] != 0 ? turned(along) : along;
    }
    blocks = split_blocks(shape, blocks, of_block, progress);
    measure_report(shape, blocks);
    return blocks;
}

} // namespace nmgs::cad
