// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/cell_topology.h"

#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <atomic>
#include <string>

namespace nmgs {
namespace {

constexpr CellType tri = CellType::triangle;
constexpr CellType tri6 = CellType::triangle6;
constexpr CellType quad = CellType::quad;
constexpr CellType quad8 = CellType::quad8;

constexpr LocalFace tetra_faces[] = {
    {tri, {0, 2, 1}}, {tri, {0, 1, 3}}, {tri, {1, 2, 3}}, {tri, {2, 0, 3}}};
constexpr LocalFace pyramid_faces[] = {
    {quad, {0, 3, 2, 1}}, {tri, {0, 1, 4}}, {tri, {1, 2, 4}}, {tri, {2, 3, 4}}, {tri, {3, 0, 4}}};
constexpr LocalFace wedge_faces[] = {{tri, {0, 2, 1}},
                                     {tri, {3, 4, 5}},
                                     {quad, {0, 1, 4, 3}},
                                     {quad, {1, 2, 5, 4}},
                                     {quad, {2, 0, 3, 5}}};
constexpr LocalFace hexahedron_faces[] = {{quad, {0, 3, 2, 1}}, {quad, {4, 5, 6, 7}},
                                          {quad, {0, 1, 5, 4}}, {quad, {1, 2, 6, 5}},
                                          {quad, {2, 3, 7, 6}}, {quad, {3, 0, 4, 7}}};

constexpr LocalFace tetra10_faces[] = {{tri6, {0, 2, 1, 6, 5, 4}},
                                       {tri6, {0, 1, 3, 4, 8, 7}},
                                       {tri6, {1, 2, 3, 5, 9, 8}},
                                       {tri6, {2, 0, 3, 6, 7, 9}}};
constexpr LocalFace pyramid13_faces[] = {{quad8, {0, 3, 2, 1, 8, 7, 6, 5}},
                                         {tri6, {0, 1, 4, 5, 10, 9}},
                                         {tri6, {1, 2, 4, 6, 11, 10}},
                                         {tri6, {2, 3, 4, 7, 12, 11}},
                                         {tri6, {3, 0, 4, 8, 9, 12}}};
constexpr LocalFace wedge15_faces[] = {{tri6, {0, 2, 1, 8, 7, 6}},
                                       {tri6, {3, 4, 5, 9, 10, 11}},
                                       {quad8, {0, 1, 4, 3, 6, 13, 9, 12}},
                                       {quad8, {1, 2, 5, 4, 7, 14, 10, 13}},
                                       {quad8, {2, 0, 3, 5, 8, 12, 11, 14}}};
constexpr LocalFace hexahedron20_faces[] = {
    {quad8, {0, 3, 2, 1, 11, 10, 9, 8}},   {quad8, {4, 5, 6, 7, 12, 13, 14, 15}},
    {quad8, {0, 1, 5, 4, 8, 17, 12, 16}},  {quad8, {1, 2, 6, 5, 9, 18, 13, 17}},
    {quad8, {2, 3, 7, 6, 10, 19, 14, 18}}, {quad8, {3, 0, 4, 7, 11, 16, 15, 19}}};

} // namespace

std::span<const LocalFace> faces(CellType type) {
    switch (type) {
    case CellType::tetra:
        return tetra_faces;
    case CellType::pyramid:
        return pyramid_faces;
    case CellType::wedge:
        return wedge_faces;
    case CellType::hexahedron:
        return hexahedron_faces;
    case CellType::tetra10:
        return tetra10_faces;
    case CellType::pyramid13:
        return pyramid13_faces;
    case CellType::wedge15:
        return wedge15_faces;
    case CellType::hexahedron20:
        return hexahedron20_faces;
    default:
        return {};
    }
}

int corner_count(CellType type) {
    return node_count(linear_type(type));
}

void check_nodes(std::span<const CellView> cells, std::size_t points) {
    for (const CellView &view : cells) {
        constexpr std::size_t grain = 1 << 18;
        std::atomic<std::size_t> bad{view.nodes.size()};
        parallel_for(view.nodes.size(), grain, [&](std::size_t first, std::size_t last) {
            bool wrong = false;
            for (std::size_t i = first; i < last; ++i) {
                wrong |= static_cast<std::uint32_t>(view.nodes[i]) >= points;
            }
            for (std::size_t i = first; wrong && i < last; ++i) {
                if (static_cast<std::uint32_t>(view.nodes[i]) >= points) {
                    std::size_t least = bad;
                    while (i < least && !bad.compare_exchange_weak(least, i)) {
                    }
                    break;
                }
            }
        });
        const std::size_t at = bad;
        if (at < view.nodes.size()) {
            const auto k = static_cast<std::size_t>(node_count(view.type));
            throw ArgumentError("cells: " + std::string(name(view.type)) + " " +
                                std::to_string(at / k) + " has node " +
                                std::to_string(view.nodes[at]) + ", but the mesh has " +
                                std::to_string(points) + " points");
        }
    }
}

} // namespace nmgs
