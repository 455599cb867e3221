// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/split_blocks.h"

#include "nmgs/blocking/generate.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <algorithm>

namespace nmgs::cad {
namespace {

std::size_t natural_digit(double natural) {
    return static_cast<std::size_t>(natural + 1);
}

BlockModel with(const BlockModel &model, std::vector<std::array<std::int32_t, 3>> divisions,
                std::vector<std::vector<double>> spacing) {
    BlockModel result;
    result.dimension = model.dimension;
    result.nodes = model.nodes;
    result.corners = model.corners;
    result.divisions = std::move(divisions);
    result.spacing = std::move(spacing);
    return result;
}

// The planes between the pieces and half-way between these; none where all are alike.
std::vector<double> doubled(const std::vector<double> &cuts) {
    std::vector<double> ends{0};
    ends.insert(ends.end(), cuts.begin(), cuts.end());
    ends.push_back(1);
    std::vector<double> result{0};
    bool even = true;
    const auto pieces = static_cast<double>(ends.size() - 1);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        even = even && std::abs(ends[i] * pieces - static_cast<double>(i)) < 1e-12;
        result.push_back(0.5 * (ends[i - 1] + ends[i]));
        result.push_back(ends[i]);
    }
    return even ? std::vector<double>() : result;
}

} // namespace

SnappedBlocks::SnappedBlocks(const CadShape &shape, const CadBlocks &blocks,
                             std::vector<std::array<std::int32_t, 3>> divisions, SnapParts parts,
                             const Progress &progress, std::vector<std::vector<double>> spacing)
    : model(with(blocks.model, std::move(divisions), std::move(spacing))),
      topology(find_topology(model)), lattice(model, topology),
      points(static_cast<std::size_t>(lattice.node_count())) {
    fill_points(model, lattice, points, progress);
    snap(shape, model, blocks.binding, lattice, points, progress, 0, 1, parts);
}

CadBlocks split_blocks(const CadShape &shape, const CadBlocks &blocks,
                       const std::vector<BlockCuts> &cuts, const Progress &progress) {
    const bool solid = blocks.model.dimension == 3;
    const std::size_t directions = solid ? 3 : 2;
    std::vector<std::array<std::int32_t, 3>> divisions(cuts.size(), {0, 0, 0});
    std::vector<std::vector<double>> spacing;
    for (std::size_t b = 0; b < cuts.size(); ++b) {
        for (std::size_t d = 0; d < directions; ++d) {
            divisions[b][d] = 2 * static_cast<std::int32_t>(cuts[b][d].size() + 1);
            spacing.push_back(doubled(cuts[b][d]));
        }
    }
    const SnappedBlocks fine(shape, blocks, divisions, SnapParts::all, progress,
                             std::move(spacing));
    CadBlocks result;
    result.model.dimension = blocks.model.dimension;
    result.report = blocks.report;
    // The pieces' corners are nodes of the lattice, which shares them as the blocks do.
    const bool numbered = !blocks.model.corners.empty();
    std::vector<std::int32_t> first; // of the new blocks of each old one
    for (std::size_t b = 0; b < blocks.model.size(); ++b) {
        first.push_back(static_cast<std::int32_t>(result.model.size()));
        const LatticeIndex n{divisions[b][0] / 2, divisions[b][1] / 2,
                             solid ? divisions[b][2] / 2 : 1};
        for (std::int32_t k = 0; k < n[2]; ++k) {
            for (std::int32_t j = 0; j < n[1]; ++j) {
                for (std::int32_t i = 0; i < n[0]; ++i) {
                    const LatticeIndex piece{i, j, k};
                    for (std::size_t m = 0; m < (solid ? 20U : 8U); ++m) {
                        LatticeIndex at{2 * i, 2 * j, solid ? 2 * k : 0};
                        for (std::size_t d = 0; d < directions; ++d) {
                            at[d] += static_cast<std::int32_t>(natural_digit(
                                solid ? hexa20::natural[m][d] : quad8::natural[m][d]));
                        }
                        result.model.nodes.push_back(fine.at(b, at));
                        if (numbered && m < (solid ? 8U : 4U)) {
                            result.model.corners.push_back(
                                static_cast<std::int32_t>(fine.lattice.node(b, at)));
                        }
                    }
                    result.model.divisions.push_back({1, 1, solid ? 1 : 0});
                    for (int code = 0; code < part::count; ++code) {
                        auto digits = part::digits(code);
                        for (std::size_t d = 0; d < 3; ++d) {
                            const bool low = digits[d] == 0 && piece[d] == 0;
                            const bool high = digits[d] == 2 && piece[d] == n[d] - 1;
                            digits[d] = low ? 0 : high ? 2 : 1;
                        }
                        if (!solid) {
                            digits[2] = part::digits(code)[2];
                        }
                        for (const CadEntity &e :
                             blocks.binding.of(b, part::code(digits[0], digits[1], digits[2]))) {
                            result.binding.entities.push_back(e);
                        }
                        result.binding.offsets.push_back(
                            static_cast<std::int32_t>(result.binding.entities.size()));
                    }
                }
            }
        }
    }
    first.push_back(static_cast<std::int32_t>(result.model.size()));
    for (FitEntry &entry : result.report) {
        if (!entry.method.empty()) {
            const auto from = static_cast<std::size_t>(entry.first_block);
            const auto to = from + static_cast<std::size_t>(entry.blocks);
            entry.first_block = first[from];
            entry.blocks = first[to] - first[from];
        }
    }
    return result;
}

} // namespace nmgs::cad
