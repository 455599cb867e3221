// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/mid_sides_on_model.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace nmgs {
namespace {

using Natural = std::array<double, 3>;

struct Place {
    std::size_t block;
    Natural at;
};

// The model with what finding a cell in it takes.
struct Blocks {
    const BlockModel &model;
    std::vector<std::int64_t> first_cell;
    std::vector<std::array<std::vector<double>, 3>> positions;

    explicit Blocks(const BlockModel &m) : model(m), first_cell{0}, positions(m.size()) {
        for (std::size_t b = 0; b < m.size(); ++b) {
            const auto g = m.divisions[b];
            first_cell.push_back(first_cell.back() +
                                 std::int64_t{g[0]} * g[1] * (m.dimension == 3 ? g[2] : 1));
            for (int d = 0; d < m.dimension; ++d) {
                positions[b][static_cast<std::size_t>(d)] = natural_positions(m, b, d);
            }
        }
    }

    [[nodiscard]] Vec3 map(std::size_t block, const Natural &at) const {
        const auto nodes = model.element(block);
        return model.dimension == 3 ? hexa20::map(nodes.first<20>(), at[0], at[1], at[2])
                                    : quad8::map(nodes.first<8>(), at[0], at[1]);
    }

    // Natural coordinates of the cell's low corner, and of its high one.
    struct Cell {
        std::size_t block;
        Natural low, high;
        [[nodiscard]] Natural corner(std::size_t local) const {
            // Corners 0-3 run round the bottom, 4-7 round the top.
            const bool x = local % 4 == 1 || local % 4 == 2;
            const bool y = local % 4 >= 2;
            return {x ? high[0] : low[0], y ? high[1] : low[1], local >= 4 ? high[2] : low[2]};
        }
        [[nodiscard]] Natural middle() const {
            return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
        }
    };
    [[nodiscard]] Cell cell(std::int64_t number) const {
        const auto after = std::upper_bound(first_cell.begin(), first_cell.end(), number);
        const auto b = static_cast<std::size_t>(after - first_cell.begin()) - 1;
        const auto g = model.divisions[b];
        const std::int64_t at = number - first_cell[b];
        const std::array<std::int64_t, 3> index{at % g[0], at / g[0] % g[1], at / g[0] / g[1]};
        Cell result{b, {0, 0, 0}, {0, 0, 0}};
        for (std::size_t d = 0; d < static_cast<std::size_t>(model.dimension); ++d) {
            const auto i = static_cast<std::size_t>(index[d]);
            result.low[d] = positions[b][d][i];
            result.high[d] = positions[b][d][i + 1];
        }
        return result;
    }
};

// How the cells of a block of the mesh lie in those of the model.
struct Kind {
    bool fits = false;
    std::int64_t each = 1; // cells of the mesh to one of the model
};

Kind kind_of(const CellView &view, const BlockModel &model) {
    const std::int64_t whole = cell_count(model);
    const auto count = static_cast<std::int64_t>(view.size());
    const bool solid = model.dimension == 3;
    if (view.type == (solid ? CellType::hexahedron : CellType::quad)) {
        return {count == whole, 1};
    }
    if (view.type == (solid ? CellType::tetra : CellType::triangle)) {
        const std::int64_t each = solid ? 12 : 2;
        return {count == each * whole, each};
    }
    return {};
}

// As in split_hexahedra: the corners of the face at tetrahedra 2 f and 2 f + 1.
constexpr std::size_t split_faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                           {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

// Natural coordinates of node `local` of cell c of the mesh.
Natural natural(const CellView &view, std::int64_t each, std::size_t c, std::size_t local,
                const Blocks::Cell &cell) {
    if (each == 1) {
        return cell.corner(local);
    }
    const auto k = static_cast<std::size_t>(node_count(view.type));
    const std::size_t half = c % 2;
    const std::int32_t *pair = view.nodes.data() + (c - half) * k;
    if (local == 3) {
        return cell.middle();
    }
    // The first triangle of a face is (a, b, d) or (a, b, c), the second (c, d, b) or (c, d, a).
    const std::size_t in_pair = c % static_cast<std::size_t>(each) / 2;
    const auto corner = [&](std::size_t i) {
        return cell.corner(each == 12 ? split_faces[in_pair][i] : i);
    };
    if (local < 2) {
        return corner(2 * half + local);
    }
    const bool joined = pair[2] != pair[k];
    return corner(half == 0 ? (joined ? 3 : 2) : (joined ? 1 : 0));
}

} // namespace

std::optional<PlaceOnEdge> mid_sides_on_model(const BlockModel &model, std::span<const Vec3> points,
                                              std::span<const CellView> cells) {
    validate(model);
    std::vector<Kind> kinds;
    bool any = false;
    for (const CellView &view : cells) {
        kinds.push_back(kind_of(view, model));
        any = any || kinds.back().fits;
    }
    if (!any) {
        return std::nullopt;
    }
    const auto blocks = std::make_shared<const Blocks>(model);
    return [=](std::size_t block, std::size_t c, std::size_t e) {
        const CellView &view = cells[block];
        const LocalEdge edge = edges(view.type)[e];
        const auto k = static_cast<std::size_t>(node_count(view.type));
        const auto local_a = static_cast<std::size_t>(edge.a);
        const auto local_b = static_cast<std::size_t>(edge.b);
        const Vec3 a = points[static_cast<std::size_t>(view.nodes[c * k + local_a])];
        const Vec3 b = points[static_cast<std::size_t>(view.nodes[c * k + local_b])];
        const Vec3 straight = 0.5 * (a + b);
        const Kind kind = kinds[block];
        if (!kind.fits) {
            return straight;
        }
        const auto cell = blocks->cell(static_cast<std::int64_t>(c) / kind.each);
        const Natural at_a = natural(view, kind.each, c, local_a, cell);
        const Natural at_b = natural(view, kind.each, c, local_b, cell);
        const Vec3 image_a = blocks->map(cell.block, at_a);
        const Vec3 image_b = blocks->map(cell.block, at_b);
        const double limit = 0.25 * norm2(b - a);
        if (norm2(a - image_a) > limit || norm2(b - image_b) > limit) {
            return straight;
        }
        const Vec3 image =
            blocks->map(cell.block, {0.5 * (at_a[0] + at_b[0]), 0.5 * (at_a[1] + at_b[1]),
                                     0.5 * (at_a[2] + at_b[2])});
        return image + (straight - 0.5 * (image_a + image_b));
    };
}

} // namespace nmgs
