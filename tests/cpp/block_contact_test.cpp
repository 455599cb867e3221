// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/block_contact.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <gtest/gtest.h>

namespace {

using nmgs::BlockModel;
using nmgs::Vec3;

void add_box(BlockModel &model, Vec3 low, Vec3 size, std::array<std::int32_t, 3> divisions) {
    for (const auto &p : nmgs::hexa20::natural) {
        model.nodes.push_back({low.x + 0.5 * (p[0] + 1) * size.x, low.y + 0.5 * (p[1] + 1) * size.y,
                               low.z + 0.5 * (p[2] + 1) * size.z});
    }
    model.divisions.push_back(divisions);
}

// A rectangle from a corner along u and v.
void add_patch(BlockModel &model, Vec3 corner, Vec3 u, Vec3 v, std::int32_t n) {
    model.dimension = 2;
    for (const auto &p : nmgs::quad8::natural) {
        model.nodes.push_back(corner + 0.5 * (p[0] + 1) * u + 0.5 * (p[1] + 1) * v);
    }
    model.divisions.push_back({n, n, 0});
}

std::vector<nmgs::Contact> contacts(const BlockModel &model) {
    return nmgs::find_bad_contacts(model, nmgs::find_topology(model), 0.01);
}

TEST(BlockContact, AFaceInsideAnother) {
    for (const bool fits : {true, false}) {
        BlockModel model;
        add_box(model, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
        add_box(model, {1, 1, 1}, {2, 2, 1}, {fits ? 2 : 3, 2, 1});
        const auto found = contacts(model);
        ASSERT_EQ(found.size(), fits ? 0U : 1U);
        if (!fits) {
            EXPECT_EQ(found[0].block_a + found[0].block_b, 1U);
            EXPECT_NEAR(found[0].place.z, 1, 1e-12);
            EXPECT_NEAR(found[0].distance, 0, 1e-12);
        }
    }
}

TEST(BlockContact, AnEdgeInsideAFace) {
    for (const bool fits : {true, false}) {
        BlockModel model;
        add_box(model, {0, 0, 0}, {4, 1, 1}, {4, 4, 4});
        add_box(model, {0, 0, 0}, {1, 1, 1}, {4, fits ? 4 : 3, 4});
        for (std::size_t i = 20; i < 40; ++i) { // stands on its edge along y, at x = 2
            const Vec3 p = model.nodes[i];
            model.nodes[i] = {2 + p.x - p.z, p.y, 1 + p.x + p.z};
        }
        const auto found = contacts(model);
        ASSERT_EQ(found.size(), fits ? 0U : 1U);
        if (!fits) {
            EXPECT_NEAR(found[0].place.x, 2, 1e-12);
            EXPECT_NEAR(found[0].place.z, 1, 1e-12);
        }
    }
}

TEST(BlockContact, APatchOnAnother) {
    BlockModel model;
    add_patch(model, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4);
    add_patch(model, {1, 2, 0}, {2, 0, 0}, {0, 0, 1}, 2);
    const auto found = contacts(model);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].block_a, 1U);
    EXPECT_EQ(found[0].block_b, 0U);
    EXPECT_FALSE(found[0].overlap);
    EXPECT_NEAR(found[0].place.y, 2, 1e-12);

    BlockModel flat;
    add_patch(flat, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4);
    add_patch(flat, {1, 1, 0}, {2, 0, 0}, {0, 1, 0}, 2);
    ASSERT_EQ(contacts(flat).size(), 1U);
    EXPECT_TRUE(contacts(flat)[0].overlap);
}

TEST(BlockContact, NothingTouches) {
    BlockModel model;
    add_patch(model, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4);
    add_patch(model, {4, 0, 0}, {0, 0, 1}, {0, 4, 0}, 4);   // shares an edge
    add_patch(model, {1, 1, 0.5}, {1, 0, 0}, {0, 0, 1}, 4); // is above
    EXPECT_TRUE(contacts(model).empty());
}

} // namespace
