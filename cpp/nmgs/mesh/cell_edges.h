// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of cells, one after the other, to whoever takes them: a node and its mid-side node
// count as an edge, the ends of a quadratic edge not. Templates, for loops that handle each edge in
// a few nanoseconds.
#pragma once

#include "nmgs/mesh/cell_topology.h"

#include <array>
#include <cstdint>
#include <span>

namespace nmgs {

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

// Calls edge(a, b) for the edges of `count` cells.
template <CellType type, class Edge>
void for_edges(const std::int32_t *cell, std::size_t count, Edge &edge) {
    static constexpr LocalPairs local = local_pairs(type);
    const int k = node_count(type);
    for (; count > 0; --count, cell += k) {
#pragma GCC unroll 12
        for (std::size_t e = 0; e < local.count; ++e) {
            edge(cell[local.nodes[e][0]], cell[local.nodes[e][1]]);
        }
    }
}

// The corners of the hexahedron whose twelve tetrahedra, as split_hexahedra lists them, start at t.
inline std::array<std::int32_t, 8> corners_of_split(const std::int32_t *t) {
    return {t[0], t[1], t[4], t[5], t[8], t[13], t[12], t[9]};
}

inline bool is_split_hexahedron(const std::int32_t *t) {
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

// The edges of split hexahedra that follow each other. Their tetrahedra name 26 edges 72 times;
// here each comes once, and those that a hexahedron shares with the one before it not again. They
// are handed on in batches, first the first edge of each hexahedron and so on: what comes one after
// the other then belongs to different nodes, whose rows a processor fills at the same time.
template <class Edge>
class SplitEdges {
public:
    explicit SplitEdges(Edge &edge) : edge_(edge) {}
    void add(const std::int32_t *t) {
        const auto h = corners_of_split(t);
        if (before_ == nullptr || !follows(h, t)) {
            edge_(h[0], h[3]);
            edge_(h[4], h[7]);
            edge_(h[0], h[4]);
            edge_(h[3], h[7]);
            edge_(t[42], t[46]);
        }
        static constexpr std::array<std::array<std::uint8_t, 2>, 8> others{
            {{0, 1}, {1, 2}, {2, 3}, {4, 5}, {5, 6}, {6, 7}, {1, 5}, {2, 6}}};
#pragma GCC unroll 8
        for (std::size_t e = 0; e < 8; ++e) {
            ends_[e][count_] = {h[others[e][0]], h[others[e][1]]};
        }
#pragma GCC unroll 5
        for (std::size_t f = 0; f < 5; ++f) {
            ends_[8 + f][count_] = {t[8 * f + 2], t[8 * f + 6]}; // the diagonal
        }
#pragma GCC unroll 8
        for (std::size_t c = 0; c < 8; ++c) {
            corners_[c][count_] = h[c];
        }
        inside_[count_] = t[3];
        before_ = t;
        if (++count_ == batch) {
            flush();
        }
    }
    void flush() {
        for (const auto &same : ends_) {
            for (std::size_t i = 0; i < count_; ++i) {
                edge_(same[i][0], same[i][1]);
            }
        }
        edge_.stars(corners_, {inside_.data(), count_});
        count_ = 0;
        before_ = nullptr;
    }

private:
    static constexpr std::size_t batch = 128;

    // Whether the last face of this hexahedron is the fourth one of that before, split the same
    // way.
    bool follows(const std::array<std::int32_t, 8> &h, const std::int32_t *t) const {
        const auto b = corners_of_split(before_);
        const std::int32_t *diagonal = before_ + 24;
        return b[1] == h[0] && b[2] == h[3] && b[5] == h[4] && b[6] == h[7] &&
               ((diagonal[2] == t[42] && diagonal[6] == t[46]) ||
                (diagonal[2] == t[46] && diagonal[6] == t[42]));
    }

    Edge &edge_;
    const std::int32_t *before_ = nullptr;
    std::size_t count_ = 0;
    std::array<std::array<std::array<std::int32_t, 2>, batch>, 13> ends_;
    std::array<std::array<std::int32_t, batch>, 8> corners_;
    std::array<std::int32_t, batch> inside_;
};

template <class Edge>
void for_edges_of_tetra(const std::int32_t *cell, std::size_t count, Edge &edge) {
    SplitEdges split(edge);
    while (count > 0) {
        if (count >= 12 && is_split_hexahedron(cell)) {
            split.add(cell);
            cell += 48;
            count -= 12;
        } else {
            for_edges<CellType::tetra>(cell, 1, edge);
            cell += 4;
            --count;
        }
    }
    split.flush();
}

template <class Edge>
void for_edges(CellType type, const std::int32_t *cell, std::size_t count, Edge &edge) {
    switch (type) {
    case CellType::line:
        return for_edges<CellType::line>(cell, count, edge);
    case CellType::line3:
        return for_edges<CellType::line3>(cell, count, edge);
    case CellType::triangle:
        return for_edges<CellType::triangle>(cell, count, edge);
    case CellType::triangle6:
        return for_edges<CellType::triangle6>(cell, count, edge);
    case CellType::quad:
        return for_edges<CellType::quad>(cell, count, edge);
    case CellType::quad8:
        return for_edges<CellType::quad8>(cell, count, edge);
    case CellType::tetra:
        return for_edges_of_tetra(cell, count, edge);
    case CellType::tetra10:
        return for_edges<CellType::tetra10>(cell, count, edge);
    case CellType::pyramid:
        return for_edges<CellType::pyramid>(cell, count, edge);
    case CellType::pyramid13:
        return for_edges<CellType::pyramid13>(cell, count, edge);
    case CellType::wedge:
        return for_edges<CellType::wedge>(cell, count, edge);
    case CellType::wedge15:
        return for_edges<CellType::wedge15>(cell, count, edge);
    case CellType::hexahedron:
        return for_edges<CellType::hexahedron>(cell, count, edge);
    default:
        return for_edges<CellType::hexahedron20>(cell, count, edge);
    }
}

} // namespace nmgs
