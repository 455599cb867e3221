// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/topology.h"

#include "nmgs/blocking/lattice.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/support/error.h"

#include <gtest/gtest.h>

namespace {

using namespace nmgs;

// Boxes of the given height on top of each other, one division each.
BlockModel stack(double height, int boxes) {
    BlockModel model;
    for (int b = 0; b < boxes; ++b) {
        for (const auto &at : hexa20::natural) {
            model.nodes.push_back(
                {0.5 * (at[0] + 1), 0.5 * (at[1] + 1), height * (b + 0.5 * (at[2] + 1))});
        }
        model.divisions.push_back({1, 1, 1});
    }
    return model;
}

std::int64_t nodes(const BlockModel &model) {
    validate(model);
    const Topology topology = find_topology(model);
    return Lattice(model, topology).node_count();
}

TEST(Topology, SharesByPlaceWithoutNumbers) {
    EXPECT_EQ(nodes(stack(1, 2)), 12);
}

TEST(Topology, SharesByNumberAlone) {
    BlockModel model = stack(1, 2);
    model.corners = {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11};
    EXPECT_EQ(nodes(model), 12);
    const Topology topology = find_topology(model);
    // The upper box's bottom is the lower one's top.
    EXPECT_EQ(topology.of(1, part::code(1, 1, 0)).block, 0);
    EXPECT_EQ(topology.of(1, part::code(1, 1, 0)).part, part::code(1, 1, 2));
    // Touching, but not sharing.
    model.corners = {0, 1, 2, 3, 4, 5, 6, 7, 14, 15, 16, 17, 8, 9, 10, 11};
    EXPECT_EQ(nodes(model), 16);
    // So thin that all its heights are one place to any tolerance that others would bear.
    model = stack(1e-12, 1);
    model.corners = {0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(nodes(model), 8);
}

TEST(Topology, OnlyEdgesThatAreSharedShareAnEdge) {
    // Two boxes that touch along a face and share one edge of it.
    BlockModel model = stack(1, 2);
    model.corners = {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 16, 17, 8, 9, 10, 11};
    const Topology topology = find_topology(model);
    EXPECT_EQ(topology.of(1, part::code(1, 0, 0)).block, 0);
    EXPECT_TRUE(topology.owns(1, part::code(1, 2, 0)));
    EXPECT_TRUE(topology.owns(1, part::code(1, 1, 0)));
}

TEST(Topology, NumbersAreChecked) {
    BlockModel model = stack(1, 1);
    model.corners = {0, 1, 2};
    EXPECT_THROW(validate(model), ArgumentError);
    model.corners = {0, 1, 2, 3, 4, 5, 6, -7};
    EXPECT_THROW(validate(model), ArgumentError);
}

} // namespace
