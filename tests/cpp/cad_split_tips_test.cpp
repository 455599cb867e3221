// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/split_tips.h"

#include "nmgs/blocking/default_divisions.h"
#include "nmgs/quality/quality.h"
#include "nmgs_cad/generate_on_cad.h"
#include "nmgs_cad/solid_layout.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace {

using namespace nmgs;
using namespace nmgs::cad;

TopoDS_Edge arc(const gp_Pnt &a, const gp_Pnt &b, const gp_Pnt &c) {
    return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, b, c).Value()).Edge();
}

TopoDS_Edge line(const gp_Pnt &a, const gp_Pnt &b) {
    return BRepBuilderAPI_MakeEdge(a, b).Edge();
}

const double half = std::sqrt(0.5);

// Four sides, of which a quarter of a circle leaves the top straight on, at (1, 1): 1 high, 2 wide
// at the bottom, 3 long.
TopoDS_Shape rounded() {
    BRepBuilderAPI_MakeWire wire;
    wire.Add(line({0, 0, 0}, {2, 0, 0}));
    wire.Add(arc({2, 0, 0}, {1 + half, half, 0}, {1, 1, 0}));
    wire.Add(line({1, 1, 0}, {0, 1, 0}));
    wire.Add(line({0, 1, 0}, {0, 0, 0}));
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 3))
        .Shape();
}

// Under a quarter of the circle about (0, 1), down to the x axis, which touches it at the origin.
TopoDS_Shape knife() {
    BRepBuilderAPI_MakeWire wire;
    wire.Add(line({0, 0, 0}, {2, 0, 0}));
    wire.Add(line({2, 0, 0}, {2, 1, 0}));
    wire.Add(line({2, 1, 0}, {1, 1, 0}));
    wire.Add(arc({1, 1, 0}, {half, 1 - half, 0}, {0, 0, 0}));
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 3))
        .Shape();
}

CadBlocks fit(const CadShape &shape, const std::string &method) {
    Layout layout(shape);
    SolidLayoutOptions options;
    options.method = method;
    auto report = layout_solids(shape, std::vector<int>{1}, layout, options, {});
    CadBlocks blocks = blocks_of(shape, layout, 3);
    blocks.report = std::move(report);
    return blocks;
}

// Worst scaled Jacobian and volume with the divisions by default.
std::array<double, 2> quality_and_volume(const CadShape &shape, CadBlocks blocks) {
    DefaultDivisions options;
    options.part.assign(blocks.model.size(), 0);
    options.structured = {1};
    blocks.model.divisions = default_divisions(blocks.model, find_topology(blocks.model),
                                               shape.diagonal() / 30, options);
    const Mesh mesh = generate_on_cad(shape, blocks, 1, {.improve = false});
    const std::span<const Vec3> points{mesh.points.data(), mesh.points.size()};
    const CellView hexas{CellType::hexahedron,
                         {mesh.cells.front().nodes.data(), mesh.cells.front().nodes.size()}};
    const auto worst = quality(points, hexas, Metric::scaled_jacobian);
    const auto volumes = quality(points, hexas, Metric::volume);
    return {*std::min_element(worst.begin(), worst.end()),
            std::accumulate(volumes.begin(), volumes.end(), 0.0)};
}

TEST(SplitTips, GivesAStraightCornerAnElementThatTurns) {
    const CadShape shape = make_shape(rounded());
    const CadBlocks blocks = fit(shape, "mapped");
    ASSERT_EQ(blocks.model.size(), 1U);
    const CadBlocks split = split_tips(shape, blocks, shape.diagonal() / 30);
    EXPECT_EQ(split.model.size(), 2U);
    EXPECT_EQ(split.report.front().blocks, 2);
    const double volume = 3 * (1 + std::numbers::pi / 4);
    // Elements that turn by ten degrees or less have a sine of 0.09 at most.
    EXPECT_LT(quality_and_volume(shape, blocks)[0], 0.1);
    const auto [worst, found] = quality_and_volume(shape, split);
    EXPECT_GT(worst, 0.2);
    EXPECT_NEAR(found, volume, 0.01 * volume);
}

TEST(SplitTips, GivesAKnifeEdgeOneElement) {
    const CadShape shape = make_shape(knife());
    const CadBlocks blocks = fit(shape, "sweep");
    ASSERT_GE(blocks.model.size(), 1U);
    const CadBlocks split = split_tips(shape, blocks, shape.diagonal() / 30);
    const double volume = 3 * (2 - std::numbers::pi / 4);
    const auto [worst, found] = quality_and_volume(shape, split);
    EXPECT_GT(worst, 0.2);
    EXPECT_NEAR(found, volume, 0.01 * volume);
}

TEST(SplitTips, LeavesOthersAlone) {
    const CadShape shape = make_shape(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    const CadBlocks blocks = fit(shape, "mapped");
    EXPECT_EQ(split_tips(shape, blocks, 0.1).model.nodes, blocks.model.nodes);
    // No room for more blocks.
    const CadShape round = make_shape(rounded());
    const CadBlocks one = fit(round, "mapped");
    EXPECT_EQ(split_tips(round, one, 0.1, {}, 1).model.size(), 1U);
}

} // namespace
