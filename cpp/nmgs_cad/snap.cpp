// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/snap.h"

#include "nmgs/support/parallel.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/face_projection.h"

#include <BRep_Tool.hxx>

#include <algorithm>
#include <cmath>
#include <optional>

namespace nmgs::cad {
namespace {

struct Snapper {
    const CadShape &shape;
    const BlockModel &model;
    const CadBinding &binding;
    const Lattice &lattice;
    std::span<Vec3> points;
    std::vector<Vec3> before; // where the isoparametric mapping put the nodes

    // Positions in [0, 1] of the lattice planes.
    [[nodiscard]] std::vector<double> fractions(std::size_t block, int axis) const {
        std::vector<double> t = natural_positions(model, block, axis);
        for (double &v : t) {
            v = 0.5 * (v + 1);
        }
        return t;
    }
    [[nodiscard]] std::size_t id(std::size_t block, LatticeIndex at) const {
        return static_cast<std::size_t>(lattice.node(block, at));
    }
    [[nodiscard]] Vec3 moved(std::size_t block, LatticeIndex at) const {
        const std::size_t n = id(block, at);
        return points[n] - before[n];
    }
    // Lattice index of the low end of a part; its running axes are at 0.
    [[nodiscard]] LatticeIndex origin(std::size_t block, int code) const {
        const auto digits = part::digits(code);
        const auto g = lattice.divisions(block);
        LatticeIndex at{};
        for (std::size_t d = 0; d < 3; ++d) {
            at[d] = digits[d] == 2 ? g[d] : 0;
        }
        return at;
    }
    [[nodiscard]] bool owned(std::size_t block, int code) const {
        LatticeIndex at = origin(block, code);
        const auto axes = part::axes(code);
        for (int d = 0; d < axes.count; ++d) {
            const auto axis = static_cast<std::size_t>(axes.axis[static_cast<std::size_t>(d)]);
            if (lattice.divisions(block)[axis] < 2) {
                return false; // no node inside the part
            }
            at[axis] = 1;
        }
        return lattice.owns(block, at);
    }

    void corner(std::size_t block, int code);
    void edge(std::size_t block, int code);
    void face(std::size_t block, int code);
    void inside(std::size_t block, std::int32_t first, std::int32_t last);
};

void Snapper::corner(std::size_t block, int code) {
    const auto on = binding.of(block, code);
    if (on.size() == 1 && on[0].dimension == 0) {
        const gp_Pnt p = BRep_Tool::Pnt(shape.vertex(on[0].index));
        points[id(block, origin(block, code))] = {p.X(), p.Y(), p.Z()};
    }
}

void Snapper::edge(std::size_t block, int code) {
    const auto on = binding.of(block, code);
    const auto axis = static_cast<std::size_t>(part::axes(code).axis[0]);
    const std::int32_t n = lattice.divisions(block)[axis];
    const auto t = fractions(block, static_cast<int>(axis));
    LatticeIndex at = origin(block, code);
    const LatticeIndex low = at;
    LatticeIndex high = at;
    high[axis] = n;
    if (on.size() == 1 && on[0].dimension == 1) {
        const EdgeCurve curve(shape.edge(on[0].index));
        // A block that was halved covers a part of the edge.
        const double from = curve.fraction(points[id(block, low)]);
        const double to = curve.fraction(points[id(block, high)]);
        for (at[axis] = 1; at[axis] < n; ++at[axis]) {
            const double f = t[static_cast<std::size_t>(at[axis])];
            points[id(block, at)] = curve.at(from + f * (to - from));
        }
        return;
    }
    const Vec3 a = moved(block, low);
    const Vec3 b = moved(block, high);
    const bool project = on.size() == 1 && on[0].dimension == 2;
    for (at[axis] = 1; at[axis] < n; ++at[axis]) {
        const double f = t[static_cast<std::size_t>(at[axis])];
        points[id(block, at)] += (1 - f) * a + f * b;
    }
    if (project) {
        FaceProjection projection(shape.face(on[0].index));
        for (at[axis] = 1; at[axis] < n; ++at[axis]) {
            Vec3 &p = points[id(block, at)];
            p = projection.nearest(p);
        }
    }
}

void Snapper::face(std::size_t block, int code) {
    const auto on = binding.of(block, code);
    const auto axes = part::axes(code);
    const auto u = static_cast<std::size_t>(axes.axis[0]);
    const auto v = static_cast<std::size_t>(axes.axis[1]);
    const auto g = lattice.divisions(block);
    const auto s = fractions(block, axes.axis[0]);
    const auto t = fractions(block, axes.axis[1]);
    LatticeIndex base = origin(block, code);
    const auto at = [&](std::int32_t i, std::int32_t j) {
        LatticeIndex index = base;
        index[u] = i;
        index[v] = j;
        return index;
    };
    const auto rim = [&](std::int32_t i, std::int32_t j) { return moved(block, at(i, j)); };
    const Vec3 c00 = rim(0, 0);
    const Vec3 c10 = rim(g[u], 0);
    const Vec3 c01 = rim(0, g[v]);
    const Vec3 c11 = rim(g[u], g[v]);
    std::optional<FaceProjection> projection;
    if (on.size() == 1 && on[0].dimension == 2) {
        projection.emplace(shape.face(on[0].index));
    }
    for (std::int32_t j = 1; j < g[v]; ++j) {
        const double b = t[static_cast<std::size_t>(j)];
        const Vec3 low = rim(0, j);
        const Vec3 high = rim(g[u], j);
        for (std::int32_t i = 1; i < g[u]; ++i) {
            const double a = s[static_cast<std::size_t>(i)];
            Vec3 move = (1 - a) * low + a * high + (1 - b) * rim(i, 0) + b * rim(i, g[v]);
            move = move - (1 - a) * (1 - b) * c00 - a * (1 - b) * c10 - (1 - a) * b * c01 -
                   a * b * c11;
            Vec3 &p = points[id(block, at(i, j))];
            p += move;
            if (projection) {
                p = projection->nearest(p);
            }
        }
    }
}

void Snapper::inside(std::size_t block, std::int32_t first, std::int32_t last) {
    const auto g = lattice.divisions(block);
    const auto r = fractions(block, 0);
    const auto s = fractions(block, 1);
    const auto t = fractions(block, 2);
    const auto m = [&](std::int32_t i, std::int32_t j, std::int32_t k) {
        return moved(block, {i, j, k});
    };
    const auto [gx, gy, gz] = g;
    for (std::int32_t k = first; k < last; ++k) {
        const double c = t[static_cast<std::size_t>(k)];
        const double c1 = 1 - c;
        for (std::int32_t j = 1; j < gy; ++j) {
            const double b = s[static_cast<std::size_t>(j)];
            const double b1 = 1 - b;
            // The twelve edges and eight corners, by what depends on i and what does not.
            const Vec3 x0 = m(0, j, k) - b1 * m(0, 0, k) - b * m(0, gy, k) - c1 * m(0, j, 0) -
                            c * m(0, j, gz) + b1 * c1 * m(0, 0, 0) + b * c1 * m(0, gy, 0) +
                            b1 * c * m(0, 0, gz) + b * c * m(0, gy, gz);
            const Vec3 x1 = m(gx, j, k) - b1 * m(gx, 0, k) - b * m(gx, gy, k) - c1 * m(gx, j, 0) -
                            c * m(gx, j, gz) + b1 * c1 * m(gx, 0, 0) + b * c1 * m(gx, gy, 0) +
                            b1 * c * m(gx, 0, gz) + b * c * m(gx, gy, gz);
            for (std::int32_t i = 1; i < gx; ++i) {
                const double a = r[static_cast<std::size_t>(i)];
                const Vec3 faces =
                    b1 * m(i, 0, k) + b * m(i, gy, k) + c1 * m(i, j, 0) + c * m(i, j, gz);
                const Vec3 edges = b1 * c1 * m(i, 0, 0) + b * c1 * m(i, gy, 0) +
                                   b1 * c * m(i, 0, gz) + b * c * m(i, gy, gz);
                points[id(block, {i, j, k})] += (1 - a) * x0 + a * x1 + faces - edges;
            }
        }
    }
}

} // namespace

void snap(const CadShape &shape, const BlockModel &model, const CadBinding &binding,
          const Lattice &lattice, std::span<Vec3> points, const Progress &progress, double from,
          double to) {
    Snapper snapper{shape,   model,  binding,
                    lattice, points, std::vector<Vec3>(points.begin(), points.end())};
    struct Piece {
        std::size_t block;
        int code;
    };
    std::array<std::vector<Piece>, 3> pieces;
    const int codes = model.dimension == 2 ? 9 : part::count;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < codes; ++code) {
            const int dimension = part::dimension(code);
            if (dimension < 3 && snapper.owned(b, code)) {
                pieces[static_cast<std::size_t>(dimension)].push_back({b, code});
            }
        }
    }
    double done = from;
    const double step = (to - from) / 4;
    for (std::size_t d = 0; d < 3; ++d) {
        parallel_for(
            pieces[d].size(), 1,
            [&](std::size_t first, std::size_t last) {
                for (std::size_t n = first; n < last; ++n) {
                    const auto [block, code] = pieces[d][n];
                    d == 0   ? snapper.corner(block, code)
                    : d == 1 ? snapper.edge(block, code)
                             : snapper.face(block, code);
                }
            },
            progress, done, done + step);
        done += step;
    }
    if (model.dimension == 3) {
        struct Layer {
            std::size_t block;
            std::int32_t k;
        };
        std::vector<Layer> layers;
        for (std::size_t b = 0; b < model.size(); ++b) {
            for (std::int32_t k = 1; k < lattice.divisions(b)[2]; ++k) {
                layers.push_back({b, k});
            }
        }
        parallel_for(
            layers.size(), 1,
            [&](std::size_t first, std::size_t last) {
                for (std::size_t n = first; n < last; ++n) {
                    snapper.inside(layers[n].block, layers[n].k, layers[n].k + 1);
                }
            },
            progress, done, to);
    }
}

} // namespace nmgs::cad
