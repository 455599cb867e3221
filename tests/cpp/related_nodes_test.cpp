// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/related_nodes.h"

#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace {

using nmgs::CellType;
using nmgs::CellView;

std::vector<std::set<std::int32_t>> rows(const nmgs::RelatedNodes &related) {
    std::vector<std::set<std::int32_t>> result;
    for (std::size_t n = 0; n + 1 < related.offsets.size(); ++n) {
        std::set<std::int32_t> row;
        for (std::int64_t i = related.offsets[n]; i < related.offsets[n + 1]; ++i) {
            const std::int32_t node = related.neighbours[static_cast<std::size_t>(i)];
            EXPECT_TRUE(row.empty() || *row.rbegin() < node) << "ascending, each once";
            row.insert(node);
        }
        result.push_back(row);
    }
    return result;
}

// Far more cells than a thread takes at once, in random order: every filter and piece is used.
TEST(RelatedNodes, ManyRandomCellsForAnyNumberOfThreads) {
    std::mt19937 random(3);
    constexpr std::int32_t points = 20000;
    std::vector<std::int32_t> tetrahedra;
    std::vector<std::set<std::int32_t>> expected(points);
    for (int c = 0; c < 150000; ++c) {
        const auto base = static_cast<std::int32_t>(random() % (points - 40));
        std::set<std::int32_t> nodes;
        while (nodes.size() < 4) {
            nodes.insert(base + static_cast<std::int32_t>(random() % 40));
        }
        for (const std::int32_t a : nodes) {
            tetrahedra.push_back(a);
            for (const std::int32_t b : nodes) {
                if (a != b) {
                    expected[static_cast<std::size_t>(a)].insert(b);
                }
            }
        }
    }
    const CellView view{CellType::tetra, tetrahedra};
    for (const int threads : {1, 4}) {
        nmgs::set_threads(threads);
        EXPECT_EQ(rows(nmgs::related_nodes(points, {&view, 1})), expected);
    }
    nmgs::set_threads(0);
}

TEST(RelatedNodes, NamesTheCellWithAWrongNode) {
    const std::vector<std::int32_t> quads{0, 1, 2, 3, 2, 3, 4, 5};
    const CellView view{CellType::quad, quads};
    EXPECT_NO_THROW(nmgs::related_nodes(6, {&view, 1}));
    try {
        nmgs::related_nodes(5, {&view, 1});
        FAIL() << "expected ArgumentError";
    } catch (const nmgs::ArgumentError &e) {
        EXPECT_NE(std::string(e.what()).find("quad 1 has node 5"), std::string::npos) << e.what();
    }
}

TEST(RelatedNodes, CancelStops) {
    const std::vector<std::int32_t> quads(4 * 100000, 0);
    const CellView view{CellType::quad, quads};
    EXPECT_THROW(nmgs::related_nodes(1, {&view, 1}, [](double) { return false; }), nmgs::Cancelled);
}

} // namespace
