// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/untangle.h"

#include "nmgs/quality/surface_metrics.h"
#include "nmgs/quality/volume_metrics.h"
#include "nmgs/support/ascending.h"
#include "nmgs/support/parallel.h"
#include "nmgs/support/vec3.h"
#include "nmgs_cad/cad_geometry.h"

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {

using Hexa = std::array<std::int32_t, 8>;
using Quad = std::array<std::int32_t, 4>;

// Nodes that slide on the CAD's edges and faces.
class CadSlides final : public NodeSlides {
public:
    CadSlides(const CadShape &shape, std::span<const CadEntity> on,
              std::span<const std::int32_t> face_of)
        : geometry_(shape), on_(on), face_of_(face_of), guess_(on.size()) {}

    [[nodiscard]] int freedom(std::int32_t node) const override {
        return std::max(0, entity(node).dimension);
    }
    std::array<Vec3, 2> tangents(std::int32_t node, Vec3 p) override {
        const CadEntity e = entity(node);
        if (e.dimension == 1) {
            const EdgeCurve &curve = geometry_->curve(e.index);
            return {curve.tangent(curve.fraction(p)), Vec3{}};
        }
        const Vec3 n = at(node, e.index).normal(p);
        keep(node, e.index);
        // Across the axis that is least along the normal.
        const Vec3 a{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
        const Vec3 axis = a.x <= a.y && a.x <= a.z ? Vec3{1, 0, 0}
                          : a.y <= a.z             ? Vec3{0, 1, 0}
                                                   : Vec3{0, 0, 1};
        const Vec3 t = unit(cross(n, axis));
        return {t, cross(n, t)};
    }
    Vec3 slide(std::int32_t node, Vec3 from, Vec3 wanted) override {
        const CadEntity e = entity(node);
        if (e.dimension == 1) {
            // By the length along the tangent: the nearest point could be elsewhere on the edge.
            const EdgeCurve &curve = geometry_->curve(e.index);
            const double f = curve.fraction(from);
            const double go = dot(wanted - from, curve.tangent(f));
            return curve.at(std::clamp(f + go / curve.length(), 1e-6, 1 - 1e-6));
        }
        FaceProjection &face = at(node, e.index);
        if (face.guess().count == 0) {
            face.start(from);
        }
        const Vec3 there = face.nearest(wanted);
        keep(node, e.index);
        return there;
    }
    Vec3 normal(std::int32_t quad, Vec3 p) override {
        return geometry_->face(face_of_[static_cast<std::size_t>(quad)]).normal(p);
    }

private:
    [[nodiscard]] CadEntity entity(std::int32_t node) const {
        return on_[static_cast<std::size_t>(node)];
    }
    // With the guess that the node left there.
    FaceProjection &at(std::int32_t node, int n) {
        FaceProjection &face = geometry_->face(n);
        face.set_guess(guess_[static_cast<std::size_t>(node)]);
        return face;
    }
    void keep(std::int32_t node, int n) {
        guess_[static_cast<std::size_t>(node)] = geometry_->face_as_it_is(n).guess();
    }

    BorrowedGeometry geometry_;
    std::span<const CadEntity> on_;
    std::span<const std::int32_t> face_of_;
    std::vector<FaceProjection::Guess> guess_;
};

struct Cells {
    std::vector<Hexa> hexahedra;
    std::vector<Quad> quads;
    std::vector<std::int32_t> face_of;
};

Cells cells_of(const Layout &layout, std::size_t first) {
    Cells cells;
    for (std::size_t h = first; h < layout.hexas.size(); ++h) {
        cells.hexahedra.push_back(layout.hexas[h].points);
    }
    if (layout.hexas.empty()) {
        for (const auto &quad : layout.quads) {
            cells.quads.push_back(quad.points);
            cells.face_of.push_back(quad.face);
        }
    }
    return cells;
}

// Whether the points of each CAD edge still follow each other.
bool in_order(const CadShape &shape, const Layout &layout) {
    BorrowedGeometry geometry(shape);
    for (std::size_t n = 1; n < layout.edges.size(); ++n) {
        const auto &points = layout.edges[n];
        if (points.size() < 4) {
            continue; // one point between two ends
        }
        const EdgeCurve &curve = geometry->curve(static_cast<int>(n));
        double last = 0;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const double f = curve.fraction(layout.points[static_cast<std::size_t>(points[i])]);
            if (!(f > last)) {
                return false;
            }
            last = f;
        }
    }
    return true;
}

// A part of a mesh with numbers of its own. Nodes that cells outside have too stay.
struct Part {
    std::vector<std::int32_t> cells, nodes, local;
    std::vector<CadEntity> on;
};

// Cells within a number of layers of the bad ones, of the worst where they are many. Whole layers,
// or the bad cells' own nodes would be held by cells left out.
Part part_round(const std::vector<double> &quality, double bad, std::span<const std::int32_t> cells,
                std::size_t per, std::span<const CadEntity> on) {
    constexpr int layers = 3;
    constexpr std::size_t most_cells = 12000;
    constexpr std::size_t most_seeds = 300;
    std::vector<std::int32_t> seeds;
    for (std::size_t c = 0; c < quality.size(); ++c) {
        if (quality[c] < bad) {
            seeds.push_back(static_cast<std::int32_t>(c));
        }
    }
    if (seeds.size() > most_seeds) {
        std::stable_sort(seeds.begin(), seeds.end(), [&](std::int32_t a, std::int32_t b) {
            return quality[static_cast<std::size_t>(a)] < quality[static_cast<std::size_t>(b)];
        });
        seeds.resize(most_seeds);
    }
    Part part;
    std::vector<char> taken(quality.size(), 0);
    std::vector<char> known(on.size(), 0);
    const auto take = [&](std::int32_t c) {
        taken[static_cast<std::size_t>(c)] = 1;
        part.cells.push_back(c);
        for (std::size_t k = 0; k < per; ++k) {
            known[static_cast<std::size_t>(cells[static_cast<std::size_t>(c) * per + k])] = 1;
        }
    };
    for (const std::int32_t c : seeds) {
        take(c);
    }
    std::vector<char> front;
    for (int layer = 0; layer < layers && part.cells.size() < most_cells; ++layer) {
        front = known; // which take() changes
        for (std::size_t c = 0; c < quality.size(); ++c) {
            bool touches = false;
            for (std::size_t k = 0; k < per && taken[c] == 0; ++k) {
                touches = touches || front[static_cast<std::size_t>(cells[c * per + k])] != 0;
            }
            if (touches) {
                take(static_cast<std::int32_t>(c));
            }
        }
    }
    std::sort(part.cells.begin(), part.cells.end());
    part.local.assign(on.size(), -1);
    for (std::size_t n = 0; n < on.size(); ++n) {
        if (known[n] != 0) {
            part.local[n] = static_cast<std::int32_t>(part.nodes.size());
            part.nodes.push_back(static_cast<std::int32_t>(n));
            part.on.push_back(on[n]);
        }
    }
    for (std::size_t c = 0; c < quality.size(); ++c) {
        for (std::size_t k = 0; k < per && taken[c] == 0; ++k) {
            const std::int32_t l = part.local[static_cast<std::size_t>(cells[c * per + k])];
            if (l >= 0) {
                part.on[static_cast<std::size_t>(l)] = {-1, 0};
            }
        }
    }
    return part;
}

// Scaled Jacobians of all cells. A quad that looks away from the one before it, on the same face,
// is folded over it.
std::vector<double> qualities(std::span<const Vec3> points, std::span<const std::int32_t> cells,
                              std::size_t per, std::span<const std::int32_t> face_of) {
    std::vector<double> result(cells.size() / per);
    std::vector<Vec3> normals(per == 4 ? result.size() : 0);
    constexpr std::size_t grain = 4096;
    parallel_for(result.size(), grain, [&](std::size_t from, std::size_t to) {
        std::array<Vec3, 8> p{};
        for (std::size_t c = from; c < to; ++c) {
            for (std::size_t k = 0; k < per; ++k) {
                p[k] = points[static_cast<std::size_t>(cells[c * per + k])];
            }
            result[c] =
                per == 8 ? hexahedron::scaled_jacobian(p.data()) : quad::scaled_jacobian(p.data());
            if (per == 4) {
                normals[c] = cross(p[2] - p[0], p[3] - p[1]);
            }
        }
    });
    for (std::size_t c = 1; c < normals.size(); ++c) {
        if (face_of[c] == face_of[c - 1] && dot(normals[c], normals[c - 1]) < 0) {
            result[c] = std::min(result[c], -0.5);
            result[c - 1] = std::min(result[c - 1], -0.5);
        }
    }
    return result;
}

void improve_part(const CadShape &shape, std::span<Vec3> points,
                  std::span<const std::int32_t> cells, std::size_t per,
                  std::span<const std::int32_t> face_of, const Part &part,
                  const UntangleOptions &options, const Progress &progress,
                  std::vector<char> &moved) {
    std::vector<Vec3> places;
    for (const std::int32_t n : part.nodes) {
        places.push_back(points[static_cast<std::size_t>(n)]);
    }
    Cells local;
    for (const std::int32_t c : part.cells) {
        const auto node = [&](std::size_t k) {
            return part
                .local[static_cast<std::size_t>(cells[static_cast<std::size_t>(c) * per + k])];
        };
        if (per == 8) {
            auto &h = local.hexahedra.emplace_back();
            for (std::size_t k = 0; k < 8; ++k) {
                h[k] = node(k);
            }
        } else {
            auto &q = local.quads.emplace_back();
            for (std::size_t k = 0; k < 4; ++k) {
                q[k] = node(k);
            }
            local.face_of.push_back(face_of[static_cast<std::size_t>(c)]);
        }
    }
    CadSlides slides(shape, part.on, local.face_of);
    // So many visits of a node take a second or so.
    constexpr std::size_t most_visits = 100'000;
    UntangleOptions bounded = options;
    bounded.raises = 5000;
    bounded.sweeps =
        std::min(options.sweeps, std::max(6, static_cast<int>(most_visits / (places.size() + 1))));
    untangle(places, local.hexahedra, local.quads, slides, bounded, progress);
    for (std::size_t n = 0; n < places.size(); ++n) {
        Vec3 &p = points[static_cast<std::size_t>(part.nodes[n])];
        if (!(p == places[n])) {
            p = places[n];
            moved[static_cast<std::size_t>(part.nodes[n])] = 1;
        }
    }
}

} // namespace

double worst_scaled_jacobian(const CadShape &shape, const Layout &layout, std::size_t first) {
    Cells cells = cells_of(layout, first);
    std::vector<Vec3> points = layout.points;
    CadSlides slides(shape, layout.on, cells.face_of);
    UntangleOptions none;
    none.good = -2; // measures and moves nothing
    return untangle(points, cells.hexahedra, cells.quads, slides, none).after;
}

double improve(const CadShape &shape, Layout &layout, const UntangleOptions &options,
               const Progress &progress) {
    const Cells cells = cells_of(layout, 0);
    const std::vector<Vec3> before = layout.points;
    CadSlides slides(shape, layout.on, cells.face_of);
    UntangleOptions bounded = options;
    constexpr std::size_t most_visits = 300'000;
    bounded.sweeps =
        std::min(options.sweeps, std::max(8, static_cast<int>(most_visits / (before.size() + 1))));
    const UntangleResult result =
        untangle(layout.points, cells.hexahedra, cells.quads, slides, bounded, progress);
    if (!in_order(shape, layout)) {
        layout.points = before;
        return result.before;
    }
    for (auto &[ends, middle] : layout.middles) {
        const auto a = static_cast<std::size_t>(ends[0]);
        const auto b = static_cast<std::size_t>(ends[1]);
        middle += 0.5 * (layout.points[a] - before[a] + layout.points[b] - before[b]);
    }
    // A middle on a face keeps to it.
    BorrowedGeometry geometry(shape);
    for (const auto &quad : layout.quads) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::int32_t a = quad.points[i];
            const std::int32_t b = quad.points[(i + 1) % 4];
            const auto found = layout.middles.find(ascending(a, b));
            if (found != layout.middles.end() && (!(layout.points[static_cast<std::size_t>(a)] ==
                                                    before[static_cast<std::size_t>(a)]) ||
                                                  !(layout.points[static_cast<std::size_t>(b)] ==
                                                    before[static_cast<std::size_t>(b)]))) {
                FaceProjection &face = geometry->face(quad.face);
                face.start(layout.points[static_cast<std::size_t>(a)]);
                found->second = face.nearest(found->second);
            }
        }
    }
    return result.after;
}

bool has_bad_cells(std::span<const Vec3> points, std::span<const std::int32_t> hexahedra,
                   std::span<const std::int32_t> quads, std::span<const std::int32_t> face_of,
                   double bad) {
    const std::size_t per = hexahedra.empty() ? 4 : 8;
    const auto all = qualities(points, hexahedra.empty() ? quads : hexahedra, per, face_of);
    return std::any_of(all.begin(), all.end(), [&](double q) { return q < bad; });
}

std::vector<std::int32_t> improve_mesh(const CadShape &shape, std::span<Vec3> points,
                                       std::span<const CadEntity> on,
                                       std::span<const std::int32_t> hexahedra,
                                       std::span<const std::int32_t> quads,
                                       std::span<const std::int32_t> face_of, double bad,
                                       const UntangleOptions &options, const Progress &progress) {
    const std::size_t per = hexahedra.empty() ? 4 : 8;
    const auto cells = hexahedra.empty() ? quads : hexahedra;
    std::vector<char> moved(points.size(), 0);
    double last = -2;
    // One neighbourhood of the worst after the other.
    constexpr int rounds = 6;
    for (int round = 0; round < rounds; ++round) {
        const auto quality = qualities(points, cells, per, face_of);
        const Part part = part_round(quality, bad, cells, per, on);
        const double worst =
            quality.empty() ? 1 : *std::min_element(quality.begin(), quality.end());
        if (part.cells.empty() || worst <= last + options.gain) {
            break;
        }
        last = worst;
        improve_part(shape, points, cells, per, face_of, part, options, progress, moved);
    }
    std::vector<std::int32_t> result;
    for (std::size_t n = 0; n < moved.size(); ++n) {
        if (moved[n] != 0) {
            result.push_back(static_cast<std::int32_t>(n));
        }
    }
    return result;
}

void raise_mesh(const CadShape &shape, std::span<Vec3> points, std::span<const CadEntity> on,
                std::span<const std::array<std::int32_t, 8>> hexahedra, double good, int visits,
                const Progress &progress) {
    CadSlides slides(shape, on, {});
    UntangleOptions options;
    options.each = true;
    options.good = good;
    options.raises = visits;
    untangle(points, hexahedra, {}, slides, options, progress);
}

bool improve_spots(const CadShape &shape, std::span<Vec3> points, std::span<const CadEntity> on,
                   std::span<const std::array<std::int32_t, 8>> hexahedra, double bad, double good,
                   int most, const Progress &progress) {
    constexpr int layers = 2;
    std::vector<std::vector<std::int32_t>> of(points.size());
    const auto quality = [&](std::int32_t c) {
        std::array<Vec3, 8> p{};
        for (std::size_t k = 0; k < 8; ++k) {
            p[k] = points[static_cast<std::size_t>(hexahedra[static_cast<std::size_t>(c)][k])];
        }
        return hexahedron::scaled_jacobian(p.data());
    };
    std::vector<std::pair<double, std::int32_t>> order;
    for (std::size_t c = 0; c < hexahedra.size(); ++c) {
        for (const std::int32_t n : hexahedra[c]) {
            of[static_cast<std::size_t>(n)].push_back(static_cast<std::int32_t>(c));
        }
        const double q = quality(static_cast<std::int32_t>(c));
        if (q < bad) {
            order.emplace_back(q, static_cast<std::int32_t>(c));
        }
    }
    std::sort(order.begin(), order.end());
    std::vector<char> done(hexahedra.size(), 0); // bad ones next to the middle of an earlier spot
    std::vector<std::int32_t> local(points.size(), -1);
    std::vector<char> taken(hexahedra.size(), 0);
    int spots = 0;
    for (const auto &[known, seed] : order) {
        if (done[static_cast<std::size_t>(seed)] != 0 || quality(seed) >= bad) {
            continue;
        }
        if (++spots > most) {
            break;
        }
        poll(progress, static_cast<double>(spots) / most);
        std::vector<std::int32_t> cells{seed};
        taken[static_cast<std::size_t>(seed)] = 1;
        std::size_t inner = 0; // cells all of whose neighbours are there
        for (int layer = 0; layer < layers; ++layer) {
            inner = cells.size();
            for (std::size_t i = 0; i < inner; ++i) {
                for (const std::int32_t n : hexahedra[static_cast<std::size_t>(cells[i])]) {
                    for (const std::int32_t c : of[static_cast<std::size_t>(n)]) {
                        if (taken[static_cast<std::size_t>(c)] == 0) {
                            taken[static_cast<std::size_t>(c)] = 1;
                            cells.push_back(c);
                        }
                    }
                }
            }
        }
        std::vector<std::int32_t> nodes;
        std::vector<std::array<std::int32_t, 8>> mine;
        std::vector<CadEntity> where;
        std::vector<Vec3> places;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            auto &cell = mine.emplace_back(hexahedra[static_cast<std::size_t>(cells[i])]);
            for (std::int32_t &n : cell) {
                std::int32_t &number = local[static_cast<std::size_t>(n)];
                if (number < 0) {
                    number = static_cast<std::int32_t>(nodes.size());
                    nodes.push_back(n);
                    places.push_back(points[static_cast<std::size_t>(n)]);
                    where.push_back(i < inner ? on[static_cast<std::size_t>(n)]
                                              : CadEntity{-1, 0});
                }
                n = number;
            }
        }
        CadSlides slides(shape, where, {});
        UntangleOptions options;
        options.good = good;
        options.raises = 2000;
        options.sweeps = 30;
        untangle(places, mine, {}, slides, options, progress);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            points[static_cast<std::size_t>(nodes[n])] = places[n];
            local[static_cast<std::size_t>(nodes[n])] = -1;
        }
        for (const std::int32_t c : cells) {
            taken[static_cast<std::size_t>(c)] = 0;
        }
        done[static_cast<std::size_t>(seed)] = 1;
        for (const std::int32_t n : hexahedra[static_cast<std::size_t>(seed)]) {
            for (const std::int32_t c : of[static_cast<std::size_t>(n)]) {
                done[static_cast<std::size_t>(c)] = 1;
            }
        }
    }
    return spots > 0;
}

} // namespace nmgs::cad
