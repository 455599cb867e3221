// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/refine.h"

#include "nmgs/blocking/cusp.h"
#include "nmgs/blocking/divisions.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/parallel.h"
#include "nmgs_cad/cad_geometry.h"
#include "nmgs_cad/split_blocks.h"

#include <algorithm>

namespace nmgs::cad {
namespace {

constexpr std::int32_t truth = 8; // divisions of the lattice that stands for the CAD

// Largest distance, across the face (u, v), between its lattice and the quadratics through every
// fourth node along u.
double quadratic_error(const SnappedBlocks &fine, std::size_t block, int code, std::size_t u,
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

FitError measure(const CadShape &shape, const CadBlocks &blocks, std::int32_t first,
                 std::int32_t last) {
    const bool solid = blocks.model.dimension == 3;
    const auto count = static_cast<std::size_t>(std::max(0, last - first));
    // Where blocks are many, each is small.
    const int samples = count > 2000 ? 4 : 8;
    std::vector<FitError> errors(count);
    constexpr std::size_t grain = 16;
    parallel_for(count, grain, [&](std::size_t from, std::size_t to) {
        BorrowedGeometry geometry(shape);
        for (std::size_t n = from; n < to; ++n) {
            const std::size_t b = static_cast<std::size_t>(first) + n;
            const auto nodes = blocks.model.element(b);
            for (int code = 0; code < part::count; ++code) {
                const auto on = blocks.binding.of(b, code);
                if (part::dimension(code) != 2 || on.size() != 1 || on[0].dimension != 2) {
                    continue;
                }
                FaceProjection &projection = geometry->face(on[0].index);
                const auto axes = part::axes(code);
                const auto digits = part::digits(code);
                for (int j = 0; j <= samples; ++j) {
                    for (int k = 0; k <= samples; ++k) {
                        // There and back, so that each point is near the last.
                        const int i = j % 2 == 0 ? k : samples - k;
                        std::array<double, 3> t{};
                        for (std::size_t d = 0; d < 3; ++d) {
                            t[d] = digits[d] - 1;
                        }
                        t[static_cast<std::size_t>(axes.axis[0])] = 2.0 * i / samples - 1;
                        t[static_cast<std::size_t>(axes.axis[1])] = 2.0 * j / samples - 1;
                        const Vec3 p = solid ? hexa20::map(nodes.first<20>(), t[0], t[1], t[2])
                                             : quad8::map(nodes.first<8>(), t[0], t[1]);
                        const double d = distance(p, projection.nearest(p));
                        if (d > errors[n].distance) {
                            errors[n] = {d, {p.x, p.y, p.z}};
                        }
                    }
                }
            }
        }
    });
    FitError worst;
    for (const FitError &error : errors) {
        worst = error.distance > worst.distance ? error : worst;
    }
    return worst;
}

namespace {

// What each block is to keep: the tolerance, or the share of the size of the blocks that come from
// the same entity.
std::vector<double> tolerances(const CadBlocks &blocks, double tolerance, double share_of_size) {
    std::vector<double> result(blocks.model.size(), tolerance);
    for (const FitEntry &entry : blocks.report) {
        if (entry.method.empty() || !(share_of_size > 0)) {
            continue;
        }
        const auto first = static_cast<std::size_t>(entry.first_block);
        const auto last = first + static_cast<std::size_t>(entry.blocks);
        Box box;
        for (std::size_t b = first; b < last; ++b) {
            for (const Vec3 p : blocks.model.element(b)) {
                box.add(p);
            }
        }
        for (std::size_t b = first; b < last; ++b) {
            result[b] = std::min(tolerance, share_of_size * box.diagonal());
        }
    }
    return result;
}

// By how much the quadratics along each direction of each block miss the CAD, in its tolerance, the
// larger of a chain's for all its directions.
std::vector<double> errors_of_chains(const CadBlocks &blocks, const SnappedBlocks &fine,
                                     const Chains &chains, const std::vector<double> &tolerance) {
    const std::size_t n = blocks.model.size();
    const auto dimension = static_cast<std::size_t>(blocks.model.dimension);
    std::vector<double> errors(dimension * n, 0);
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
                double &along_u = errors[dimension * b + u];
                double &along_v = errors[dimension * b + v];
                along_u = std::max(along_u, quadratic_error(fine, b, code, u, v) / tolerance[b]);
                along_v = std::max(along_v, quadratic_error(fine, b, code, v, u) / tolerance[b]);
            }
        }
    });
    std::vector<double> result(static_cast<std::size_t>(chains.count), 0);
    for (std::size_t d = 0; d < errors.size(); ++d) {
        double &error = result[static_cast<std::size_t>(chains.chain[d])];
        error = std::max(error, errors[d]);
    }
    // Halved, what ends in a cusp would be the worse for it: only where the fit is bad.
    constexpr double patience = 0.1;
    std::vector<char> cusp(result.size(), 0);
    for (std::size_t b = 0; b < n; ++b) {
        const auto nodes = blocks.model.element(b);
        std::array<bool, 3> spoilt{};
        if (dimension == 3) {
            spoilt = spoilt_by_division(nodes.first<20>());
        } else if (ends_in_cusp(nodes)) {
            spoilt = {true, true, false};
        }
        for (std::size_t d = 0; d < dimension; ++d) {
            if (spoilt[d]) {
                cusp[static_cast<std::size_t>(chains.chain[dimension * b + d])] = 1;
            }
        }
    }
    for (std::size_t c = 0; c < result.size(); ++c) {
        result[c] *= cusp[c] != 0 ? patience : 1;
    }
    return result;
}

// No error of the chains that have an edge on one of the CAD's that are kept.
void forgive(const CadBlocks &blocks, const Chains &chains, const std::set<int> &kept,
             std::vector<double> &errors) {
    const auto dimension = static_cast<std::size_t>(blocks.model.dimension);
    for (std::size_t b = 0; b < blocks.model.size() && !kept.empty(); ++b) {
        for (int code = 0; code < part::count; ++code) {
            const auto on = blocks.binding.of(b, code);
            if (part::dimension(code) == 1 && !on.empty() && on[0].dimension == 1 &&
                kept.contains(on[0].index)) {
                const auto along = static_cast<std::size_t>(part::axes(code).axis[0]);
                errors[static_cast<std::size_t>(chains.chain[dimension * b + along])] = 0;
            }
        }
    }
}

// Which chains are halved: those with an error above the share, the worst first, as long as there
// are no more than most_blocks then.
std::vector<char> chains_to_split(const BlockModel &model, const Chains &chains,
                                  const std::vector<double> &errors, double share,
                                  std::size_t most_blocks) {
    std::vector<std::size_t> wanted;
    for (std::size_t c = 0; c < errors.size(); ++c) {
        if (errors[c] > share) {
            wanted.push_back(c);
        }
    }
    std::stable_sort(wanted.begin(), wanted.end(),
                     [&](std::size_t a, std::size_t b) { return errors[a] > errors[b]; });
    std::vector<std::vector<std::size_t>> blocks_of(errors.size());
    const auto dimension = static_cast<std::size_t>(model.dimension);
    for (std::size_t d = 0; d < chains.chain.size(); ++d) {
        blocks_of[static_cast<std::size_t>(chains.chain[d])].push_back(d / dimension);
    }
    std::vector<char> split(errors.size(), 0);
    std::vector<std::size_t> pieces(model.size(), 1);
    std::size_t count = model.size();
    for (const std::size_t c : wanted) {
        std::size_t after = count;
        std::size_t last = model.size();
        std::size_t factor = 1;
        // A chain may go through a block in two directions or three.
        for (const std::size_t b : blocks_of[c]) {
            factor = b == last ? 2 * factor : 1;
            after += factor * pieces[b];
            last = b;
        }
        if (after > most_blocks) {
            continue;
        }
        count = after;
        split[c] = 1;
        for (const std::size_t b : blocks_of[c]) {
            pieces[b] *= 2;
        }
    }
    return split;
}

} // namespace

void measure_report(const CadShape &shape, CadBlocks &blocks) {
    for (FitEntry &entry : blocks.report) {
        if (!entry.method.empty()) {
            const FitError error =
                measure(shape, blocks, entry.first_block, entry.first_block + entry.blocks);
            entry.error = error.distance;
            entry.place = error.place;
        }
    }
}

CadBlocks refine_to_tolerance(const CadShape &shape, CadBlocks blocks, double tolerance,
                              int max_rounds, const Progress &progress, std::size_t most_blocks,
                              double share_of_size, const std::set<int> &kept) {
    const bool solid = blocks.model.dimension == 3;
    const auto dimension = static_cast<std::size_t>(blocks.model.dimension);
    const auto poll_at = [&](double fraction) {
        return progress ? Progress([&progress, fraction](double) { return progress(fraction); })
                        : Progress();
    };
    for (int round = 0; round < max_rounds && blocks.model.size() < most_blocks; ++round) {
        const Progress listener = poll_at(static_cast<double>(round) / max_rounds);
        poll(listener, 0);
        const std::size_t n = blocks.model.size();
        if (n == 0) {
            break;
        }
        const SnappedBlocks fine(
            shape, blocks,
            std::vector(n, std::array<std::int32_t, 3>{truth, truth, solid ? truth : 0}),
            SnapParts::boundary, listener);
        const Chains chains = find_chains(fine.model, fine.topology);
        auto errors =
            errors_of_chains(blocks, fine, chains, tolerances(blocks, tolerance, share_of_size));
        forgive(blocks, chains, kept, errors);
        // Two directions and the term that the serendipity patch lacks share the error.
        const auto split = chains_to_split(fine.model, chains, errors, 1.0 / 3, most_blocks);
        if (std::find(split.begin(), split.end(), 1) == split.end()) {
            break;
        }
        std::vector<BlockCuts> cuts(n);
        for (std::size_t d = 0; d < chains.chain.size(); ++d) {
            if (split[static_cast<std::size_t>(chains.chain[d])] != 0) {
                cuts[d / dimension][d % dimension] = {0.5};
            }
        }
        blocks = split_blocks(shape, blocks, cuts, listener);
    }
    measure_report(shape, blocks);
    return blocks;
}

} // namespace nmgs::cad
