// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/refine.h"

#include "nmgs/blocking/generate.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/parallel.h"
#include "nmgs_cad/face_projection.h"
#include "nmgs_cad/snap.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace nmgs::cad {
namespace {

std::size_t natural_digit(double natural) {
    return static_cast<std::size_t>(natural + 1);
}

// The snapped lattice of the blocks with the given divisions.
struct Snapped {
    BlockModel model;
    Topology topology;
    Lattice lattice;
    std::vector<Vec3> points;

    Snapped(const CadShape &shape, const CadBlocks &blocks,
            std::vector<std::array<std::int32_t, 3>> divisions)
        : model(with(blocks.model, std::move(divisions))), topology(find_topology(model)),
          lattice(model, topology), points(static_cast<std::size_t>(lattice.node_count())) {
        fill_points(model, lattice, points);
        snap(shape, model, blocks.binding, lattice, points);
    }
    static BlockModel with(const BlockModel &model,
                           std::vector<std::array<std::int32_t, 3>> divisions) {
        BlockModel result;
        result.dimension = model.dimension;
        result.nodes = model.nodes;
        result.divisions = std::move(divisions);
        return result;
    }
    [[nodiscard]] Vec3 at(std::size_t block, LatticeIndex index) const {
        return points[static_cast<std::size_t>(lattice.node(block, index))];
    }
};

// Union-find over the directions of blocks that share an edge.
struct Chains {
    std::vector<std::size_t> parent;
    explicit Chains(const Topology &topology, const BlockModel &model) : parent(3 * model.size()) {
        std::iota(parent.begin(), parent.end(), std::size_t{0});
        for (std::size_t b = 0; b < model.size(); ++b) {
            for (int code = 0; code < part::count; ++code) {
                if (part::dimension(code) != 1 || (model.dimension == 2 && code >= 9)) {
                    continue;
                }
                const Owner &owner = topology.of(b, code);
                const auto mine = static_cast<std::size_t>(part::axes(code).axis[0]);
                const auto theirs = static_cast<std::size_t>(part::axes(owner.part).axis[0]);
                parent[root(3 * b + mine)] =
                    root(3 * static_cast<std::size_t>(owner.block) + theirs);
            }
        }
    }
    std::size_t root(std::size_t n) {
        while (parent[n] != n) {
            parent[n] = parent[parent[n]];
            n = parent[n];
        }
        return n;
    }
};

constexpr std::int32_t truth = 8; // divisions of the lattice that stands for the CAD

// Largest distance, across the face (u, v), between its lattice and the quadratics through every
// fourth node along u.
double quadratic_error(const Snapped &fine, std::size_t block, int code, std::size_t u,
                       std::size_t v) {
    LatticeIndex at{};
    const auto digits = part::digits(code);
    for (std::size_t d = 0; d < 3; ++d) {
        at[d] = digits[d] == 2 ? truth : 0;
    }
    const auto p = [&](std::int32_t i, std::int32_t j) {
        LatticeIndex index = at;
        index[u] = i;
        index[v] = j;
        return fine.at(block, index);
    };
    double worst = 0;
    for (std::int32_t j = 0; j <= truth; ++j) {
        const Vec3 a = p(0, j);
        const Vec3 m = p(truth / 2, j);
        const Vec3 b = p(truth, j);
        for (std::int32_t i = 1; i < truth; ++i) {
            const double t = 2.0 * i / truth - 1;
            const Vec3 q = 0.5 * t * (t - 1) * a + (1 - t * t) * m + 0.5 * t * (t + 1) * b;
            const Vec3 off = q - p(i, j);
            const Vec3 along = p(i + 1, j) - p(i - 1, j);
            const bool rim = j == 0 || j == truth;
            if (rim) {
                // An edge: only what is not along it counts.
                const double l = norm2(along);
                worst = std::max(worst, norm(off - (l > 0 ? dot(off, along) / l : 0.0) * along));
            } else {
                const Vec3 normal = cross(along, p(i, j + 1) - p(i, j - 1));
                const double l = norm(normal);
                worst = std::max(worst, l > 0 ? std::abs(dot(off, normal)) / l : 0.0);
            }
        }
    }
    return worst;
}

} // namespace

CadBlocks split_blocks(const CadShape &shape, const CadBlocks &blocks,
                       const std::vector<std::array<std::int32_t, 3>> &pieces) {
    const bool solid = blocks.model.dimension == 3;
    auto divisions = pieces;
    for (auto &g : divisions) {
        g = {2 * g[0], 2 * g[1], solid ? 2 * g[2] : 0};
    }
    const Snapped fine(shape, blocks, divisions);
    CadBlocks result;
    result.model.dimension = blocks.model.dimension;
    result.report = blocks.report;
    std::vector<std::int32_t> first; // of the new blocks of each old one
    for (std::size_t b = 0; b < blocks.model.size(); ++b) {
        first.push_back(static_cast<std::int32_t>(result.model.size()));
        const LatticeIndex n{pieces[b][0], pieces[b][1], solid ? pieces[b][2] : 1};
        for (std::int32_t k = 0; k < n[2]; ++k) {
            for (std::int32_t j = 0; j < n[1]; ++j) {
                for (std::int32_t i = 0; i < n[0]; ++i) {
                    const LatticeIndex piece{i, j, k};
                    for (std::size_t m = 0; m < (solid ? 20U : 8U); ++m) {
                        LatticeIndex at{2 * i, 2 * j, solid ? 2 * k : 0};
                        for (std::size_t d = 0; d < (solid ? 3U : 2U); ++d) {
                            at[d] += static_cast<std::int32_t>(natural_digit(
                                solid ? hexa20::natural[m][d] : quad8::natural[m][d]));
                        }
                        result.model.nodes.push_back(fine.at(b, at));
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

FitError measure(const CadShape &shape, const CadBlocks &blocks, std::int32_t first,
                 std::int32_t last) {
    FitError error;
    constexpr int samples = 8;
    const bool solid = blocks.model.dimension == 3;
    for (auto b = static_cast<std::size_t>(first); b < static_cast<std::size_t>(last); ++b) {
        const auto nodes = blocks.model.element(b);
        for (int code = 0; code < part::count; ++code) {
            const auto on = blocks.binding.of(b, code);
            if (part::dimension(code) != 2 || on.size() != 1 || on[0].dimension != 2) {
                continue;
            }
            FaceProjection projection(shape.face(on[0].index));
            const auto axes = part::axes(code);
            const auto digits = part::digits(code);
            for (int j = 0; j <= samples; ++j) {
                for (int i = 0; i <= samples; ++i) {
                    std::array<double, 3> t{};
                    for (std::size_t d = 0; d < 3; ++d) {
                        t[d] = digits[d] - 1;
                    }
                    t[static_cast<std::size_t>(axes.axis[0])] = 2.0 * i / samples - 1;
                    t[static_cast<std::size_t>(axes.axis[1])] = 2.0 * j / samples - 1;
                    const Vec3 p = solid ? hexa20::map(nodes.first<20>(), t[0], t[1], t[2])
                                         : quad8::map(nodes.first<8>(), t[0], t[1]);
                    const double d = distance(p, projection.nearest(p));
                    if (d > error.distance) {
                        error = {d, {p.x, p.y, p.z}};
                    }
                }
            }
        }
    }
    return error;
}

CadBlocks refine_to_tolerance(const CadShape &shape, CadBlocks blocks, double tolerance,
                              int max_rounds, const Progress &progress) {
    const bool solid = blocks.model.dimension == 3;
    for (int round = 0; round < max_rounds && blocks.model.size() > 0; ++round) {
        poll(progress, static_cast<double>(round) / max_rounds);
        const std::size_t n = blocks.model.size();
        const Snapped fine(
            shape, blocks,
            std::vector(n, std::array<std::int32_t, 3>{truth, truth, solid ? truth : 0}));
        std::vector<char> wanted(3 * n, 0);
        parallel_for(n, 1, [&](std::size_t from, std::size_t to) {
            for (std::size_t b = from; b < to; ++b) {
                for (int code = 0; code < part::count; ++code) {
                    const auto on = blocks.binding.of(b, code);
                    if (part::dimension(code) != 2 || on.empty() || on[0].dimension != 2) {
                        continue;
                    }
                    const auto axes = part::axes(code);
                    const auto u = static_cast<std::size_t>(axes.axis[0]);
                    const auto v = static_cast<std::size_t>(axes.axis[1]);
                    // Two directions and the term that the serendipity patch lacks share the error.
                    const double share = tolerance / 3;
                    if (quadratic_error(fine, b, code, u, v) > share) {
                        wanted[3 * b + u] = 1;
                    }
                    if (quadratic_error(fine, b, code, v, u) > share) {
                        wanted[3 * b + v] = 1;
                    }
                }
            }
        });
        Chains chains(fine.topology, fine.model);
        std::set<std::size_t> split;
        for (std::size_t d = 0; d < 3 * n; ++d) {
            if (wanted[d] != 0) {
                split.insert(chains.root(d));
            }
        }
        if (split.empty()) {
            break;
        }
        std::vector<std::array<std::int32_t, 3>> pieces(n);
        for (std::size_t d = 0; d < 3 * n; ++d) {
            pieces[d / 3][d % 3] = split.contains(chains.root(d)) ? 2 : 1;
        }
        blocks = split_blocks(shape, blocks, pieces);
    }
    for (FitEntry &entry : blocks.report) {
        if (!entry.method.empty()) {
            const FitError error =
                measure(shape, blocks, entry.first_block, entry.first_block + entry.blocks);
            entry.error = error.distance;
            entry.place = error.place;
        }
    }
    return blocks;
}

} // namespace nmgs::cad
