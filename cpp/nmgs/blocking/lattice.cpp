// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/lattice.h"

#include <utility>

namespace nmgs {
namespace {

int digit(std::int32_t at, std::int32_t divisions) {
    return at == 0 ? 0 : at == divisions ? 2 : 1;
}

} // namespace

Lattice::Lattice(const BlockModel &model, const Topology &topology)
    : model_(model), topology_(topology), owned_(model.size() * part::count), counts_(model.size()),
      first_(model.size() + 1, 0), first_cell_(model.size() + 1, 0) {
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < part::count; ++code) {
            owned_[b * part::count + static_cast<std::size_t>(code)] =
                topology.owns(b, code) ? 1 : 0;
        }
        const auto g = model.divisions[b];
        Counts &counts = counts_[b];
        for (int c = 0; c < 3; ++c) {
            for (int e = 0; e < 3; ++e) {
                const auto owned = [&](int a) -> std::int64_t {
                    return owned_[b * part::count + static_cast<std::size_t>(part::code(a, e, c))];
                };
                counts.row[static_cast<std::size_t>(e)][static_cast<std::size_t>(c)] =
                    owned(0) + owned(1) * (g[0] - 1) + owned(2);
            }
            const auto of = [&](std::size_t e) {
                return counts.row[e][static_cast<std::size_t>(c)];
            };
            counts.layer[static_cast<std::size_t>(c)] = of(0) + of(1) * (g[1] - 1) + of(2);
        }
        const bool solid = model.dimension == 3;
        first_[b + 1] = first_[b] + counts.layer[0] +
                        (solid ? counts.layer[1] * (g[2] - 1) + counts.layer[2] : 0);
        first_cell_[b + 1] = first_cell_[b] + std::int64_t{g[0]} * g[1] * (solid ? g[2] : 1);
    }
}

int Lattice::part_of(std::size_t block, LatticeIndex at) const {
    const auto g = model_.divisions[block];
    return part::code(digit(at[0], g[0]), digit(at[1], g[1]),
                      model_.dimension == 3 ? digit(at[2], g[2]) : 0);
}

std::int64_t Lattice::row_start(std::size_t block, std::int32_t j, std::int32_t k) const {
    const Counts &counts = counts_[block];
    const auto g = model_.divisions[block];
    const auto c = static_cast<std::size_t>(model_.dimension == 3 ? digit(k, g[2]) : 0);
    std::int64_t start = first_[block];
    if (k > 0) {
        start += counts.layer[0] + counts.layer[1] * (k - 1);
    }
    if (j > 0) {
        start += counts.row[0][c] + counts.row[1][c] * (j - 1);
    }
    return start;
}

Lattice::RowPieces Lattice::row_pieces(std::size_t block, std::int32_t j, std::int32_t k) const {
    const auto at = block * part::count + static_cast<std::size_t>(part_of(block, {0, j, k}));
    return {row_start(block, j, k), owned_[at] != 0, owned_[at + 1] != 0, owned_[at + 2] != 0};
}

std::int64_t Lattice::owned_node(std::size_t block, LatticeIndex at) const {
    const RowPieces pieces = row_pieces(block, at[1], at[2]);
    std::int64_t id = pieces.start;
    if (at[0] > 0) {
        id += pieces.low ? 1 : 0;
        id += pieces.inside ? at[0] - 1 : 0;
    }
    return id;
}

std::int64_t Lattice::shared_node(const Owner &owner, int code, LatticeIndex at) const {
    const auto ob = static_cast<std::size_t>(owner.block);
    const auto g = model_.divisions[ob];
    const auto digits = part::digits(owner.part);
    LatticeIndex there{};
    for (std::size_t d = 0; d < 3; ++d) {
        there[d] = digits[d] == 2 ? g[d] : 0;
    }
    const auto mine = part::axes(code);
    const auto theirs = part::axes(owner.part);
    std::array<std::int32_t, 2> t{};
    for (int d = 0; d < mine.count; ++d) {
        t[static_cast<std::size_t>(d)] =
            at[static_cast<std::size_t>(mine.axis[static_cast<std::size_t>(d)])];
    }
    if ((owner.flip & 4) != 0) {
        std::swap(t[0], t[1]);
    }
    for (int d = 0; d < theirs.count; ++d) {
        const auto axis = static_cast<std::size_t>(theirs.axis[static_cast<std::size_t>(d)]);
        const std::int32_t value = t[static_cast<std::size_t>(d)];
        there[axis] = (owner.flip & (1 << d)) != 0 ? g[axis] - value : value;
    }
    return owned_node(ob, there);
}

std::int64_t Lattice::node(std::size_t block, LatticeIndex at) const {
    const int code = part_of(block, at);
    return owned_[block * part::count + static_cast<std::size_t>(code)] != 0
               ? owned_node(block, at)
               : shared_node(topology_.of(block, code), code, at);
}

void Lattice::row(std::size_t block, std::int32_t j, std::int32_t k,
                  std::span<std::int32_t> ids) const {
    const std::int32_t n = model_.divisions[block][0];
    const RowPieces pieces = row_pieces(block, j, k);
    std::int64_t next = pieces.start;
    ids[0] = static_cast<std::int32_t>(pieces.low ? next++ : node(block, {0, j, k}));
    if (pieces.inside) {
        const auto base = static_cast<std::int32_t>(next) - 1;
        for (std::int32_t i = 1; i < n; ++i) {
            ids[static_cast<std::size_t>(i)] = base + i;
        }
        next += n - 1;
    } else {
        // Inside a part of the owner its numbers go up, or down, by one step.
        const int code = part_of(block, {1, j, k});
        const Owner &owner = topology_.of(block, n > 1 ? code : 0);
        const std::int64_t first = n > 1 ? shared_node(owner, code, {1, j, k}) : 0;
        const std::int64_t step = n > 2 ? shared_node(owner, code, {2, j, k}) - first : 0;
        for (std::int32_t i = 1; i < n; ++i) {
            ids[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(first + (i - 1) * step);
        }
    }
    ids[static_cast<std::size_t>(n)] =
        static_cast<std::int32_t>(pieces.high ? next : node(block, {n, j, k}));
}

} // namespace nmgs
