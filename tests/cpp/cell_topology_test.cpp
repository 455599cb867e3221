// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/cell_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace {

using nmgs::CellType;

constexpr CellType volumes[] = {CellType::tetra,      CellType::tetra10,     CellType::pyramid,
                                CellType::pyramid13,  CellType::wedge,       CellType::wedge15,
                                CellType::hexahedron, CellType::hexahedron20};

// The faces of a cell close: each edge belongs to two faces, run through in opposite senses.
TEST(CellTopology, FacesClose) {
    for (const CellType type : volumes) {
        std::map<std::pair<int, int>, int> directed;
        for (const nmgs::LocalFace &face : nmgs::faces(type)) {
            const int n = nmgs::corner_count(face.type);
            for (int i = 0; i < n; ++i) {
                const int a = face.nodes[static_cast<std::size_t>(i)];
                const int b = face.nodes[static_cast<std::size_t>((i + 1) % n)];
                const int uses = ++directed[std::pair(a, b)];
                EXPECT_EQ(uses, 1) << nmgs::name(type);
            }
        }
        std::set<std::pair<int, int>> edges;
        for (const nmgs::LocalEdge &edge : nmgs::edges(type)) {
            edges.insert(std::minmax(edge.a, edge.b));
        }
        EXPECT_EQ(directed.size(), 2 * edges.size()) << nmgs::name(type);
        for (const auto &[pair, uses] : directed) {
            const auto reversed = std::pair(pair.second, pair.first);
            EXPECT_TRUE(directed.contains(reversed)) << nmgs::name(type);
            EXPECT_TRUE(edges.contains(std::minmax(pair.first, pair.second))) << nmgs::name(type);
        }
        // Euler: corners - edges + faces = 2.
        EXPECT_EQ(nmgs::corner_count(type) - static_cast<int>(edges.size()) +
                      static_cast<int>(nmgs::faces(type).size()),
                  2)
            << nmgs::name(type);
    }
}

// A quadratic face's mid-side nodes are those of the cell's own edges.
TEST(CellTopology, MidSidesOfFacesAreThoseOfTheEdges) {
    for (const CellType type : volumes) {
        if (!nmgs::is_quadratic(type)) {
            continue;
        }
        std::map<std::pair<int, int>, int> mid;
        std::set<int> mids;
        for (const nmgs::LocalEdge &edge : nmgs::edges(type)) {
            mid[std::minmax(edge.a, edge.b)] = edge.mid;
            mids.insert(edge.mid);
        }
        EXPECT_EQ(static_cast<int>(mids.size()), nmgs::node_count(type) - nmgs::corner_count(type));
        for (const nmgs::LocalFace &face : nmgs::faces(type)) {
            const int n = nmgs::corner_count(face.type);
            for (int i = 0; i < n; ++i) {
                const int a = face.nodes[static_cast<std::size_t>(i)];
                const int b = face.nodes[static_cast<std::size_t>((i + 1) % n)];
                const int found = mid[std::minmax(a, b)];
                EXPECT_EQ(found, face.nodes[static_cast<std::size_t>(n + i)]) << nmgs::name(type);
            }
        }
    }
}

TEST(CellTopology, LinearAndQuadraticTypesBelongTogether) {
    for (const CellType type : volumes) {
        EXPECT_EQ(nmgs::linear_type(nmgs::quadratic_type(type)), nmgs::linear_type(type));
        EXPECT_EQ(
            nmgs::name(nmgs::quadratic_type(type)).rfind(nmgs::name(nmgs::linear_type(type)), 0),
            0U);
    }
}

} // namespace
