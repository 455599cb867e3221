// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/generate.h"

#include "nmgs/blocking/block_check.h"
#include "nmgs/blocking/coincident_nodes.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/error.h"
#include "nmgs/support/memory.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace nmgs {
namespace {

// Lagrange's quadratic weights of the points at -1, 0, 1: exactly 1 and 0 at these points, so that
// block corners and mid-sides come out to the bit.
struct Weights {
    double low, middle, high;
};
Weights weights(double t) {
    return {0.5 * t * (t - 1), 1 - t * t, 0.5 * t * (t + 1)};
}

struct BlockTables {
    std::vector<Weights> xi;
    std::vector<double> eta, zeta;
};

BlockTables tables(const BlockModel &model, std::size_t block) {
    BlockTables t;
    for (const double xi : natural_positions(model, block, 0)) {
        t.xi.push_back(weights(xi));
    }
    t.eta = natural_positions(model, block, 1);
    if (model.dimension == 3) {
        t.zeta = natural_positions(model, block, 2);
    }
    return t;
}

// A layer zeta = const of a 20-node block is an 8-node patch: the serendipity space of the block,
// restricted to the layer, is the patch's.
std::array<Vec3, 8> layer_patch(std::span<const Vec3> nodes, double zeta) {
    std::array<Vec3, 8> patch{};
    for (std::size_t i = 0; i < 8; ++i) {
        patch[i] = hexa20::map(nodes.first<20>(), quad8::natural[i][0], quad8::natural[i][1], zeta);
    }
    return patch;
}

// The row eta = const of an 8-node patch is a quadratic in xi; its points at -1, 0 and 1 are
// quadratics in eta. Coefficients once a layer instead of shape functions once a row.
struct RowEnds {
    std::array<Vec3, 8> patch{};
    Vec3 bulge{};

    void set(const std::array<Vec3, 8> &nodes) {
        patch = nodes;
        bulge = 0.5 * (patch[5] + patch[7]) - 0.25 * (patch[0] + patch[1] + patch[2] + patch[3]);
    }
    [[nodiscard]] Vec3 low(const Weights &w) const {
        return w.low * patch[0] + w.middle * patch[7] + w.high * patch[3];
    }
    [[nodiscard]] Vec3 high(const Weights &w) const {
        return w.low * patch[1] + w.middle * patch[5] + w.high * patch[2];
    }
    [[nodiscard]] Vec3 middle(double eta, const Weights &w) const {
        return (0.5 * (1 - eta)) * patch[4] + (0.5 * (1 + eta)) * patch[6] + w.middle * bulge;
    }
};

// A run of lattice rows (j fastest, then k), short enough to balance the threads and poll often.
struct Task {
    std::size_t block;
    std::int64_t first_row, last_row;
};

// extra: 1 for rows of nodes, 0 for rows of cells.
std::vector<Task> make_tasks(const BlockModel &model, int extra) {
    constexpr std::int64_t target = 1 << 14;
    std::vector<Task> tasks;
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto g = model.divisions[b];
        const std::int64_t rows =
            (std::int64_t{g[1]} + extra) * (model.dimension == 3 ? std::int64_t{g[2]} + extra : 1);
        const std::int64_t step = std::max<std::int64_t>(1, target / (std::int64_t{g[0]} + 1));
        for (std::int64_t r = 0; r < rows; r += step) {
            tasks.push_back({b, r, std::min(rows, r + step)});
        }
    }
    return tasks;
}

void fill_rows(const BlockModel &model, const Lattice &lattice, const BlockTables &table,
               const Task &task, std::span<Vec3> points) {
    const auto nodes = model.element(task.block);
    const auto rows = static_cast<std::int64_t>(table.eta.size());
    RowEnds ends;
    std::int64_t layer = -1;
    if (model.dimension == 2) {
        std::array<Vec3, 8> patch{};
        std::copy(nodes.begin(), nodes.end(), patch.begin());
        ends.set(patch);
    }
    const auto n = table.xi.size() - 1;
    for (std::int64_t r = task.first_row; r < task.last_row; ++r) {
        const auto j = static_cast<std::int32_t>(r % rows);
        const auto k = static_cast<std::int32_t>(r / rows);
        const auto pieces = lattice.row_pieces(task.block, j, k);
        if (!pieces.low && !pieces.inside && !pieces.high) {
            continue;
        }
        if (model.dimension == 3 && k != layer) {
            ends.set(layer_patch(nodes, table.zeta[static_cast<std::size_t>(k)]));
            layer = k;
        }
        const double eta = table.eta[static_cast<std::size_t>(j)];
        const Weights w = weights(eta);
        const Vec3 low = ends.low(w);
        const Vec3 middle = ends.middle(eta, w);
        const Vec3 high = ends.high(w);
        Vec3 *out = points.data() + pieces.start;
        if (pieces.low) {
            *out++ = low;
        }
        if (pieces.inside) {
            for (std::size_t i = 1; i < n; ++i) {
                const Weights v = table.xi[i];
                out->x = v.low * low.x + v.middle * middle.x + v.high * high.x;
                out->y = v.low * low.y + v.middle * middle.y + v.high * high.y;
                out->z = v.low * low.z + v.middle * middle.z + v.high * high.z;
                ++out;
            }
        }
        if (pieces.high) {
            *out = high;
        }
    }
}

void fill_hexahedra(const Lattice &lattice, const Task &task, std::span<std::int32_t> cells) {
    const auto g = lattice.divisions(task.block);
    const auto n = static_cast<std::size_t>(g[0]);
    std::vector<std::int32_t> buffer(4 * (n + 1));
    std::array<std::int32_t *, 4> ids{};
    for (std::size_t i = 0; i < 4; ++i) {
        ids[i] = buffer.data() + i * (n + 1);
    }
    const auto load = [&](std::int32_t *row, std::int32_t j, std::int32_t k) {
        lattice.row(task.block, j, k, {row, n + 1});
    };
    std::int32_t *out = cells.data() + 8 * (lattice.first_cell(task.block) +
                                            task.first_row * static_cast<std::int64_t>(g[0]));
    for (std::int64_t r = task.first_row; r < task.last_row; ++r) {
        const auto j = static_cast<std::int32_t>(r % g[1]);
        const auto k = static_cast<std::int32_t>(r / g[1]);
        if (r == task.first_row || j == 0) {
            load(ids[0], j, k);
            load(ids[2], j, k + 1);
        }
        load(ids[1], j + 1, k);
        load(ids[3], j + 1, k + 1);
        const std::int32_t *a = ids[0];
        const std::int32_t *b = ids[1];
        const std::int32_t *c = ids[2];
        const std::int32_t *d = ids[3];
        for (std::size_t i = 0; i < n; ++i) {
            out[0] = a[i];
            out[1] = a[i + 1];
            out[2] = b[i + 1];
            out[3] = b[i];
            out[4] = c[i];
            out[5] = c[i + 1];
            out[6] = d[i + 1];
            out[7] = d[i];
            out += 8;
        }
        std::swap(ids[0], ids[1]);
        std::swap(ids[2], ids[3]);
    }
}

void fill_quads(const Lattice &lattice, const Task &task, std::span<std::int32_t> cells) {
    const auto g = lattice.divisions(task.block);
    const auto n = static_cast<std::size_t>(g[0]);
    std::vector<std::int32_t> low(n + 1);
    std::vector<std::int32_t> high(n + 1);
    lattice.row(task.block, static_cast<std::int32_t>(task.first_row), 0, low);
    std::int32_t *out = cells.data() + 4 * (lattice.first_cell(task.block) +
                                            task.first_row * static_cast<std::int64_t>(g[0]));
    for (std::int64_t r = task.first_row; r < task.last_row; ++r) {
        lattice.row(task.block, static_cast<std::int32_t>(r) + 1, 0, high);
        for (std::size_t i = 0; i < n; ++i) {
            out[0] = low[i];
            out[1] = low[i + 1];
            out[2] = high[i + 1];
            out[3] = high[i];
            out += 4;
        }
        std::swap(low, high);
    }
}

} // namespace

void raise_conflicts(const BlockModel &model, const Topology &topology) {
    if (topology.conflicts.empty()) {
        return;
    }
    std::vector<std::string> entities;
    std::vector<std::string> reasons;
    for (const Conflict &c : topology.conflicts) {
        const auto block = [&](std::int32_t b, int code) {
            return "Block" + std::to_string(b + 1) + " " + part::name(code, model.dimension);
        };
        entities.push_back("Block" + std::to_string(c.block_a + 1));
        reasons.push_back(block(c.block_a, c.part_a) + " is " + c.reason + " (" +
                          block(c.block_b, c.part_b) + "), near (" + std::to_string(c.place.x) +
                          ", " + std::to_string(c.place.y) + ", " + std::to_string(c.place.z) +
                          ")");
    }
    std::string text = "the blocks do not match: " + reasons.front();
    if (reasons.size() > 1) {
        text += ", and " + std::to_string(reasons.size() - 1) + " more";
    }
    throw BlockingError(text, std::move(entities), std::move(reasons));
}

void fill_points(const BlockModel &model, const Lattice &lattice, std::span<Vec3> points,
                 const Progress &progress, double from, double to) {
    std::vector<BlockTables> table;
    for (std::size_t b = 0; b < model.size(); ++b) {
        table.push_back(tables(model, b));
    }
    const auto tasks = make_tasks(model, 1);
    parallel_for(
        tasks.size(), 1,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t t = first; t < last; ++t) {
                fill_rows(model, lattice, table[tasks[t].block], tasks[t], points);
            }
        },
        progress, from, to);
}

void fill_cells(const BlockModel &model, const Lattice &lattice, std::span<std::int32_t> cells,
                const Progress &progress, double from, double to) {
    const auto tasks = make_tasks(model, 0);
    parallel_for(
        tasks.size(), 1,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t t = first; t < last; ++t) {
                if (model.dimension == 3) {
                    fill_hexahedra(lattice, tasks[t], cells);
                } else {
                    fill_quads(lattice, tasks[t], cells);
                }
            }
        },
        progress, from, to);
}

Mesh generate(const BlockModel &model, const GenerateOptions &options, const Progress &progress) {
    validate(model);
    const int corners = model.dimension == 3 ? 8 : 4;
    const std::int64_t cells = cell_count(model);
    // Cells are never shared: they alone decide for the hopeless requests, before any other work.
    if (cells > std::numeric_limits<std::int64_t>::max() / 64 ||
        lattice_count(model) > std::numeric_limits<std::int64_t>::max() / 64) {
        throw ArgumentError("divisions: the mesh would have " + std::to_string(cells) +
                            " or more cells, beyond any memory");
    }
    require_memory(4 * corners * cells, "divisions: the mesh's cells alone");
    const Topology topology = find_topology(model, options.tolerance);
    if (!options.force) {
        const auto problems = check_blocks(model, topology, progress);
        if (!problems.empty()) {
            throw as_error(problems);
        }
    }
    const Lattice lattice(model, topology);
    if (lattice.node_count() > std::numeric_limits<std::int32_t>::max()) {
        throw ArgumentError("divisions: the mesh would have " +
                            std::to_string(lattice.node_count()) + " nodes (" +
                            std::to_string(24 * lattice.node_count() + 4 * corners * cells) +
                            " bytes); node numbers end at 2147483647");
    }
    std::int64_t planes = 0; // of lattices, with up to 32 bytes each while meshing
    for (const auto &g : model.divisions) {
        planes += std::int64_t{g[0]} + g[1] + g[2];
    }
    require_memory(24 * lattice.node_count() + 4 * corners * cells + 32 * planes,
                   "divisions: the mesh");

    Mesh mesh;
    mesh.points = Array<Vec3>(static_cast<std::size_t>(lattice.node_count()));
    mesh.cells.push_back({model.dimension == 3 ? CellType::hexahedron : CellType::quad,
                          Array<std::int32_t>(static_cast<std::size_t>(corners * cells))});
    const std::span<Vec3> points{mesh.points.data(), mesh.points.size()};
    fill_points(model, lattice, points, progress, 0.0, 0.5);
    fill_cells(model, lattice, {mesh.cells[0].nodes.data(), mesh.cells[0].nodes.size()}, progress,
               0.5, 1.0);
    // Numbered corners say what is shared; being near says nothing then.
    if (model.size() > 1 && model.corners.empty()) {
        apply(find_coincident_nodes(model, topology, lattice, points), mesh);
    }
    return mesh;
}

} // namespace nmgs
