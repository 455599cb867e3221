// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/box_tree.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace {

using nmgs::Box;

std::vector<Box> random_boxes(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 10);
    std::uniform_real_distribution<double> size(0, 1);
    std::vector<Box> boxes(count);
    for (Box &box : boxes) {
        box.low = {place(random), place(random), place(random)};
        box.high = box.low + nmgs::Vec3{size(random), size(random), size(random)};
    }
    return boxes;
}

TEST(BoxTree, FindsWhatALoopFinds) {
    const auto boxes = random_boxes(500);
    const nmgs::BoxTree tree(boxes);
    for (const double gap : {0.0, 0.3}) {
        for (const Box &box : boxes) {
            std::set<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < boxes.size(); ++i) {
                if (boxes[i].near(box, gap)) {
                    expected.insert(i);
                }
            }
            std::multiset<std::uint32_t> found;
            tree.near(box, gap, [&](std::uint32_t i) { found.insert(i); });
            EXPECT_EQ(found, std::multiset<std::uint32_t>(expected.begin(), expected.end()));
        }
    }
}

TEST(BoxTree, NoneOneAndEqualBoxes) {
    const Box box = random_boxes(1)[0];
    int found = 0;
    const auto count = [&](std::uint32_t) { ++found; };
    nmgs::BoxTree({}).near(box, 1, count);
    EXPECT_EQ(found, 0);
    nmgs::BoxTree({box}).near(box, 0, count);
    EXPECT_EQ(found, 1);
    found = 0;
    nmgs::BoxTree(std::vector<Box>(100, box)).near(box, 0, count);
    EXPECT_EQ(found, 100);
}

} // namespace
