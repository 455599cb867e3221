// SPDX-License-Identifier: LGPL-2.1-or-later
// Node numbers of a model's lattices without a table: the nodes are numbered block by block, xi
// fastest, and a node that a lower-numbered block made keeps that number (thesis 4.4.1 ii).
#pragma once

#include "nmgs/blocking/topology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

using LatticeIndex = std::array<std::int32_t, 3>;

class Lattice {
public:
    // Keeps references to both; they must outlive it.
    Lattice(const BlockModel &model, const Topology &topology);

    // Nodes of the whole model after sharing.
    [[nodiscard]] std::int64_t node_count() const { return first_.back(); }
    // Number of the first node that the block owns; node_count() for block == model.size().
    [[nodiscard]] std::int64_t first_node(std::size_t block) const { return first_[block]; }
    // Number of the first cell of the block; the cell count for block == model.size().
    [[nodiscard]] std::int64_t first_cell(std::size_t block) const { return first_cell_[block]; }

    // Divisions of the block, 0 along zeta of a patch.
    [[nodiscard]] LatticeIndex divisions(std::size_t block) const {
        return model_.divisions[block];
    }
    // Part of the block on which the node lies.
    [[nodiscard]] int part_of(std::size_t block, LatticeIndex at) const;
    // Number of any node of any block.
    [[nodiscard]] std::int64_t node(std::size_t block, LatticeIndex at) const;
    // Whether the block is the first to have the node.
    [[nodiscard]] bool owns(std::size_t block, LatticeIndex at) const {
        return owned_[block * part::count + static_cast<std::size_t>(part_of(block, at))];
    }
    // Numbers of the nodes (0..divisions[0], j, k), in order.
    void row(std::size_t block, std::int32_t j, std::int32_t k, std::span<std::int32_t> ids) const;

    // Number of the first node that the block owns in row (j, k), and which of the row's three
    // pieces (low end, inside, high end) it owns.
    struct RowPieces {
        std::int64_t start;
        bool low, inside, high;
    };
    [[nodiscard]] RowPieces row_pieces(std::size_t block, std::int32_t j, std::int32_t k) const;

private:
    [[nodiscard]] std::int64_t row_start(std::size_t block, std::int32_t j, std::int32_t k) const;
    [[nodiscard]] std::int64_t owned_node(std::size_t block, LatticeIndex at) const;
    [[nodiscard]] std::int64_t shared_node(const Owner &owner, int code, LatticeIndex at) const;

    // How many nodes of a row, and of a layer of rows, the block owns, by the row's part digits.
    struct Counts {
        std::array<std::array<std::int64_t, 3>, 3> row; // [eta digit][zeta digit]
        std::array<std::int64_t, 3> layer;              // [zeta digit]
    };

    const BlockModel &model_;
    const Topology &topology_;
    std::vector<char> owned_;
    std::vector<Counts> counts_;
    std::vector<std::int64_t> first_;
    std::vector<std::int64_t> first_cell_;
};

} // namespace nmgs
