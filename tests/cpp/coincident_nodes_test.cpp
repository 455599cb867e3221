// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/coincident_nodes.h"

#include "nmgs/blocking/block_check.h"
#include "nmgs/blocking/generate.h"
#include "nmgs/element/hexa20.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace {

using nmgs::BlockModel;
using nmgs::Vec3;

void add_box(BlockModel &model, Vec3 low, Vec3 size, std::array<std::int32_t, 3> divisions) {
    for (const auto &p : nmgs::hexa20::natural) {
        model.nodes.push_back({low.x + 0.5 * size.x * (p[0] + 1), low.y + 0.5 * size.y * (p[1] + 1),
                               low.z + 0.5 * size.z * (p[2] + 1)});
    }
    model.divisions.push_back(divisions);
}

// A box on two others that share a face.
BlockModel tee(std::int32_t wide) {
    BlockModel model;
    add_box(model, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
    add_box(model, {1, 0, 0}, {1, 1, 1}, {2, 2, 2});
    add_box(model, {0, 0, 1}, {2, 1, 1}, {wide, 2, 2});
    return model;
}

TEST(CoincidentNodes, OneNodeAPlace) {
    const auto mesh = nmgs::generate(tee(4));
    std::set<std::array<double, 3>> places;
    for (const Vec3 &p : mesh.points) {
        places.insert({p.x, p.y, p.z});
    }
    EXPECT_EQ(mesh.points.size(), 5U * 3 * 5);
    EXPECT_EQ(places.size(), mesh.points.size());
    std::set<std::int32_t> used(mesh.cells[0].nodes.begin(), mesh.cells[0].nodes.end());
    EXPECT_EQ(used.size(), mesh.points.size());
    EXPECT_EQ(*used.rbegin(), static_cast<std::int32_t>(mesh.points.size()) - 1);
}

TEST(CoincidentNodes, NothingToDoForWholeFaces) {
    BlockModel model;
    add_box(model, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
    add_box(model, {1, 0, 0}, {1, 1, 1}, {2, 2, 2});
    const auto topology = nmgs::find_topology(model);
    const nmgs::Lattice lattice(model, topology);
    std::vector<Vec3> points(static_cast<std::size_t>(lattice.node_count()));
    nmgs::fill_points(model, lattice, points);
    const auto found = nmgs::find_coincident_nodes(model, topology, lattice, points);
    EXPECT_TRUE(found.number.empty());
    EXPECT_EQ(found.remaining, 5 * 3 * 3);
}

TEST(CoincidentNodes, DivisionsThatDoNotFitAreAProblem) {
    const auto model = tee(3);
    const auto problems = nmgs::check_blocks(model, nmgs::find_topology(model));
    ASSERT_EQ(problems.size(), 2U);
    for (const auto &problem : problems) {
        EXPECT_EQ(problem.kind, nmgs::ProblemKind::divisions);
        EXPECT_NEAR(problem.place.z, 1, 1e-12);
    }
}

} // namespace
