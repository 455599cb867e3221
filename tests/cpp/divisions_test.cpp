// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/divisions.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using nmgs::BlockModel;
using nmgs::Vec3;

// Squares beside each other along x.
BlockModel row(int count) {
    BlockModel model;
    model.dimension = 2;
    for (int b = 0; b < count; ++b) {
        for (const auto &p : nmgs::quad8::natural) {
            model.nodes.push_back({0.5 * (p[0] + 1) + b, 0.5 * (p[1] + 1), 0});
        }
        model.divisions.push_back({1 + b, 2 + b, 0});
    }
    return model;
}

TEST(Divisions, ArcLengthOfAParabola) {
    // y = x^2 on [-1, 1]: sqrt(5) + asinh(2) / 2.
    EXPECT_NEAR(nmgs::edge_length({-1, 1, 0}, {0, 0, 0}, {1, 1, 0}),
                std::sqrt(5) + 0.5 * std::asinh(2), 1e-7);
    EXPECT_NEAR(nmgs::edge_length({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), std::sqrt(12), 1e-14);
}

TEST(Divisions, ChainsOfARow) {
    const auto model = row(3);
    const auto chains = nmgs::find_chains(model, nmgs::find_topology(model));
    EXPECT_EQ(chains.count, 4);
    EXPECT_EQ(chains.chain, (std::vector<std::int32_t>{0, 1, 2, 1, 3, 1}));
}

TEST(Divisions, ReversedDirectionsAreKnown) {
    auto model = row(2);
    // The second square's numbering is turned by half a turn.
    const std::array<std::size_t, 8> turned{2, 3, 0, 1, 6, 7, 4, 5};
    const std::vector<Vec3> old(model.nodes.begin() + 8, model.nodes.end());
    for (std::size_t i = 0; i < 8; ++i) {
        model.nodes[8 + i] = old[turned[i]];
    }
    const auto chains = nmgs::find_chains(model, nmgs::find_topology(model));
    EXPECT_EQ(chains.chain[1], chains.chain[3]);
    EXPECT_NE(chains.reversed[1], chains.reversed[3]);
    EXPECT_EQ(chains.twisted, std::vector<char>(3, 0));
}

TEST(Divisions, WishesByRank) {
    const auto model = row(3);
    const auto topology = nmgs::find_topology(model);
    const std::vector<nmgs::DivisionWish> wishes{
        {0, 1, 9, false}, {1, 1, 4, true}, {1, 0, 5, false}, {1, 0, 3, false}};
    const auto by_size = nmgs::solve_divisions(model, topology, wishes, 0.1);
    EXPECT_EQ(by_size[0], (std::array<std::int32_t, 3>{10, 4, 0}));
    EXPECT_EQ(by_size[1], (std::array<std::int32_t, 3>{5, 4, 0}));
    const auto as_is = nmgs::solve_divisions(model, topology, {}, 0);
    EXPECT_EQ(as_is[0], (std::array<std::int32_t, 3>{1, 4, 0}));
}

TEST(Divisions, ContradictionsNameTheChain) {
    const auto model = row(4);
    const std::vector<nmgs::DivisionWish> wishes{{3, 1, 4, true}, {0, 1, 3, true}};
    try {
        nmgs::solve_divisions(model, nmgs::find_topology(model), wishes);
        FAIL() << "expected BlockingError";
    } catch (const nmgs::BlockingError &e) {
        EXPECT_EQ(e.entities, (std::vector<std::string>{"Block4", "Block3", "Block2", "Block1"}));
    }
}

TEST(Divisions, WrongArguments) {
    const auto model = row(1);
    const auto topology = nmgs::find_topology(model);
    for (const nmgs::DivisionWish wish :
         {nmgs::DivisionWish{1, 0, 1, true}, {-1, 0, 1, true}, {0, 2, 1, true}, {0, 0, 0, true}}) {
        EXPECT_THROW(nmgs::solve_divisions(model, topology, {&wish, 1}), nmgs::ArgumentError);
    }
    EXPECT_THROW(nmgs::solve_divisions(model, topology, {}, -1), nmgs::ArgumentError);
    EXPECT_THROW(nmgs::solve_divisions(model, topology, {}, NAN), nmgs::ArgumentError);
}

} // namespace
