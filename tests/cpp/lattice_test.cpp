// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/lattice.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace {

using nmgs::BlockModel;
using nmgs::Lattice;
using nmgs::LatticeIndex;

// A row of blocks along x, every other one numbered the other way round along x and y.
BlockModel row_of_blocks(int count, LatticeIndex divisions) {
    BlockModel model;
    for (int b = 0; b < count; ++b) {
        const double turn = b % 2 == 0 ? 1 : -1;
        for (const auto &p : nmgs::hexa20::natural) {
            model.nodes.push_back({turn * p[0] + 2 * b, turn * p[1], p[2]});
        }
        model.divisions.push_back(divisions);
    }
    return model;
}

// Every place has one number, every number one place, numbers run from 0 without a gap.
TEST(Lattice, NumbersArePlaces) {
    const LatticeIndex n{3, 4, 2};
    const BlockModel model = row_of_blocks(3, n);
    const auto topology = nmgs::find_topology(model);
    const Lattice lattice(model, topology);
    EXPECT_EQ(lattice.node_count(), (3 * 3 + 1) * 5 * 3);
    EXPECT_EQ(lattice.first_cell(3), 3 * 24);
    std::map<std::array<int, 3>, std::int64_t> number;
    std::set<std::int64_t> numbers;
    for (std::size_t b = 0; b < 3; ++b) {
        const bool turned = b % 2 == 1;
        for (std::int32_t k = 0; k <= n[2]; ++k) {
            for (std::int32_t j = 0; j <= n[1]; ++j) {
                std::vector<std::int32_t> row(static_cast<std::size_t>(n[0]) + 1);
                lattice.row(b, j, k, row);
                for (std::int32_t i = 0; i <= n[0]; ++i) {
                    const std::int64_t node = lattice.node(b, {i, j, k});
                    EXPECT_EQ(row[static_cast<std::size_t>(i)], node);
                    const std::array<int, 3> place{static_cast<int>(b) * n[0] +
                                                       (turned ? n[0] - i : i),
                                                   turned ? n[1] - j : j, k};
                    const auto [found, fresh] = number.emplace(place, node);
                    EXPECT_EQ(found->second, node);
                    EXPECT_EQ(fresh, lattice.owns(b, {i, j, k}));
                    EXPECT_EQ(fresh, node >= lattice.first_node(b));
                    numbers.insert(node);
                }
            }
        }
    }
    EXPECT_EQ(static_cast<std::int64_t>(number.size()), lattice.node_count());
    EXPECT_EQ(*numbers.begin(), 0);
    EXPECT_EQ(*numbers.rbegin(), lattice.node_count() - 1);
    EXPECT_EQ(static_cast<std::int64_t>(numbers.size()), lattice.node_count());
}

TEST(Lattice, OnePatchOfOneElement) {
    BlockModel model;
    model.dimension = 2;
    for (const auto &p : nmgs::quad8::natural) {
        model.nodes.push_back({p[0], p[1], 0});
    }
    model.divisions.push_back({1, 1, 0});
    const auto topology = nmgs::find_topology(model);
    const Lattice lattice(model, topology);
    EXPECT_EQ(lattice.node_count(), 4);
    EXPECT_EQ(lattice.first_cell(1), 1);
    EXPECT_EQ(lattice.node(0, {1, 1, 0}), 3);
    EXPECT_EQ(lattice.part_of(0, {0, 1, 0}), nmgs::part::code(0, 2, 0));
}

} // namespace
