// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/related_nodes.h"

#include "nmgs/convert/hexa_to_tetra.h"
#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
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

std::vector<std::set<std::int32_t>> expected_rows(std::size_t points,
                                                  const std::vector<std::int32_t> &tetrahedra) {
    std::vector<std::set<std::int32_t>> expected(points);
    for (std::size_t t = 0; t < tetrahedra.size(); t += 4) {
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t b = 0; b < 4; ++b) {
                if (a != b) {
                    expected[static_cast<std::size_t>(tetrahedra[t + a])].insert(tetrahedra[t + b]);
                }
            }
        }
    }
    return expected;
}

// Split hexahedra are recognised; in their own order and numbering, in any other, and with a pair
// of tetrahedra that breaks the pattern.
TEST(RelatedNodes, SplitHexahedra) {
    constexpr std::int32_t n = 9;
    std::vector<nmgs::Vec3> points;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-0.2, 0.2);
    for (std::int32_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
        const std::int32_t j = i / (n + 1) % (n + 1);
        const std::int32_t k = i / (n + 1) / (n + 1);
        points.push_back({i % (n + 1) + shift(random), j + shift(random), k + shift(random)});
    }
    std::vector<std::int32_t> hexahedra;
    for (std::int32_t c = 0; c < n * n * n; ++c) {
        const std::int32_t low = c % n + (n + 1) * (c / n % n + (n + 1) * (c / n / n));
        for (const std::int32_t at : {low, low + (n + 1) * (n + 1)}) {
            hexahedra.insert(hexahedra.end(), {at, at + 1, at + n + 2, at + n + 1});
        }
    }
    std::vector<std::int32_t> tetrahedra(6 * hexahedra.size());
    std::vector<nmgs::Vec3> centroids(hexahedra.size() / 8);
    nmgs::split_hexahedra(points, hexahedra, static_cast<std::int32_t>(points.size()), tetrahedra,
                          centroids);
    const std::size_t total = points.size() + centroids.size();
    const auto check = [&] {
        const CellView view{CellType::tetra, tetrahedra};
        for (const int threads : {1, 3}) {
            nmgs::set_threads(threads);
            EXPECT_EQ(rows(nmgs::related_nodes(total, {&view, 1})),
                      expected_rows(total, tetrahedra));
        }
        nmgs::set_threads(0);
    };
    check();
    std::vector<std::int32_t> number(total);
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    for (std::int32_t &node : tetrahedra) {
        node = number[static_cast<std::size_t>(node)];
    }
    check();
    std::swap_ranges(tetrahedra.begin() + 480, tetrahedra.begin() + 484, tetrahedra.begin());
    tetrahedra.insert(tetrahedra.end(), tetrahedra.begin() + 96, tetrahedra.begin() + 192);
    check();
}

// One node that all others are joined to: more than a row holds.
TEST(RelatedNodes, OneNodeOfAllCells) {
    constexpr std::int32_t points = 5000;
    std::vector<std::int32_t> triangles;
    for (std::int32_t n = 1; n + 1 < points; ++n) {
        triangles.insert(triangles.end(), {0, n + 1, n});
    }
    const CellView view{CellType::triangle, triangles};
    const auto related = rows(nmgs::related_nodes(points, {&view, 1}));
    EXPECT_EQ(related[0].size(), static_cast<std::size_t>(points - 1));
    EXPECT_EQ(related[7], (std::set<std::int32_t>{0, 6, 8}));
}

TEST(RelatedNodes, NoCells) {
    const auto related = nmgs::related_nodes(3, {});
    EXPECT_EQ(std::vector<std::int64_t>(related.offsets.begin(), related.offsets.end()),
              std::vector<std::int64_t>(4, 0));
    EXPECT_EQ(nmgs::related_nodes(0, {}).offsets.size(), 1U);
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
