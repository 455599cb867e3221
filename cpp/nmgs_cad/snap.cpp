// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/snap.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/parallel.h"
#include "nmgs_cad/cad_geometry.h"

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {

constexpr std::int32_t rows_at_a_time = 32; // of a face, so that threads share a large one

// The mid-side node on an edge part.
std::size_t middle_node(int dimension, int code) {
    const auto digits = part::digits(code);
    const std::size_t count = dimension == 2 ? quad8::nodes : hexa20::nodes;
    for (std::size_t n = 0; n < count; ++n) {
        bool same = true;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
            const double natural = dimension == 2 ? quad8::natural[n][d] : hexa20::natural[n][d];
            same = same && natural == digits[d] - 1;
        }
        if (same) {
            return n;
        }
    }
    return 0;
}

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

    void corner(std::size_t block, int code, CadGeometry &geometry);
    void edge(std::size_t block, int code, CadGeometry &geometry);
    // Rows [first, last) of the face's inner nodes.
    void face(std::size_t block, int code, std::int32_t first, std::int32_t last,
              CadGeometry &geometry);
    void inside(std::size_t block, std::int32_t first, std::int32_t last);
};

void Snapper::corner(std::size_t block, int code, CadGeometry &geometry) {
    const auto on = binding.of(block, code);
    if (on.size() != 1 || on[0].dimension == 3) {
        return;
    }
    Vec3 &p = points[id(block, origin(block, code))];
    if (on[0].dimension == 0) {
        p = shape.point(on[0].index);
    } else if (on[0].dimension == 1) {
        const EdgeCurve &curve = geometry.curve(on[0].index);
        p = curve.at(curve.fraction(p));
    } else {
        p = geometry.face(on[0].index).nearest(p);
    }
}

void Snapper::edge(std::size_t block, int code, CadGeometry &geometry) {
    const auto on = binding.of(block, code);
    const auto axis = static_cast<std::size_t>(part::axes(code).axis[0]);
    const std::int32_t n = lattice.divisions(block)[axis];
    const auto t = fractions(block, static_cast<int>(axis));
    LatticeIndex at = origin(block, code);
    const LatticeIndex low = at;
    LatticeIndex high = at;
    high[axis] = n;
    if (on.size() == 1 && on[0].dimension == 1) {
        // A block that covers a part of the edge: its mid-side node tells which, where the edge is
        // closed.
        const EdgeCurve &curve = geometry.curve(on[0].index);
        const auto [from, to] = curve.part(points[id(block, low)],
                                           model.element(block)[middle_node(model.dimension, code)],
                                           points[id(block, high)]);
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
        FaceProjection &projection = geometry.face(on[0].index);
        projection.start(points[id(block, low)]);
        for (at[axis] = 1; at[axis] < n; ++at[axis]) {
            Vec3 &p = points[id(block, at)];
            p = projection.nearest(p);
        }
    }
}

void Snapper::face(std::size_t block, int code, std::int32_t first, std::int32_t last,
                   CadGeometry &geometry) {
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
    FaceProjection *projection =
        on.size() == 1 && on[0].dimension == 2 ? &geometry.face(on[0].index) : nullptr;
    FaceProjection::Guess row_start;
    for (std::int32_t j = first; j < last; ++j) {
        const double b = t[static_cast<std::size_t>(j)];
        const Vec3 low = rim(0, j);
        const Vec3 high = rim(g[u], j);
        if (projection != nullptr && j == first) {
            // From a node that is on the face already: its neighbours are then found on the same
            // sheet of the surface.
            projection->start(points[id(block, at(0, j))]);
        } else if (projection != nullptr) {
            projection->set_guess(row_start);
        }
        for (std::int32_t i = 1; i < g[u]; ++i) {
            const double a = s[static_cast<std::size_t>(i)];
            Vec3 move = (1 - a) * low + a * high + (1 - b) * rim(i, 0) + b * rim(i, g[v]);
            move = move - (1 - a) * (1 - b) * c00 - a * (1 - b) * c10 - (1 - a) * b * c01 -
                   a * b * c11;
            Vec3 &p = points[id(block, at(i, j))];
            p += move;
            if (projection) {
                p = projection->nearest(p);
                if (i == 1) {
                    row_start = projection->guess();
                }
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
          double to, SnapParts parts) {
    Snapper snapper{shape,   model,  binding,
                    lattice, points, std::vector<Vec3>(points.begin(), points.end())};
    struct Piece {
        std::size_t block;
        int code;
        std::int32_t first, last; // rows of a face
    };
    std::array<std::vector<Piece>, 3> pieces;
    const int codes = model.dimension == 2 ? 9 : part::count;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < codes; ++code) {
            const int dimension = part::dimension(code);
            if (dimension == 3 || !snapper.owned(b, code)) {
                continue;
            }
            const std::int32_t rows =
                dimension < 2
                    ? 2
                    : lattice.divisions(b)[static_cast<std::size_t>(part::axes(code).axis[1])];
            for (std::int32_t j = 1; j < rows; j += rows_at_a_time) {
                pieces[static_cast<std::size_t>(dimension)].push_back(
                    {b, code, j, std::min(j + rows_at_a_time, rows)});
            }
        }
    }
    double done = from;
    const double step = (to - from) / 4;
    for (std::size_t d = 0; d < 3; ++d) {
        constexpr std::size_t grain = 8;
        parallel_for(
            pieces[d].size(), grain,
            [&](std::size_t first, std::size_t last) {
                BorrowedGeometry geometry(shape);
                for (std::size_t n = first; n < last; ++n) {
                    const Piece &piece = pieces[d][n];
                    d == 0 ? snapper.corner(piece.block, piece.code, *geometry)
                    : d == 1
                        ? snapper.edge(piece.block, piece.code, *geometry)
                        : snapper.face(piece.block, piece.code, piece.first, piece.last, *geometry);
                }
            },
            progress, done, done + step);
        done += step;
    }
    if (model.dimension == 3 && parts == SnapParts::all) {
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
