// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/default_divisions.h"

#include "nmgs/blocking/cusp.h"
#include "nmgs/blocking/divisions.h"
#include "nmgs/blocking/patch_area.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/at.h"
#include "nmgs/support/error.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace nmgs {
namespace {

using Divisions = std::vector<std::array<std::int32_t, 3>>;

// Angle between the tangents at the ends of a quadratic curve.
double turn(Vec3 low, Vec3 middle, Vec3 high) {
    const Vec3 start = 4 * middle - 3 * low - high;
    const Vec3 end = 3 * high + low - 4 * middle;
    const double size = norm(start) * norm(end);
    return size > 0 ? std::acos(std::clamp(dot(start, end) / size, -1.0, 1.0)) : 0.0;
}

// What a chain needs: the longest edge, and the largest turn divided by the angle allowed. single:
// a patch of it ends in a cusp and stays whole, if the others do with as many as `few`.
struct Needs {
    std::vector<double> length, angles, few;
    std::vector<char> single;
};

// Times the angle that is allowed elsewhere: along chains with cusps, and at the cusp of a block,
// where the corner is as it should be only if the element turns by so much.
constexpr double bent = 2.35;
constexpr double bent_at_cusp = 6.5;

Vec3 place(const BlockModel &model, std::size_t block, const std::array<double, 3> &t) {
    const auto nodes = model.element(block);
    return model.dimension == 3 ? hexa20::map(nodes.first<20>(), t[0], t[1], t[2])
                                : quad8::map(nodes.first<8>(), t[0], t[1]);
}

Needs needs_of(const BlockModel &model, const Chains &chains, std::span<const std::int32_t> part,
               const DefaultDivisions &options) {
    const auto count = static_cast<std::size_t>(chains.count);
    const auto n = static_cast<std::size_t>(model.dimension);
    Needs needs{std::vector<double>(count, 0), std::vector<double>(count, 0),
                std::vector<double>(count, 0), std::vector<char>(count, 0)};
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto chain = [&](std::size_t d) {
            return static_cast<std::size_t>(chains.chain[b * n + d]);
        };
        for (std::size_t d = 0; d < n; ++d) {
            double &length = needs.length[chain(d)];
            length = std::max(length, direction_length(model, b, static_cast<int>(d)).longest);
        }
        if (n == 2 && ends_in_cusp(model.element(b))) {
            needs.single[chain(0)] = needs.single[chain(1)] = 1;
        }
        std::array<bool, 3> spoilt{};
        if (n == 3 && !options.structured.empty() && options.structured[at(part[b])] != 0) {
            spoilt = spoilt_by_division(model.element(b).first<20>());
            for (std::size_t d = 0; d < 3; ++d) {
                needs.single[chain(d)] = spoilt[d] ? 1 : needs.single[chain(d)];
            }
        }
        // Each face: along its rims and its middle lines.
        for (std::size_t w = 0; w < 3; ++w) {
            if (n == 2 && w != 2) {
                continue;
            }
            const std::array<std::size_t, 2> axes{w == 0 ? 1U : 0U, w == 2 ? 1U : 2U};
            for (const double end : {-1.0, 1.0}) {
                std::array<double, 2> turns{};
                for (std::size_t a = 0; a < 2; ++a) {
                    for (const double across : {-1.0, 0.0, 1.0}) {
                        std::array<double, 3> t{};
                        t[w] = end;
                        t[axes[1 - a]] = across;
                        std::array<Vec3, 3> p{};
                        for (std::size_t i = 0; i < 3; ++i) {
                            t[axes[a]] = static_cast<double>(i) - 1;
                            p[i] = place(model, b, t);
                        }
                        turns[a] = std::max(turns[a], turn(p[0], p[1], p[2]));
                    }
                }
                const bool both = std::min(turns[0], turns[1]) > options.angle;
                for (std::size_t a = 0; a < 2; ++a) {
                    const double angles = turns[a] / (both ? options.both_angle : options.angle);
                    double &most = needs.angles[chain(axes[a])];
                    most = std::max(most, angles);
                    double &few = needs.few[chain(axes[a])];
                    few = std::max(few, angles / (spoilt[axes[a]] ? bent_at_cusp : bent));
                }
                if (n == 2) {
                    break;
                }
            }
        }
    }
    return needs;
}

// Six times the volume between a lattice's bilinear faces and the origin, and that of the block.
struct Volumes {
    double linear = 0, exact = 0;
};

// Of a block's faces alone: what is inside cancels.
Volumes volumes(const BlockModel &model, std::size_t b, const std::array<std::int32_t, 3> &g) {
    Volumes result;
    const Vec3 origin = place(model, b, {0, 0, 0});
    for (std::size_t w = 0; w < 3; ++w) {
        const std::size_t u = (w + 1) % 3;
        const std::size_t v = (w + 2) % 3;
        for (const double end : {-1.0, 1.0}) {
            const auto at = [&](std::int32_t i, std::int32_t j) {
                std::array<double, 3> t{};
                t[w] = end;
                t[u] = 2.0 * i / g[u] - 1;
                t[v] = 2.0 * j / g[v] - 1;
                return place(model, b, t) - origin;
            };
            for (std::int32_t j = 0; j < g[v]; ++j) {
                for (std::int32_t i = 0; i < g[u]; ++i) {
                    const Vec3 p = at(i, j);
                    const Vec3 q = at(i + 1, j);
                    const Vec3 r = at(i + 1, j + 1);
                    const Vec3 s = at(i, j + 1);
                    // A bilinear face is the mean of its two splits.
                    const double twice = determinant(p, q, r) + determinant(p, r, s) +
                                         determinant(p, q, s) + determinant(q, r, s);
                    result.linear += 0.5 * end * twice;
                }
            }
        }
    }
    // Exact for the Jacobian's degree of 5.
    constexpr std::array<double, 3> at{-0.7745966692414834, 0, 0.7745966692414834};
    constexpr std::array<double, 3> weight{5.0 / 9, 8.0 / 9, 5.0 / 9};
    const auto nodes = model.element(b).first<20>();
    for (std::size_t i = 0; i < 27; ++i) {
        result.exact += 6 * weight[i % 3] * weight[i / 3 % 3] * weight[i / 9] *
                        hexa20::jacobian(nodes, at[i % 3], at[i / 3 % 3], at[i / 9]);
    }
    return result;
}

// Of a patch its areas.
Volumes measured(const BlockModel &model, std::size_t b, const std::array<std::int32_t, 3> &g) {
    if (model.dimension == 3) {
        return volumes(model, b, g);
    }
    const PatchArea area = patch_area(model, b, g);
    return {area.linear, area.exact};
}

Divisions divide(const BlockModel &model, const Chains &chains, const Needs &needs, double size,
                 double coarser) {
    Divisions result = model.divisions;
    const auto n = static_cast<std::size_t>(model.dimension);
    for (std::size_t at = 0; at < chains.chain.size(); ++at) {
        const auto chain = static_cast<std::size_t>(chains.chain[at]);
        double wanted = std::max(needs.length[chain] / size, needs.angles[chain] / coarser);
        if (needs.single[chain] != 0) {
            // As few as will do for what else is on the chain.
            constexpr double longer = 6;
            wanted = std::max(needs.length[chain] / (longer * size), needs.few[chain] / coarser);
        }
        constexpr double most = 1e6;
        result[at / n][at % n] =
            std::max(1, static_cast<std::int32_t>(std::ceil(std::min(wanted, most) - 1e-9)));
    }
    return result;
}

double cells(const Divisions &divisions, int dimension) {
    double sum = 0;
    for (const auto &g : divisions) {
        sum += static_cast<double>(g[0]) * g[1] * (dimension == 3 ? g[2] : 1);
    }
    return sum;
}

} // namespace

Divisions default_divisions(const BlockModel &model, const Topology &topology, double size,
                            const DefaultDivisions &options) {
    if (!(size > 0) || !std::isfinite(size)) {
        throw ArgumentError("size: expected a positive length, got " + std::to_string(size));
    }
    const std::vector<std::int32_t> part =
        options.part.empty() ? std::vector<std::int32_t>(model.size(), 0) : options.part;
    const auto parts = part.empty() ? 0 : at(*std::max_element(part.begin(), part.end())) + 1;
    if (part.size() != model.size() ||
        std::any_of(part.begin(), part.end(), [](auto p) { return p < 0; })) {
        throw ArgumentError("part: expected a number from 0 on for each of " +
                            std::to_string(model.size()) + " blocks");
    }
    if (!options.structured.empty() && options.structured.size() < parts) {
        throw ArgumentError("structured: expected an entry for each of " + std::to_string(parts) +
                            " parts, got " + std::to_string(options.structured.size()));
    }
    const Chains chains = find_chains(model, topology);
    Needs needs = needs_of(model, chains, part, options);
    const auto n = static_cast<std::size_t>(model.dimension);
    const auto most = static_cast<double>(
        std::max<std::int64_t>(options.most_cells, static_cast<std::int64_t>(model.size())));
    // Blocks by the thousand are small already. Patches come by the thousand from shapes with many
    // faces, each of which is structured.
    const bool many = model.dimension == 3 && model.size() >= options.many_blocks;
    if (many) {
        std::fill(needs.length.begin(), needs.length.end(), 0.0);
    }
    // A chain goes through most of the blocks that come from no structured strategy: finer elements
    // would be no better and far too many.
    std::vector<std::size_t> unstructured;
    for (std::size_t b = 0; b < model.size(); ++b) {
        if (options.structured.empty() || options.structured[at(part[b])] == 0) {
            unstructured.push_back(b);
        }
    }
    if (many && unstructured.size() >= options.many_blocks) {
        std::vector<char> done(needs.angles.size(), 0);
        for (const std::size_t b : unstructured) {
            for (std::size_t d = 0; d < n; ++d) {
                const std::size_t chain = at(chains.chain[b * n + d]);
                needs.angles[chain] /= done[chain] == 0 ? options.many_blocks_factor : 1;
                done[chain] = 1;
            }
        }
    }
    const auto within = [&] {
        double length = size;
        double coarser = 1;
        Divisions result = divide(model, chains, needs, length, coarser);
        // Longer elements first; these alone cannot help where the curvature asks for more.
        for (int step = 0; cells(result, model.dimension) > most && step < 200; ++step) {
            length *= 1.08;
            coarser *= length > 3 * size ? 1.08 : 1;
            result = divide(model, chains, needs, length, coarser);
        }
        return result;
    };
    Divisions result = within();
    constexpr int rounds = 4;
    constexpr double at_cusps = 1.4; // times the error: there are no more elements than must be
    const bool by_volume = std::isfinite(options.volume_error);
    for (int round = 0; round < rounds && by_volume; ++round) {
        std::vector<Volumes> all(parts);
        std::vector<double> off(model.size(), 0);
        std::vector<double> worst(parts, 0);
        for (std::size_t b = 0; b < model.size(); ++b) {
            const Volumes v = measured(model, b, result[b]);
            all[at(part[b])].linear += v.linear;
            all[at(part[b])].exact += v.exact;
            off[b] = std::abs(v.linear - v.exact);
            worst[at(part[b])] = std::max(worst[at(part[b])], off[b]);
        }
        // Finer along the chains of the blocks that are to blame, where these turn at all.
        std::vector<double> finer(needs.angles.size(), 1);
        for (std::size_t i = 0; i < chains.chain.size(); ++i) {
            const auto p = at(part[i / n]);
            const double error = std::abs(all[p].linear - all[p].exact) / std::abs(all[p].exact);
            const auto chain = at(chains.chain[i]);
            const double accepted =
                (needs.single[chain] != 0 ? at_cusps : 1) * options.volume_error;
            // A patch with a cusp would stay whole, were it not for the others of its chain.
            if (error > accepted && off[i / n] > 0.1 * worst[p] && needs.angles[chain] > 0.05 &&
                !(n == 2 && ends_in_cusp(model.element(i / n)))) {
                finer[chain] =
                    std::max(finer[chain], std::clamp(std::sqrt(error / accepted), 1.1, 3.0));
            }
        }
        for (std::size_t i = 0; i < chains.chain.size(); ++i) {
            const auto chain = at(chains.chain[i]);
            if (finer[chain] > 1) {
                const auto now = static_cast<double>(result[i / n][i % n]);
                needs.angles[chain] = finer[chain] * std::max(needs.angles[chain], now);
                needs.few[chain] = finer[chain] * std::max(needs.few[chain], now);
                finer[chain] = 1;
            }
        }
        Divisions next = within();
        if (next == result) {
            break;
        }
        result = std::move(next);
    }
    return result;
}

} // namespace nmgs
