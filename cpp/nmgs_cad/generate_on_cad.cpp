// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/generate_on_cad.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/quality/curved_metrics.h"
#include "nmgs/quality/volume_metrics.h"
#include "nmgs/support/error.h"
#include "nmgs/support/memory.h"
#include "nmgs/support/parallel.h"
#include "nmgs_cad/cad_geometry.h"
#include "nmgs_cad/snap.h"
#include "nmgs_cad/untangle.h"

#include <algorithm>
#include <limits>
#include <map>

namespace nmgs::cad {
namespace {

// The lattice with twice the divisions: every second plane half-way between two of the model's.
// Its nodes with at most one odd index are the nodes of the quadratic serendipity cells.
BlockModel doubled(const BlockModel &model) {
    BlockModel fine = model;
    fine.spacing.assign(model.size() * static_cast<std::size_t>(model.dimension), {});
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int d = 0; d < model.dimension; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            fine.divisions[b][axis] *= 2;
            const std::size_t at = b * static_cast<std::size_t>(model.dimension) + axis;
            if (at < model.spacing.size() && !model.spacing[at].empty()) {
                const auto &coarse = model.spacing[at];
                auto &values = fine.spacing[at];
                for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
                    values.push_back(coarse[i]);
                    values.push_back(0.5 * (coarse[i] + coarse[i + 1]));
                }
                values.push_back(coarse.back());
            }
        }
    }
    return fine;
}

struct Builder {
    const BlockModel &model;  // as asked for
    const BlockModel &finest; // itself, or doubled
    const CadBinding &binding;
    const Topology &topology; // of the coarse lattice
    const Lattice &coarse;
    const Lattice &fine;
    int scale; // 1, or 2 for second order
    Mesh mesh;
    std::vector<std::int32_t> number;  // of the fine lattice's nodes in the mesh, -1 unused
    std::vector<std::int32_t> off_cad; // nodes that left the CAD

    void number_nodes(std::span<const Vec3> points);
    void make_cells();
    void make_boundary();
    void make_node_groups();
    [[nodiscard]] std::vector<CadEntity> entities() const;
    void improve(const CadShape &shape, const Progress &progress);
    bool release(const CadShape &shape, std::vector<CadEntity> &on,
                 std::span<const std::int32_t> nodes, const Progress &progress);
    void bend(const CadShape &shape, std::span<const CadEntity> on, std::span<const Vec3> before);
    void straighten(std::span<const CadEntity> on);

    [[nodiscard]] std::int32_t node(std::size_t block, LatticeIndex fine_at) const {
        return number[static_cast<std::size_t>(fine.node(block, fine_at))];
    }
};

constexpr double bad = 0.2; // a scaled Jacobian that calls for better nodes
// The same where each block is one element: strategies have improved their layouts.
constexpr double bad_layout = 0.02;

// Mid-side nodes of a quadratic cell with the ends of their edges.
std::span<const std::array<std::size_t, 3>> mid_sides(int dimension) {
    static constexpr std::array<std::array<std::size_t, 3>, 12> hexa{{{8, 0, 1},
                                                                      {9, 1, 2},
                                                                      {10, 2, 3},
                                                                      {11, 3, 0},
                                                                      {12, 4, 5},
                                                                      {13, 5, 6},
                                                                      {14, 6, 7},
                                                                      {15, 7, 4},
                                                                      {16, 0, 4},
                                                                      {17, 1, 5},
                                                                      {18, 2, 6},
                                                                      {19, 3, 7}}};
    static constexpr std::array<std::array<std::size_t, 3>, 4> quad{
        {{4, 0, 1}, {5, 1, 2}, {6, 2, 3}, {7, 3, 0}}};
    return dimension == 3 ? std::span<const std::array<std::size_t, 3>>(hexa) : quad;
}

LatticeIndex scaled(LatticeIndex at, int scale) {
    return {at[0] * scale, at[1] * scale, at[2] * scale};
}

void Builder::number_nodes(std::span<const Vec3> points) {
    number.assign(points.size(), -1);
    auto next = static_cast<std::int32_t>(coarse.node_count());
    // Corner nodes keep the numbers that the linear mesh gives them.
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto g = coarse.divisions(b);
        std::vector<std::int32_t> row(static_cast<std::size_t>(g[0]) + 1);
        for (std::int32_t k = 0; k <= g[2]; ++k) {
            for (std::int32_t j = 0; j <= g[1]; ++j) {
                coarse.row(b, j, k, row);
                for (std::int32_t i = 0; i <= g[0]; ++i) {
                    number[static_cast<std::size_t>(fine.node(b, scaled({i, j, k}, scale)))] =
                        row[static_cast<std::size_t>(i)];
                }
            }
        }
    }
    if (scale == 2) {
        for (std::size_t b = 0; b < model.size(); ++b) {
            const auto g = fine.divisions(b);
            std::vector<std::int32_t> row(static_cast<std::size_t>(g[0]) + 1);
            for (std::int32_t k = 0; k <= g[2]; ++k) {
                for (std::int32_t j = 0; j <= g[1]; ++j) {
                    const int odd = (j & 1) + (k & 1);
                    if (odd > 1) {
                        continue;
                    }
                    fine.row(b, j, k, row);
                    // Odd rows have mid-side nodes at even places only, even rows at odd places.
                    for (std::int32_t i = 1 - odd; i <= g[0]; i += 2) {
                        auto &n =
                            number[static_cast<std::size_t>(row[static_cast<std::size_t>(i)])];
                        n = n < 0 ? next++ : n;
                    }
                }
            }
        }
    }
    mesh.points = Array<Vec3>(static_cast<std::size_t>(next));
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (number[n] >= 0) {
            mesh.points[static_cast<std::size_t>(number[n])] = points[n];
        }
    }
}

void Builder::make_cells() {
    const bool solid = model.dimension == 3;
    const CellType type = solid ? (scale == 2 ? CellType::hexahedron20 : CellType::hexahedron)
                                : (scale == 2 ? CellType::quad8 : CellType::quad);
    const int k_nodes = node_count(type);
    const auto count = static_cast<std::size_t>(cell_count(model));
    Array<std::int32_t> nodes(count * static_cast<std::size_t>(k_nodes));
    parallel_for(model.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t b = first; b < last; ++b) {
            const auto g = coarse.divisions(b);
            auto *out = nodes.data() + coarse.first_cell(b) * k_nodes;
            for (std::int32_t k = 0; k < (solid ? g[2] : 1); ++k) {
                for (std::int32_t j = 0; j < g[1]; ++j) {
                    for (std::int32_t i = 0; i < g[0]; ++i) {
                        for (int n = 0; n < k_nodes; ++n) {
                            LatticeIndex at = scaled({i, j, k}, scale);
                            const auto m = static_cast<std::size_t>(n);
                            for (std::size_t d = 0; d < (solid ? 3U : 2U); ++d) {
                                const double natural =
                                    solid ? hexa20::natural[m][d] : quad8::natural[m][d];
                                at[d] += (static_cast<std::int32_t>(natural) + 1) * scale / 2;
                            }
                            *out++ = node(b, at);
                        }
                    }
                }
            }
        }
    });
    mesh.cells.push_back({type, std::move(nodes)});
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto on = binding.of(b, solid ? part::code(1, 1, 1) : part::code(1, 1, 0));
        if (on.size() == 1 && on[0].dimension == model.dimension) {
            Group &group = mesh.groups[entity_name(on[0].dimension, on[0].index)];
            group.on_nodes = false;
            group.type = type;
            for (auto c = coarse.first_cell(b); c < coarse.first_cell(b + 1); ++c) {
                group.indices.push_back(static_cast<std::int32_t>(c));
            }
        }
    }
}

// Quads of the hexahedra's faces that lie on CAD faces, once where two blocks share one.
void Builder::make_boundary() {
    const CellType type = scale == 2 ? CellType::quad8 : CellType::quad;
    std::vector<std::int32_t> nodes;
    std::map<std::string, Group> groups;
    std::int32_t count = 0;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < part::count; ++code) {
            const auto on = binding.of(b, code);
            if (part::dimension(code) != 2 || on.size() != 1 || on[0].dimension != 2 ||
                !topology.owns(b, code)) {
                continue;
            }
            Group &group = groups[entity_name(2, on[0].index)];
            group.on_nodes = false;
            group.type = type;
            const auto axes = part::axes(code);
            const auto digits = part::digits(code);
            const auto u = static_cast<std::size_t>(axes.axis[0]);
            const auto v = static_cast<std::size_t>(axes.axis[1]);
            const std::size_t w = 3 - u - v;
            // (u, v, w) is right-handed for w = xi and zeta; outward is +w at the high end.
            const bool flip = (w == 1) == (digits[w] == 2);
            const auto g = fine.divisions(b);
            LatticeIndex middle{};
            middle[w] = digits[w] == 2 ? g[w] : 0;
            for (std::int32_t j = 0; j < g[v]; j += scale) {
                for (std::int32_t i = 0; i < g[u]; i += scale) {
                    for (int n = 0; n < node_count(type); ++n) {
                        const auto m = static_cast<std::size_t>(n);
                        double x = quad8::natural[m][0];
                        double y = quad8::natural[m][1];
                        if (flip) {
                            std::swap(x, y);
                        }
                        LatticeIndex at = middle;
                        at[u] = i + (static_cast<std::int32_t>(x) + 1) * scale / 2;
                        at[v] = j + (static_cast<std::int32_t>(y) + 1) * scale / 2;
                        nodes.push_back(node(b, at));
                    }
                    group.indices.push_back(count++);
                }
            }
        }
    }
    CellBlock block{type, Array<std::int32_t>(nodes.size())};
    std::copy(nodes.begin(), nodes.end(), block.nodes.begin());
    mesh.cells.push_back(std::move(block));
    mesh.groups.merge(groups);
}

void Builder::make_node_groups() {
    std::map<std::array<std::int32_t, 2>, std::vector<std::int32_t>> nodes;
    const int codes = model.dimension == 2 ? 9 : part::count;
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto g = fine.divisions(b);
        for (int code = 0; code < codes; ++code) {
            const int dimension = part::dimension(code);
            if (dimension > 1) {
                continue;
            }
            for (const CadEntity &entity : binding.of(b, code)) {
                if (entity.dimension != dimension) {
                    continue;
                }
                auto &list = nodes[{entity.dimension, entity.index}];
                LatticeIndex at{};
                const auto digits = part::digits(code);
                for (std::size_t d = 0; d < 3; ++d) {
                    at[d] = digits[d] == 2 ? g[d] : 0;
                }
                if (dimension == 0) {
                    list.push_back(node(b, at));
                    continue;
                }
                const auto axis = static_cast<std::size_t>(part::axes(code).axis[0]);
                for (at[axis] = 0; at[axis] <= g[axis]; ++at[axis]) {
                    list.push_back(node(b, at));
                }
            }
        }
    }
    for (auto &[entity, list] : nodes) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        mesh.groups[entity_name(entity[0], entity[1])] = {true, CellType::line, std::move(list)};
    }
}

// What each node lies on; dimension 3 inside a solid.
std::vector<CadEntity> Builder::entities() const {
    std::vector<CadEntity> on(mesh.points.size(), CadEntity{3, 0});
    const bool solid = model.dimension == 3;
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto g = fine.divisions(b);
        for (int code = 0; code < (solid ? part::count : 9); ++code) {
            const auto entity = binding.of(b, code);
            if (entity.size() != 1 || entity[0].dimension == 3) {
                continue;
            }
            const auto digits = part::digits(code);
            LatticeIndex low{};
            LatticeIndex high{};
            for (std::size_t d = 0; d < (solid ? 3U : 2U); ++d) {
                low[d] = digits[d] == 0 ? 0 : digits[d] == 1 ? 1 : g[d];
                high[d] = digits[d] == 1 ? g[d] - 1 : low[d];
            }
            for (std::int32_t k = low[2]; k <= high[2]; ++k) {
                for (std::int32_t j = low[1]; j <= high[1]; ++j) {
                    for (std::int32_t i = low[0]; i <= high[0]; ++i) {
                        const std::int32_t n = node(b, {i, j, k});
                        if (n >= 0) {
                            on[static_cast<std::size_t>(n)] = entity[0];
                        }
                    }
                }
            }
        }
    }
    return on;
}

// Moves nodes round bad cells, then the mid-side nodes beside them.
void Builder::improve(const CadShape &shape, const Progress &progress) {
    const bool solid = model.dimension == 3;
    const auto &cells = mesh.cells.front().nodes;
    const auto per = static_cast<std::size_t>(node_count(mesh.cells.front().type));
    const std::size_t corners = solid ? 8 : 4;
    std::vector<std::int32_t> linear;
    if (scale == 2) {
        linear.reserve(cells.size() / per * corners);
        for (std::size_t c = 0; c < cells.size(); c += per) {
            linear.insert(linear.end(), cells.begin() + c, cells.begin() + c + corners);
        }
    }
    const std::span<const std::int32_t> nodes =
        scale == 2 ? std::span<const std::int32_t>(linear)
                   : std::span<const std::int32_t>(cells.data(), cells.size());
    std::vector<std::int32_t> face_of;
    if (!solid) {
        for (std::size_t b = 0; b < model.size(); ++b) {
            const auto on = binding.of(b, part::code(1, 1, 0));
            const bool bound = on.size() == 1 && on[0].dimension == 2;
            if (!bound) {
                return; // no face's normal to tell a quad's side
            }
            face_of.insert(
                face_of.end(),
                static_cast<std::size_t>(coarse.first_cell(b + 1) - coarse.first_cell(b)),
                on[0].index);
        }
    }
    const std::span<Vec3> points(mesh.points.data(), mesh.points.size());
    const std::span<const std::int32_t> none;
    const bool undivided =
        std::all_of(model.divisions.begin(), model.divisions.end(), [](const auto &g) {
            return std::max({g[0], g[1], g[2]}) == 1;
        });
    const double poor = solid && undivided ? bad_layout : bad;
    if (!has_bad_cells(points, solid ? nodes : none, solid ? none : nodes, face_of, poor) &&
        scale == 1) {
        return;
    }
    std::vector<CadEntity> on = entities();
    const std::vector<Vec3> before(points.begin(), points.end());
    UntangleOptions options;
    options.good = 0.5;
    const auto moved = improve_mesh(shape, points, on, solid ? nodes : none, solid ? none : nodes,
                                    face_of, poor, options, progress);
    const bool released = solid && release(shape, on, nodes, progress);
    if (scale == 2) {
        if (!moved.empty() || released) {
            bend(shape, on, before);
        }
        if (solid) {
            straighten(on);
        }
    }
}

// Cells that are still inside out: those nodes of theirs that are inside a CAD face leave it, as
// little as will do. Whether any did; `on` says where they are now.
bool Builder::release(const CadShape &shape, std::vector<CadEntity> &on,
                      std::span<const std::int32_t> nodes, const Progress &progress) {
    constexpr double sound = 1e-3;
    constexpr double wanted = 0.02;
    constexpr int rounds = 4;
    const std::span<Vec3> points(mesh.points.data(), mesh.points.size());
    std::vector<Vec3> home;
    std::vector<std::int32_t> free;
    const auto quality = [&](std::size_t first) {
        std::array<Vec3, 8> p{};
        for (std::size_t k = 0; k < 8; ++k) {
            p[k] = points[static_cast<std::size_t>(nodes[first + k])];
        }
        return hexahedron::scaled_jacobian(p.data());
    };
    for (int round = 0; round < rounds; ++round) {
        // The cells, later their neighbours as well.
        std::vector<char> touched(points.size(), 0);
        bool any = false;
        const auto touch = [&](std::size_t c) {
            for (std::size_t k = 0; k < 8; ++k) {
                touched[static_cast<std::size_t>(nodes[c + k])] = 1;
            }
        };
        for (std::size_t c = 0; c < nodes.size(); c += 8) {
            if (quality(c) < sound) {
                touch(c);
                any = true;
            }
        }
        if (!any) {
            break;
        }
        for (int layer = 0; layer < round; ++layer) {
            const std::vector<char> front = touched;
            for (std::size_t c = 0; c < nodes.size(); c += 8) {
                if (std::any_of(
                        nodes.begin() + static_cast<std::ptrdiff_t>(c),
                        nodes.begin() + static_cast<std::ptrdiff_t>(c) + 8,
                        [&](std::int32_t n) { return front[static_cast<std::size_t>(n)]; })) {
                    touch(c);
                }
            }
        }
        for (std::size_t n = 0; n < on.size(); ++n) {
            if (touched[n] != 0 && on[n].dimension == 2) {
                free.push_back(static_cast<std::int32_t>(n));
                home.push_back(points[n]);
                on[n] = {3, 0};
            }
        }
        UntangleOptions options;
        options.good = wanted;
        improve_mesh(shape, points, on, nodes, {}, {}, sound, options, progress);
    }
    if (free.empty()) {
        return false;
    }
    // Back as far as the cells round each node stay sound.
    std::vector<std::int32_t> place(points.size(), -1);
    for (std::size_t i = 0; i < free.size(); ++i) {
        place[static_cast<std::size_t>(free[i])] = static_cast<std::int32_t>(i);
    }
    std::vector<std::vector<std::size_t>> around(free.size());
    for (std::size_t m = 0; m < nodes.size(); ++m) {
        const std::int32_t i = place[static_cast<std::size_t>(nodes[m])];
        if (i >= 0) {
            around[static_cast<std::size_t>(i)].push_back(m / 8 * 8);
        }
    }
    for (std::size_t i = 0; i < free.size(); ++i) {
        Vec3 &p = points[static_cast<std::size_t>(free[i])];
        const auto least = [&] {
            double q = 1;
            for (const std::size_t c : around[i]) {
                q = std::min(q, quality(c));
            }
            return q;
        };
        const Vec3 there = p;
        const double limit = std::min(least(), 0.5 * wanted);
        for (const double f : {1.0, 0.75, 0.5, 0.25}) {
            p = there + f * (home[i] - there);
            if (least() >= limit) {
                break;
            }
            p = there;
        }
        if (!(p == home[i])) {
            off_cad.push_back(free[i]);
        }
    }
    std::sort(off_cad.begin(), off_cad.end());
    return true;
}

// Mid-side nodes follow the ends of their edges, on the CAD.
void Builder::bend(const CadShape &shape, std::span<const CadEntity> on,
                   std::span<const Vec3> before) {
    const auto &cells = mesh.cells.front().nodes;
    const auto per = static_cast<std::size_t>(node_count(mesh.cells.front().type));
    std::vector<char> done(mesh.points.size(), 0);
    BorrowedGeometry geometry(shape);
    for (std::size_t c = 0; c < cells.size(); c += per) {
        for (const auto &[m, a, b] : mid_sides(model.dimension)) {
            const auto middle = static_cast<std::size_t>(cells[c + m]);
            const auto low = static_cast<std::size_t>(cells[c + a]);
            const auto high = static_cast<std::size_t>(cells[c + b]);
            const Vec3 move =
                0.5 * (mesh.points[low] - before[low] + mesh.points[high] - before[high]);
            if (done[middle] != 0 || norm2(move) == 0) {
                continue;
            }
            done[middle] = 1;
            Vec3 &p = mesh.points[middle];
            p += move;
            if (on[middle].dimension == 1) {
                const EdgeCurve &curve = geometry->curve(on[middle].index);
                const auto piece = curve.part(mesh.points[low], p, mesh.points[high]);
                p = curve.at(0.5 * (piece.from + piece.to));
            } else if (on[middle].dimension == 2) {
                FaceProjection &face = geometry->face(on[middle].index);
                face.start(mesh.points[low]);
                p = face.nearest(p);
            }
        }
    }
}

// Where a curved cell's Jacobian is not positive everywhere, its inner edges become straight.
void Builder::straighten(std::span<const CadEntity> on) {
    const auto &cells = mesh.cells.front().nodes;
    constexpr std::size_t per = 20;
    constexpr double bent = 0.01; // of its chord, what an edge is off before it is looked at
    const std::size_t count = cells.size() / per;
    std::vector<char> folded(count, 0);
    constexpr std::size_t grain = 64;
    parallel_for(count, grain, [&](std::size_t from, std::size_t to) {
        std::array<Vec3, per> p{};
        for (std::size_t c = from; c < to; ++c) {
            for (std::size_t k = 0; k < per; ++k) {
                p[k] = mesh.points[static_cast<std::size_t>(cells[c * per + k])];
            }
            bool bends = false;
            for (const auto &[m, a, b] : mid_sides(3)) {
                bends = bends || norm(p[m] - 0.5 * (p[a] + p[b])) > bent * distance(p[a], p[b]);
            }
            folded[c] = bends && !(curved::min_jacobian(CellType::hexahedron20, p.data()) > 0);
        }
    });
    for (std::size_t c = 0; c < count; ++c) {
        for (const auto &[m, a, b] : mid_sides(3)) {
            const auto middle = static_cast<std::size_t>(cells[c * per + m]);
            if (folded[c] != 0 && on[middle].dimension == 3) {
                mesh.points[middle] =
                    0.5 * (mesh.points[static_cast<std::size_t>(cells[c * per + a])] +
                           mesh.points[static_cast<std::size_t>(cells[c * per + b])]);
            }
        }
    }
}

} // namespace

Mesh generate_on_cad(const CadShape &shape, const CadBlocks &blocks, int order,
                     const GenerateOptions &options, const Progress &progress,
                     std::vector<std::int32_t> *off_cad) {
    if (order != 1 && order != 2) {
        throw ArgumentError("order: expected 1 or 2, got " + std::to_string(order));
    }
    const BlockModel &model = blocks.model;
    validate(model);
    const Topology topology = find_topology(model, options.tolerance);
    if (!options.force) {
        raise_conflicts(model, topology);
    }
    const Lattice coarse(model, topology);
    const BlockModel fine_model = order == 2 ? doubled(model) : BlockModel{};
    const BlockModel &finest = order == 2 ? fine_model : model;
    // Shared parts are the same ones in both lattices.
    const Lattice fine(finest, topology);
    if (fine.node_count() > std::numeric_limits<std::int32_t>::max()) {
        throw ArgumentError("divisions: the mesh would have " + std::to_string(fine.node_count()) +
                            " nodes; node numbers end at 2147483647");
    }
    require_memory(76 * fine.node_count() + 4 * 20 * cell_count(model), "the mesh");

    std::vector<Vec3> points(static_cast<std::size_t>(fine.node_count()));
    fill_points(finest, fine, points, progress, 0.0, 0.2);
    snap(shape, finest, blocks.binding, fine, points, progress, 0.2, 0.8);
    Builder builder{model, finest, blocks.binding, topology, coarse, fine, order, {}, {}, {}};
    builder.number_nodes(points);
    poll(progress, 0.9);
    builder.make_cells();
    if (options.improve) {
        builder.improve(shape, progress
                                   ? Progress([&](double f) { return progress(0.9 + 0.1 * f); })
                                   : Progress());
    }
    if (model.dimension == 3) {
        builder.make_boundary();
    }
    builder.make_node_groups();
    if (off_cad != nullptr) {
        *off_cad = std::move(builder.off_cad);
    }
    poll(progress, 1.0);
    return std::move(builder.mesh);
}

} // namespace nmgs::cad
