// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/boundary.h"

#include "nmgs/mesh/edges.h"
#include "nmgs/mesh/faces.h"

#include <algorithm>

namespace nmgs {
namespace {

struct Piece {
    std::size_t block;
    std::int32_t cell;
    CellType type;
    std::array<int, 8> local;
};

std::vector<BoundaryBlock> collect(std::span<const CellView> cells,
                                   const std::vector<Piece> &pieces) {
    std::vector<BoundaryBlock> result;
    for (const CellType type : {CellType::line, CellType::line3, CellType::triangle,
                                CellType::triangle6, CellType::quad, CellType::quad8}) {
        const auto count = static_cast<std::size_t>(std::count_if(
            pieces.begin(), pieces.end(), [&](const Piece &piece) { return piece.type == type; }));
        if (count == 0) {
            continue;
        }
        const auto k = static_cast<std::size_t>(node_count(type));
        BoundaryBlock block{type, Array<std::int32_t>(count * k), {}, {}};
        block.blocks.reserve(count);
        block.cells.reserve(count);
        std::int32_t *out = block.nodes.data();
        for (const Piece &piece : pieces) {
            if (piece.type != type) {
                continue;
            }
            const CellView &view = cells[piece.block];
            const auto *nodes =
                view.nodes.data() + static_cast<std::size_t>(piece.cell) *
                                        static_cast<std::size_t>(node_count(view.type));
            for (std::size_t i = 0; i < k; ++i) {
                *out++ = nodes[piece.local[i]];
            }
            block.blocks.push_back(static_cast<std::int32_t>(piece.block));
            block.cells.push_back(piece.cell);
        }
        result.push_back(std::move(block));
    }
    return result;
}

std::vector<Piece> free_edges(std::size_t points, std::span<const CellView> cells,
                              const Progress &progress) {
    std::vector<CellView> surface;
    std::vector<std::size_t> origin;
    for (std::size_t b = 0; b < cells.size(); ++b) {
        if (dimension(cells[b].type) == 2) {
            surface.push_back(cells[b]);
            origin.push_back(b);
        }
    }
    const Edges all = find_edges(points, surface, progress);
    std::vector<std::uint8_t> uses(all.ends.size(), 0);
    for (const auto &numbers : all.of_cells) {
        for (const std::int32_t e : numbers) {
            auto &count = uses[static_cast<std::size_t>(e)];
            count = static_cast<std::uint8_t>(std::min(2, count + 1));
        }
    }
    std::vector<Piece> pieces;
    for (std::size_t b = 0; b < surface.size(); ++b) {
        const auto local = edges(surface[b].type);
        const CellType type = is_quadratic(surface[b].type) ? CellType::line3 : CellType::line;
        const auto &numbers = all.of_cells[b];
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (uses[static_cast<std::size_t>(numbers[i])] == 1) {
                const LocalEdge &e = local[i % local.size()];
                pieces.push_back({origin[b],
                                  static_cast<std::int32_t>(i / local.size()),
                                  type,
                                  {e.a, e.b, e.mid}});
            }
        }
    }
    return pieces;
}

} // namespace

std::vector<BoundaryBlock> boundary(std::size_t points, std::span<const CellView> cells,
                                    const Progress &progress) {
    const bool solid = std::any_of(cells.begin(), cells.end(),
                                   [](const CellView &view) { return dimension(view.type) == 3; });
    if (!solid) {
        return collect(cells, free_edges(points, cells, progress));
    }
    const Faces all = find_faces(points, cells, progress);
    std::vector<Piece> pieces;
    for (const Face &face : all.faces) {
        if (face.uses == 1) {
            const LocalFace &local = faces(cells[face.block].type)[face.local];
            pieces.push_back({face.block, face.cell, local.type, local.nodes});
        }
    }
    return collect(cells, pieces);
}

} // namespace nmgs
