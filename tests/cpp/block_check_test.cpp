// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/block_check.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/support/error.h"

#include <gtest/gtest.h>

namespace {

using nmgs::BlockModel;
using nmgs::ProblemKind;
using nmgs::Vec3;

BlockModel boxes(const std::vector<Vec3> &lows, std::int32_t n = 2) {
    BlockModel model;
    for (const Vec3 low : lows) {
        for (const auto &p : nmgs::hexa20::natural) {
            model.nodes.push_back(low + 0.5 * Vec3{p[0] + 1, p[1] + 1, p[2] + 1});
        }
        model.divisions.push_back({n, n, n});
    }
    return model;
}

std::vector<nmgs::BlockProblem> check(const BlockModel &model) {
    return nmgs::check_blocks(model, nmgs::find_topology(model));
}

TEST(BlockCheck, SoundModels) {
    EXPECT_TRUE(check(boxes({{0, 0, 0}})).empty());
    EXPECT_TRUE(check(boxes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}})).empty());
}

TEST(BlockCheck, EachFaultByItself) {
    BlockModel mirrored = boxes({{0, 0, 0}});
    for (Vec3 &p : mirrored.nodes) {
        p.x = -p.x;
    }
    BlockModel folded = boxes({{0, 0, 0}});
    folded.nodes[6] = {0.1, 0.1, 0.1};
    BlockModel divisions = boxes({{0, 0, 0}, {1, 0, 0}});
    divisions.divisions[1][1] = 3;
    const std::vector<std::pair<BlockModel, ProblemKind>> cases{
        {mirrored, ProblemKind::mirrored},
        {folded, ProblemKind::folded},
        {divisions, ProblemKind::divisions},
        {boxes({{0, 0, 0}, {1.01, 0, 0}}), ProblemKind::gap},
        {boxes({{0, 0, 0}, {0.5, 0.3, 0.2}}), ProblemKind::overlap},
        {boxes({{0, 0, 0}, {0.93, 0.93, 0.2}}), ProblemKind::overlap},
    };
    for (const auto &[model, kind] : cases) {
        const auto problems = check(model);
        ASSERT_FALSE(problems.empty());
        for (const auto &problem : problems) {
            EXPECT_EQ(problem.kind, kind) << problem.text;
            EXPECT_NE(problem.text.find("Block1"), std::string::npos) << problem.text;
        }
    }
}

TEST(BlockCheck, TheErrorNamesBothBlocks) {
    const auto problems = check(boxes({{0, 0, 0}, {0.5, 0.3, 0.2}}));
    ASSERT_EQ(problems.size(), 1U);
    const nmgs::BlockingError error = nmgs::as_error(problems);
    EXPECT_NE(std::string(error.what()).find(problems[0].text), std::string::npos);
}

TEST(BlockCheck, CancelStops) {
    const BlockModel model = boxes({{0, 0, 0}, {1, 0, 0}});
    EXPECT_THROW(
        nmgs::check_blocks(model, nmgs::find_topology(model), [](double) { return false; }),
        nmgs::Cancelled);
}

} // namespace
