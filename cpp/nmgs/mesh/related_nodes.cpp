// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/related_nodes.h"

#include "nmgs/support/parallel.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <mutex>
#include <vector>

namespace nmgs {
namespace {

// Two nodes that an edge joins, the lower in the upper half.
using Pair = std::uint64_t;

Pair pair_of(std::int32_t a, std::int32_t b) {
    return static_cast<Pair>(std::min(a, b)) << 32 | static_cast<Pair>(std::max(a, b));
}
std::size_t low(Pair pair) {
    return pair >> 32;
}
std::size_t high(Pair pair) {
    return pair & 0xffffffffU;
}

// The pairs of local nodes that the edges of a type join.
struct LocalPairs {
    std::size_t count = 0;
    std::array<std::array<std::uint8_t, 2>, 24> nodes{};
};

constexpr LocalPairs local_pairs(CellType type) {
    LocalPairs pairs;
    for (const LocalEdge &edge : edges(type)) {
        const auto a = static_cast<std::uint8_t>(edge.a);
        const auto b = static_cast<std::uint8_t>(edge.b);
        const auto mid = static_cast<std::uint8_t>(edge.mid);
        if (is_quadratic(type)) {
            pairs.nodes[pairs.count++] = {a, mid};
            pairs.nodes[pairs.count++] = {mid, b};
        } else {
            pairs.nodes[pairs.count++] = {a, b};
        }
    }
    return pairs;
}

// Remembers pairs that came lately. Neighbouring cells share most of their edges and stand close to
// each other in any sensible order, so what passes holds few pairs twice.
class Filter {
public:
    Filter() : seen_(std::size_t{1} << bits, 0) {} // no edge is (0, 0)
    // Writes the pair to `out`; returns 1 when it is to stay there.
    std::size_t pass(Pair pair, Pair *out) {
        Pair &last = seen_[(pair * 0x9E3779B97F4A7C15U) >> (64 - bits)];
        *out = pair;
        const std::size_t fresh = last != pair ? 1 : 0;
        last = pair;
        return fresh;
    }

private:
    static constexpr int bits = 14; // 128 KiB: fits a second-level cache
    std::vector<Pair> seen_;
};

// Appends the pairs of `count` cells; `out` has room for all of them. Returns the end.
template <CellType type>
Pair *find_pairs(const std::int32_t *cell, std::size_t count, Filter &filter, Pair *out) {
    static constexpr LocalPairs local = local_pairs(type);
    const int k = node_count(type);
    for (; count > 0; --count, cell += k) {
#pragma GCC unroll 12
        for (std::size_t e = 0; e < local.count; ++e) {
            out += filter.pass(pair_of(cell[local.nodes[e][0]], cell[local.nodes[e][1]]), out);
        }
    }
    return out;
}

// The corners of the hexahedron whose twelve tetrahedra, as split_hexahedra lists them, start at t.
std::array<std::int32_t, 8> corners_of_split(const std::int32_t *t) {
    return {t[0], t[1], t[4], t[5], t[8], t[13], t[12], t[9]};
}

bool is_split_hexahedron(const std::int32_t *t) {
    constexpr int faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                 {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
    const auto h = corners_of_split(t);
    const std::int32_t centre = t[3];
    bool same = true;
    for (const auto &f : faces) {
        const std::int32_t a = h[static_cast<std::size_t>(f[0])];
        const std::int32_t b = h[static_cast<std::size_t>(f[1])];
        const std::int32_t c = h[static_cast<std::size_t>(f[2])];
        const std::int32_t d = h[static_cast<std::size_t>(f[3])];
        same &= (t[0] == a) & (t[1] == b) & (t[4] == c) & (t[5] == d);
        same &= ((t[2] == d) & (t[6] == b)) | ((t[2] == c) & (t[6] == a));
        same &= (t[3] == centre) & (t[7] == centre);
        t += 8;
    }
    return same;
}

// A split hexahedron's tetrahedra name its 26 edges 72 times; here each once.
Pair *pairs_of_split(const std::int32_t *t, Filter &filter, Pair *out) {
    const auto h = corners_of_split(t);
    static constexpr LocalPairs local = local_pairs(CellType::hexahedron);
#pragma GCC unroll 12
    for (std::size_t e = 0; e < local.count; ++e) {
        out += filter.pass(pair_of(h[local.nodes[e][0]], h[local.nodes[e][1]]), out);
    }
#pragma GCC unroll 6
    for (int f = 0; f < 6; ++f) {
        const std::int32_t *face = t + 8 * f;
        out += filter.pass(pair_of(face[2], face[6]), out); // the diagonal
    }
#pragma GCC unroll 8
    for (const std::int32_t corner : h) {
        *out++ = pair_of(corner, t[3]);
    }
    return out;
}

template <>
Pair *find_pairs<CellType::tetra>(const std::int32_t *cell, std::size_t count, Filter &filter,
                                  Pair *out) {
    static constexpr LocalPairs local = local_pairs(CellType::tetra);
    while (count > 0) {
        if (count >= 12 && is_split_hexahedron(cell)) {
            out = pairs_of_split(cell, filter, out);
            cell += 48;
            count -= 12;
            continue;
        }
#pragma GCC unroll 6
        for (std::size_t e = 0; e < local.count; ++e) {
            out += filter.pass(pair_of(cell[local.nodes[e][0]], cell[local.nodes[e][1]]), out);
        }
        cell += 4;
        --count;
    }
    return out;
}

Pair *find_pairs(CellType type, const std::int32_t *cell, std::size_t count, Filter &filter,
                 Pair *out) {
    switch (type) {
    case CellType::line:
        return find_pairs<CellType::line>(cell, count, filter, out);
    case CellType::line3:
        return find_pairs<CellType::line3>(cell, count, filter, out);
    case CellType::triangle:
        return find_pairs<CellType::triangle>(cell, count, filter, out);
    case CellType::triangle6:
        return find_pairs<CellType::triangle6>(cell, count, filter, out);
    case CellType::quad:
        return find_pairs<CellType::quad>(cell, count, filter, out);
    case CellType::quad8:
        return find_pairs<CellType::quad8>(cell, count, filter, out);
    case CellType::tetra:
        return find_pairs<CellType::tetra>(cell, count, filter, out);
    case CellType::tetra10:
        return find_pairs<CellType::tetra10>(cell, count, filter, out);
    case CellType::pyramid:
        return find_pairs<CellType::pyramid>(cell, count, filter, out);
    case CellType::pyramid13:
        return find_pairs<CellType::pyramid13>(cell, count, filter, out);
    case CellType::wedge:
        return find_pairs<CellType::wedge>(cell, count, filter, out);
    case CellType::wedge15:
        return find_pairs<CellType::wedge15>(cell, count, filter, out);
    case CellType::hexahedron:
        return find_pairs<CellType::hexahedron>(cell, count, filter, out);
    default:
        return find_pairs<CellType::hexahedron20>(cell, count, filter, out);
    }
}

// Pairs found by one thread, in large pieces that never move.
struct PairStore {
    static constexpr std::size_t piece = 1 << 20;
    struct Piece {
        Array<Pair> pairs;
        std::size_t used = 0;
    };
    Filter filter;
    std::vector<Piece> pieces;

    Piece &room_for(std::size_t count) {
        if (pieces.empty() || pieces.back().pairs.size() - pieces.back().used < count) {
            pieces.push_back({Array<Pair>(std::max(piece, count))});
        }
        return pieces.back();
    }
};

// One store a thread at work, handed out and taken back.
class PairStores {
public:
    std::unique_ptr<PairStore> take() {
        const std::lock_guard lock(mutex_);
        if (stores_.empty()) {
            return std::make_unique<PairStore>();
        }
        auto store = std::move(stores_.back());
        stores_.pop_back();
        return store;
    }
    void give(std::unique_ptr<PairStore> store) {
        const std::lock_guard lock(mutex_);
        stores_.push_back(std::move(store));
    }
    std::vector<PairStore::Piece> pieces() && {
        std::vector<PairStore::Piece> all;
        for (auto &store : stores_) {
            std::move(store->pieces.begin(), store->pieces.end(), std::back_inserter(all));
        }
        return all;
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<PairStore>> stores_;
};

// All pairs, some of them repeatedly, in an order that depends on the threads; what is made of them
// does not.
std::vector<PairStore::Piece> all_pairs(std::size_t points, std::span<const CellView> cells,
                                        const Progress &progress) {
    PairStores stores;
    for (const CellView &view : cells) {
        const auto k = static_cast<std::size_t>(node_count(view.type));
        const std::size_t pairs_of_cell = local_pairs(view.type).count;
        parallel_for(
            view.size(), 12 << 12,
            [&](std::size_t first, std::size_t last) {
                auto store = stores.take();
                // Checked piece by piece, while the piece is in the cache.
                constexpr std::size_t piece = 12 << 8;
                for (std::size_t c = first; c < last; c += piece) {
                    const std::size_t some = std::min(last - c, piece);
                    const auto nodes = view.nodes.subspan(c * k, some * k);
                    bool wrong = false;
                    for (const std::int32_t node : nodes) {
                        wrong |= static_cast<std::uint32_t>(node) >= points;
                    }
                    if (wrong) {
                        check_nodes(cells, points); // says which
                    }
                    auto &room = store->room_for(some * pairs_of_cell);
                    Pair *const begin = room.pairs.data() + room.used;
                    Pair *const end =
                        find_pairs(view.type, nodes.data(), some, store->filter, begin);
                    room.used += static_cast<std::size_t>(end - begin);
                }
                stores.give(std::move(store));
            },
            progress, 0.0, 0.4);
    }
    return std::move(stores).pieces();
}

// Called for each node of the loops below.
void poll_now_and_then(std::size_t node, const Progress &progress, double fraction) {
    if (node % (1 << 16) == 0) {
        poll(progress, fraction);
    }
}

// Nodes of the pairs, by their lower node: those of n from start[n] on; start has points + 1.
struct Rows {
    Array<std::int64_t> start;
    Array<std::int32_t> nodes;
};

void accumulate(Array<std::int64_t> &counts) {
    for (std::size_t n = 1; n < counts.size(); ++n) {
        counts[n] += counts[n - 1];
    }
}

Rows by_lower_node(std::size_t points, std::vector<PairStore::Piece> &&pieces,
                   const Progress &progress) {
    // Counts go one place further than usual: filling then leaves every start in its own place.
    Rows rows{Array<std::int64_t>(points + 2), {}};
    std::fill(rows.start.begin(), rows.start.end(), 0);
    for (const auto &piece : pieces) {
        for (const Pair pair : std::span(piece.pairs.data(), piece.used)) {
            ++rows.start[low(pair) + 2];
        }
        poll(progress, 0.45);
    }
    accumulate(rows.start);
    rows.nodes = Array<std::int32_t>(static_cast<std::size_t>(rows.start[points + 1]));
    for (auto &piece : pieces) {
        for (const Pair pair : std::span(piece.pairs.data(), piece.used)) {
            rows.nodes[static_cast<std::size_t>(rows.start[low(pair) + 1]++)] =
                static_cast<std::int32_t>(high(pair));
        }
        piece = {};
        poll(progress, 0.55);
    }
    return rows;
}

// Moves the different nodes of each row to its front; returns how many they are, and adds what each
// node will have in the end to counts[node + 1].
Array<std::int32_t> keep_different(std::size_t points, Rows &rows, Array<std::int64_t> &counts,
                                   const Progress &progress) {
    Array<std::int32_t> kept(points);
    Array<std::int32_t> mark(points);
    std::fill(mark.begin(), mark.end(), -1);
    for (std::size_t n = 0; n < points; ++n) {
        poll_now_and_then(n, progress, 0.6);
        std::int32_t *const begin = rows.nodes.data() + rows.start[n];
        std::int32_t *const end = rows.nodes.data() + rows.start[n + 1];
        std::int32_t *out = begin;
        for (const std::int32_t *node = begin; node != end; ++node) {
            const auto other = static_cast<std::size_t>(*node);
            const int fresh = mark[other] != static_cast<std::int32_t>(n) ? 1 : 0;
            mark[other] = static_cast<std::int32_t>(n);
            counts[other + 1] += fresh;
            *out = *node;
            out += fresh;
        }
        kept[n] = static_cast<std::int32_t>(out - begin);
        counts[n + 1] += kept[n];
    }
    return kept;
}

} // namespace

RelatedNodes related_nodes(std::size_t points, std::span<const CellView> cells,
                           const Progress &progress) {
    Rows rows = by_lower_node(points, all_pairs(points, cells, progress), progress);
    RelatedNodes result{Array<std::int64_t>(points + 1), {}};
    std::fill(result.offsets.begin(), result.offsets.end(), 0);
    const Array<std::int32_t> kept = keep_different(points, rows, result.offsets, progress);
    accumulate(result.offsets);
    poll(progress, 0.7);

    // Taking the nodes in ascending order sorts the rows without comparing: first the lower related
    // nodes of each, then, from what that wrote, the higher ones behind them.
    result.neighbours = Array<std::int32_t>(static_cast<std::size_t>(result.offsets[points]));
    std::int32_t *const out = result.neighbours.data();
    Array<std::int64_t> next(points);
    std::copy_n(result.offsets.begin(), points, next.begin());
    for (std::size_t n = 0; n < points; ++n) {
        poll_now_and_then(n, progress, 0.75);
        const std::int32_t *node = rows.nodes.data() + rows.start[n];
        for (std::int32_t i = 0; i < kept[n]; ++i) {
            out[next[static_cast<std::size_t>(node[i])]++] = static_cast<std::int32_t>(n);
        }
    }
    poll(progress, 0.85);
    for (std::size_t n = 0; n < points; ++n) {
        poll_now_and_then(n, progress, 0.9);
        const std::int32_t *node = out + result.offsets[n];
        const std::int32_t *const end = out + result.offsets[n + 1] - kept[n];
        for (; node != end; ++node) {
            out[next[static_cast<std::size_t>(*node)]++] = static_cast<std::int32_t>(n);
        }
    }
    poll(progress, 1.0);
    return result;
}

} // namespace nmgs
