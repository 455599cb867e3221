// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/divisions.h"

#include "nmgs/blocking/cusp.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/error.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace nmgs {
namespace {

constexpr const char *direction_names[] = {"xi", "eta", "zeta"};

std::string direction_name(const BlockModel &model, std::size_t at) {
    const auto n = static_cast<std::size_t>(model.dimension);
    return "Block" + std::to_string(at / n + 1) + " along " + direction_names[at % n];
}

// Edge parts of a direction.
std::vector<int> edge_parts(int dimension, int direction) {
    std::vector<int> codes;
    for (int code = 0; code < (dimension == 2 ? 9 : part::count); ++code) {
        if (part::dimension(code) == 1 && part::axes(code).axis[0] == direction) {
            codes.push_back(code);
        }
    }
    return codes;
}

// For each edge of the model, the directions that have it, and whether they run against it.
struct EdgeUses {
    std::vector<std::vector<std::pair<std::size_t, char>>> of_edge;
};
EdgeUses edge_uses(const BlockModel &model, const Topology &topology) {
    EdgeUses uses;
    const auto n = static_cast<std::size_t>(model.dimension);
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int d = 0; d < model.dimension; ++d) {
            for (const int code : edge_parts(model.dimension, d)) {
                const std::size_t at = b * part::count + static_cast<std::size_t>(code);
                const auto edge = static_cast<std::size_t>(topology.edge[at]);
                if (edge >= uses.of_edge.size()) {
                    uses.of_edge.resize(edge + 1);
                }
                uses.of_edge[edge].emplace_back(b * n + static_cast<std::size_t>(d),
                                                topology.edge_reversed[at]);
            }
        }
    }
    return uses;
}

// Disjoint sets whose members know whether they run against their root.
class SignedSets {
public:
    explicit SignedSets(std::size_t size) : parent_(size), against_(size, 0), twisted_(size, 0) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::pair<std::size_t, char> root(std::size_t i) {
        std::size_t top = i;
        char sign = 0;
        while (parent_[top] != top) {
            sign = static_cast<char>(sign ^ against_[top]);
            top = parent_[top];
        }
        // Paths are shortened so that later calls are quick.
        char rest = sign;
        while (parent_[i] != top && i != top) {
            const std::size_t next = parent_[i];
            const char step = against_[i];
            parent_[i] = top;
            against_[i] = rest;
            rest = static_cast<char>(rest ^ step);
            i = next;
        }
        return {top, sign};
    }
    void join(std::size_t a, std::size_t b, char against) {
        auto [ra, sa] = root(a);
        auto [rb, sb] = root(b);
        const char sign = static_cast<char>(sa ^ sb ^ against);
        if (ra == rb) {
            twisted_[ra] = static_cast<char>(twisted_[ra] | sign);
            return;
        }
        // The lower one stays the root, so that a chain's first direction is its own.
        if (rb < ra) {
            std::swap(ra, rb);
        }
        parent_[rb] = ra;
        against_[rb] = sign;
        twisted_[ra] = static_cast<char>(twisted_[ra] | twisted_[rb]);
    }
    [[nodiscard]] bool twisted(std::size_t root) const { return twisted_[root] != 0; }

private:
    std::vector<std::size_t> parent_;
    std::vector<char> against_;
    std::vector<char> twisted_;
};

// Directions from one to another over shared edges, both included.
std::vector<std::size_t> path(const EdgeUses &uses, std::size_t directions, std::size_t from,
                              std::size_t to) {
    std::vector<std::vector<std::size_t>> edges_of(directions);
    for (std::size_t e = 0; e < uses.of_edge.size(); ++e) {
        for (const auto &[direction, against] : uses.of_edge[e]) {
            edges_of[direction].push_back(e);
        }
    }
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> previous(directions, none);
    std::deque<std::size_t> front{from};
    previous[from] = from;
    while (!front.empty() && previous[to] == none) {
        const std::size_t at = front.front();
        front.pop_front();
        for (const std::size_t e : edges_of[at]) {
            for (const auto &[next, against] : uses.of_edge[e]) {
                if (previous[next] == none) {
                    previous[next] = at;
                    front.push_back(next);
                }
            }
        }
    }
    std::vector<std::size_t> result{to};
    while (result.back() != from) {
        result.push_back(previous[result.back()]);
    }
    std::reverse(result.begin(), result.end());
    return result;
}

[[noreturn]] void contradiction(const BlockModel &model, const Topology &topology,
                                const DivisionWish &a, const DivisionWish &b) {
    const auto n = static_cast<std::size_t>(model.dimension);
    const auto index = [&](const DivisionWish &w) {
        return static_cast<std::size_t>(w.block) * n + static_cast<std::size_t>(w.direction);
    };
    const auto links = path(edge_uses(model, topology), model.size() * n, index(a), index(b));
    std::vector<std::string> entities;
    std::vector<std::string> reasons;
    std::string chain;
    for (const std::size_t at : links) {
        entities.push_back("Block" + std::to_string(at / n + 1));
        chain += (chain.empty() ? "" : ", ") + direction_name(model, at);
    }
    const std::string text = direction_name(model, index(a)) + " is to have " +
                             std::to_string(a.count) + " divisions and " +
                             direction_name(model, index(b)) + " " + std::to_string(b.count) +
                             ", but opposite and shared edges make them one chain: " + chain;
    reasons.assign(entities.size(), text);
    throw BlockingError(text, std::move(entities), std::move(reasons));
}

} // namespace

Chains find_chains(const BlockModel &model, const Topology &topology) {
    const std::size_t directions = model.size() * static_cast<std::size_t>(model.dimension);
    SignedSets sets(directions);
    for (const auto &uses : edge_uses(model, topology).of_edge) {
        for (std::size_t i = 1; i < uses.size(); ++i) {
            sets.join(uses[0].first, uses[i].first,
                      static_cast<char>(uses[0].second ^ uses[i].second));
        }
    }
    Chains chains;
    chains.dimension = model.dimension;
    std::vector<std::int32_t> number(directions, -1);
    for (std::size_t i = 0; i < directions; ++i) {
        const auto [root, against] = sets.root(i);
        if (number[root] < 0) {
            number[root] = chains.count++;
            chains.twisted.push_back(sets.twisted(root) ? 1 : 0);
        }
        chains.chain.push_back(number[root]);
        chains.reversed.push_back(against);
    }
    return chains;
}

double edge_length(Vec3 low, Vec3 middle, Vec3 high) {
    // Gauss-Legendre with five points on each of eight pieces: the speed is the root of a
    // quadratic, smooth unless the edge turns back.
    constexpr std::array<double, 5> at{-0.9061798459386640, -0.5384693101056831, 0,
                                       0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 5> weight{0.2369268850561891, 0.4786286704993665,
                                           0.5688888888888889, 0.4786286704993665,
                                           0.2369268850561891};
    constexpr int pieces = 8;
    double length = 0;
    for (int p = 0; p < pieces; ++p) {
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double t = -1 + (2.0 * p + 1 + at[i]) / pieces;
            const Vec3 tangent = (t - 0.5) * low + (-2 * t) * middle + (t + 0.5) * high;
            length += weight[i] / pieces * norm(tangent);
        }
    }
    return length;
}

DirectionLength direction_length(const BlockModel &model, std::size_t block, int direction) {
    const auto nodes = model.element(block);
    const auto natural = [&](std::size_t n, int d) {
        const auto axis = static_cast<std::size_t>(d);
        return model.dimension == 2 ? (d < 2 ? quad8::natural[n][axis] : 0.0)
                                    : hexa20::natural[n][axis];
    };
    DirectionLength result{0, 0};
    int edges = 0;
    for (std::size_t m = 0; m < nodes.size(); ++m) {
        if (natural(m, direction) != 0) {
            continue;
        }
        std::array<Vec3, 2> ends{};
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            bool on = natural(n, direction) != 0;
            for (int d = 0; d < model.dimension; ++d) {
                on = on && (d == direction || natural(n, d) == natural(m, d));
            }
            if (on) {
                ends[natural(n, direction) < 0 ? 0 : 1] = nodes[n];
            }
        }
        const double length = edge_length(ends[0], nodes[m], ends[1]);
        result.mean += length;
        result.longest = std::max(result.longest, length);
        ++edges;
    }
    result.mean /= edges;
    return result;
}

std::vector<std::array<std::int32_t, 3>> solve_divisions(const BlockModel &model,
                                                         const Topology &topology,
                                                         std::span<const DivisionWish> wishes,
                                                         double size) {
    if (!(size >= 0) || !std::isfinite(size)) {
        throw ArgumentError("size: expected a positive length, got " + std::to_string(size));
    }
    const auto n = static_cast<std::size_t>(model.dimension);
    const Chains chains = find_chains(model, topology);
    const auto count = static_cast<std::size_t>(chains.count);
    std::vector<const DivisionWish *> hard(count, nullptr);
    std::vector<std::int32_t> soft(count, 0);
    for (const DivisionWish &wish : wishes) {
        if (wish.block < 0 || static_cast<std::size_t>(wish.block) >= model.size()) {
            throw ArgumentError("block: expected 0 to " + std::to_string(model.size() - 1) +
                                ", got " + std::to_string(wish.block));
        }
        if (wish.direction < 0 || wish.direction >= model.dimension) {
            throw ArgumentError("direction: expected 0 to " + std::to_string(model.dimension - 1) +
                                ", got " + std::to_string(wish.direction));
        }
        if (wish.count < 1) {
            throw ArgumentError("count: expected 1 or more divisions, got " +
                                std::to_string(wish.count));
        }
        const auto chain =
            static_cast<std::size_t>(chains.chain[static_cast<std::size_t>(wish.block) * n +
                                                  static_cast<std::size_t>(wish.direction)]);
        if (!wish.hard) {
            soft[chain] = std::max(soft[chain], wish.count);
        } else if (hard[chain] == nullptr) {
            hard[chain] = &wish;
        } else if (hard[chain]->count != wish.count) {
            contradiction(model, topology, *hard[chain], wish);
        }
    }
    std::vector<double> longest(count, 0);
    std::vector<std::int32_t> present(count, 1);
    // Finer, a patch that ends in a cusp would be the worse for it.
    std::vector<char> single(count, 0);
    for (std::size_t b = 0; b < model.size() && n == 2; ++b) {
        if (ends_in_cusp(model.element(b))) {
            single[static_cast<std::size_t>(chains.chain[2 * b])] = 1;
            single[static_cast<std::size_t>(chains.chain[2 * b + 1])] = 1;
        }
    }
    for (std::size_t at = 0; at < chains.chain.size(); ++at) {
        const auto chain = static_cast<std::size_t>(chains.chain[at]);
        const auto d = static_cast<int>(at % n);
        if (size > 0) {
            longest[chain] = std::max(longest[chain], direction_length(model, at / n, d).longest);
        }
        present[chain] = std::max(present[chain], model.divisions[at / n][at % n]);
    }
    auto result = model.divisions;
    for (std::size_t at = 0; at < chains.chain.size(); ++at) {
        const auto chain = static_cast<std::size_t>(chains.chain[at]);
        std::int32_t &value = result[at / n][at % n];
        if (hard[chain] != nullptr) {
            value = hard[chain]->count;
        } else if (soft[chain] > 0) {
            value = soft[chain];
        } else if (size > 0 && single[chain] != 0) {
            value = 1;
        } else if (size > 0) {
            // A length that is a whole number of sizes but for rounding is just that.
            const double needed = std::ceil(longest[chain] / size - 1e-9);
            if (needed > std::numeric_limits<std::int32_t>::max()) {
                throw ArgumentError("size: " + direction_name(model, at) + " would need " +
                                    std::to_string(needed) + " divisions");
            }
            value = std::max(1, static_cast<std::int32_t>(needed));
        } else {
            value = present[chain];
        }
    }
    return result;
}

} // namespace nmgs
