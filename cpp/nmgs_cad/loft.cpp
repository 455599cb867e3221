// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/loft.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/face_layout.h"
#include "nmgs_cad/face_projection.h"
#include "nmgs_cad/hexas_on_cad.h"
#include "nmgs_cad/loft_rings.h"

#include <gp_Mat.hxx>

#include <algorithm>
#include <cmath>
#include <set>

namespace nmgs::cad {
namespace {

using Pair = std::array<std::int32_t, 2>;

// The affine map that takes points to others with least squares, and their plane's normal along.
struct Affine {
    Vec3 from{}, to{};
    gp_Mat matrix;

    Affine(const std::vector<Vec3> &p, const std::vector<Vec3> &q, Vec3 area_p, Vec3 area_q) {
        const double share = 1.0 / static_cast<double>(p.size());
        for (std::size_t i = 0; i < p.size(); ++i) {
            from += share * p[i];
            to += share * q[i];
        }
        gp_Mat pp(0, 0, 0, 0, 0, 0, 0, 0, 0);
        gp_Mat qp(0, 0, 0, 0, 0, 0, 0, 0, 0);
        const auto add = [](gp_Mat &m, Vec3 a, Vec3 b, double weight) {
            const gp_XYZ x(weight * a.x, weight * a.y, weight * a.z);
            gp_Mat one;
            one.SetCols(b.x * x, b.y * x, b.z * x);
            m += one;
        };
        for (std::size_t i = 0; i < p.size(); ++i) {
            add(pp, p[i] - from, p[i] - from, share);
            add(qp, q[i] - to, p[i] - from, share);
        }
        const double np = norm(area_p);
        const double nq = norm(area_q);
        if (np > 0 && nq > 0) {
            const Vec3 a = (1 / std::sqrt(np)) * area_p;
            const Vec3 b = (1 / std::sqrt(nq)) * area_q;
            add(pp, a, a, 0.1);
            add(qp, b, a, 0.1);
        }
        matrix = qp * pp.Inverted();
    }
    [[nodiscard]] Vec3 operator()(Vec3 p) const {
        const Vec3 d = p - from;
        const gp_XYZ r = matrix * gp_XYZ(d.x, d.y, d.z);
        return to + Vec3{r.X(), r.Y(), r.Z()};
    }
};

struct Loft {
    const CadShape &shape;
    const LoftRings &rings;
    const Layout &scratch; // in which the source is laid out
    double angle;

    std::vector<Layout::Quad> quads; // of the source
    std::vector<std::int32_t> nodes; // points of the scratch layout, those on the boundary first
    std::map<std::int32_t, std::size_t> index;
    std::size_t boundary = 0;
    std::vector<std::vector<std::size_t>> neighbours;
    // Where a boundary node is on a ring: a vertex, or an edge and the fraction along its curve.
    struct Track {
        int vertex = 0, edge = 0;
        double fraction = 0;
    };
    std::vector<std::vector<Track>> tracks; // [ring][node]; one more than rings
    std::vector<std::vector<Vec3>> layers;  // [half layer][node]
    std::vector<std::size_t> ring_of;       // of each layer's interval
    std::map<int, EdgeCurve> curves;
    std::map<int, FaceProjection> projections;
    std::map<int, FaceSurface> surfaces;
    std::map<std::array<std::size_t, 2>, int> edge_between; // boundary nodes joined along an edge

    EdgeCurve &curve(int e) { return curves.try_emplace(e, shape.edge(e)).first->second; }
    FaceProjection &face(int f) { return projections.try_emplace(f, shape.face(f)).first->second; }

    FaceSurface &surface(int f) { return surfaces.try_emplace(f, shape.face(f)).first->second; }

    void collect();
    void follow();
    [[nodiscard]] std::size_t segments(std::size_t ring);
    Uv parameters(const LoftWall &wall, const EdgeUse &use, double f);
    Vec3 on_wall(const LoftWall &wall, double s, double t);
    void place_boundary();
    void place_inside();
    [[nodiscard]] HexaMesh mesh();
};

void Loft::collect() {
    std::set<std::int32_t> rim;
    for (const auto &[e, wall] : rings.rings.front()) {
        const auto &points = scratch.edges[static_cast<std::size_t>(e)];
        rim.insert(points.begin(), points.end());
    }
    nodes.assign(rim.begin(), rim.end());
    boundary = nodes.size();
    for (const auto &quad : scratch.quads) {
        if (quad.face == rings.source) {
            quads.push_back(quad);
            for (const auto p : quad.points) {
                if (rim.insert(p).second) {
                    nodes.push_back(p);
                }
            }
        }
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        index[nodes[n]] = n;
    }
    neighbours.resize(nodes.size());
    std::set<Pair> seen;
    for (const auto &quad : quads) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Pair key = ascending(quad.points[i], quad.points[(i + 1) % 4]);
            if (seen.insert(key).second) {
                neighbours[index[key[0]]].push_back(index[key[1]]);
                neighbours[index[key[1]]].push_back(index[key[0]]);
            }
        }
    }
}

// The boundary's nodes from ring to ring.
void Loft::follow() {
    tracks.assign(rings.rings.size() + 1, std::vector<Track>(boundary));
    for (const auto &[e, wall] : rings.rings.front()) {
        const auto &points = scratch.edges[static_cast<std::size_t>(e)];
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t n = index[points[i]];
            if (i + 1 < points.size()) {
                const std::size_t m = index[points[i + 1]];
                edge_between[{std::min(n, m), std::max(n, m)}] = e;
            }
            if (i == 0 || i + 1 == points.size()) {
                tracks[0][n].vertex = scratch.on[at(points[i])].index;
            } else {
                tracks[0][n] = {0, e, curve(e).fraction(scratch.points[at(points[i])])};
            }
        }
    }
    for (std::size_t r = 0; r < rings.rings.size(); ++r) {
        std::map<int, int> up;
        for (const auto &[e, wall] : rings.rings[r]) {
            up[wall.low.vertex] = wall.left.vertex;
            up[wall.right.vertex] = wall.high.vertex;
        }
        for (std::size_t n = 0; n < boundary; ++n) {
            const Track &here = tracks[r][n];
            Track &next = tracks[r + 1][n];
            if (here.vertex != 0) {
                next.vertex = up[here.vertex];
            } else {
                const LoftWall &wall = rings.rings[r].at(here.edge);
                const double s = wall.low.forward ? here.fraction : 1 - here.fraction;
                next = {0, wall.high.edge, wall.high.forward ? 1 - s : s};
            }
        }
    }
}

std::size_t Loft::segments(std::size_t ring) {
    double turn = 0;
    for (const auto &[e, wall] : rings.rings[ring]) {
        const EdgeCurve &side = curve(wall.right.edge);
        double sum = 0;
        for (int i = 0; i < 32; ++i) {
            const Vec3 a = side.tangent(i / 32.0);
            const Vec3 b = side.tangent((i + 1) / 32.0);
            sum += std::acos(std::clamp(dot(a, b), -1.0, 1.0));
        }
        turn = std::max(turn, sum);
    }
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(turn / angle - 0.01)));
}

// Parameters of the wall's surface at a fraction along a use of one of its edges.
Uv Loft::parameters(const LoftWall &wall, const EdgeUse &use, double f) {
    const double g = use.forward ? f : 1 - f;
    return surface(wall.face).nearest(curve(use.edge).at(g),
                                      use.at(use.first + g * (use.last - use.first)));
}

// At fractions along the low edge's use and up: by parameters, which follow a wall that is bent.
Vec3 Loft::on_wall(const LoftWall &wall, double s, double t) {
    const auto at_use = [&](const EdgeUse &use, double f) { return parameters(wall, use, f); };
    const Uv corners = (1 - t) * ((1 - s) * at_use(wall.low, 0) + s * at_use(wall.low, 1)) +
                       t * ((1 - s) * at_use(wall.high, 1) + s * at_use(wall.high, 0));
    const Uv sides = (1 - t) * at_use(wall.low, s) + t * at_use(wall.high, 1 - s) +
                     (1 - s) * at_use(wall.left, 1 - t) + s * at_use(wall.right, t);
    return surface(wall.face).at(sides - corners);
}

void Loft::place_boundary() {
    for (std::size_t r = 0; r < rings.rings.size(); ++r) {
        std::map<int, const EdgeUse *> upright; // by the vertex below, of walls whose left it is
        for (const auto &[e, wall] : rings.rings[r]) {
            upright[wall.low.vertex] = &wall.left;
        }
        std::map<int, const EdgeUse *> upright_right;
        for (const auto &[e, wall] : rings.rings[r]) {
            upright_right[wall.right.vertex] = &wall.right;
        }
        const std::size_t count = segments(r);
        for (std::size_t h = r == 0 ? 0 : 1; h <= 2 * count; ++h) {
            const double t = static_cast<double>(h) / static_cast<double>(2 * count);
            std::vector<Vec3> layer(nodes.size());
            for (std::size_t n = 0; n < boundary; ++n) {
                const Track &track = tracks[r][n];
                if (track.vertex != 0) {
                    const auto left = upright.find(track.vertex);
                    if (left != upright.end()) {
                        const EdgeUse &u = *left->second; // runs down
                        layer[n] = curve(u.edge).at(u.forward ? 1 - t : t);
                    } else {
                        const EdgeUse &u = *upright_right.at(track.vertex);
                        layer[n] = curve(u.edge).at(u.forward ? t : 1 - t);
                    }
                    continue;
                }
                const LoftWall &wall = rings.rings[r].at(track.edge);
                const double s = wall.low.forward ? track.fraction : 1 - track.fraction;
                if (h == 0) {
                    layer[n] = curve(track.edge).at(track.fraction);
                } else if (h == 2 * count) {
                    layer[n] = curve(wall.high.edge).at(wall.high.forward ? 1 - s : s);
                } else {
                    layer[n] = on_wall(wall, s, t);
                }
            }
            layers.push_back(std::move(layer));
        }
        ring_of.insert(ring_of.end(), count, r);
    }
}

void Loft::place_inside() {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        layers[0][n] = scratch.points[at(nodes[n])];
    }
    // The boundary's area by its edges as the quads run along them.
    std::vector<std::array<std::size_t, 2>> rim;
    for (const auto &quad : quads) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t a = index[quad.points[i]];
            const std::size_t b = index[quad.points[(i + 1) % 4]];
            if (edge_between.contains(ascending(a, b))) {
                rim.push_back({a, b});
            }
        }
    }
    const auto area_of = [&](const std::vector<Vec3> &layer) {
        Vec3 sum{};
        const Vec3 origin = layer[0];
        for (const auto &[a, b] : rim) {
            sum += 0.5 * cross(layer[a] - origin, layer[b] - origin);
        }
        return sum;
    };
    const auto first = static_cast<std::ptrdiff_t>(boundary);
    const std::vector<Vec3> from(layers[0].begin(), layers[0].begin() + first);
    std::vector<Vec3> shift(nodes.size());
    for (std::size_t l = 1; l < layers.size(); ++l) {
        auto &layer = layers[l];
        const std::vector<Vec3> to(layer.begin(), layer.begin() + first);
        const Affine affine(from, to, area_of(layers[0]), area_of(layer));
        for (std::size_t n = 0; n < boundary; ++n) {
            shift[n] = layer[n] - affine(layers[0][n]);
        }
        for (int sweep = 0; sweep < 300; ++sweep) {
            double largest = 0;
            for (std::size_t n = boundary; n < nodes.size(); ++n) {
                Vec3 sum{};
                for (const std::size_t m : neighbours[n]) {
                    sum += shift[m];
                }
                sum = (1.0 / static_cast<double>(neighbours[n].size())) * sum;
                largest = std::max(largest, norm(sum - shift[n]));
                shift[n] = sum;
            }
            if (largest < 1e-9 * norm(layers[0][0] - layer[0])) {
                break;
            }
        }
        for (std::size_t n = boundary; n < nodes.size(); ++n) {
            layer[n] = affine(layers[0][n]) + shift[n];
        }
    }
    // Onto the target, and the layers before it a little less.
    const auto predicted = layers.back();
    FaceProjection &target = face(rings.target);
    for (std::size_t n = boundary; n < nodes.size(); ++n) {
        target.forget();
        const Vec3 move = target.nearest(predicted[n]) - predicted[n];
        for (std::size_t l = 1; l < layers.size(); ++l) {
            layers[l][n] +=
                (static_cast<double>(l) / static_cast<double>(layers.size() - 1)) * move;
        }
    }
}

HexaMesh Loft::mesh() {
    HexaMesh result;
    const std::size_t count = nodes.size();
    for (std::size_t l = 0; l < layers.size(); l += 2) {
        result.points.insert(result.points.end(), layers[l].begin(), layers[l].end());
    }
    const auto number = [&](std::size_t layer, std::size_t n) {
        return static_cast<std::int32_t>(layer * count + n);
    };
    const auto middle = [&](std::int32_t a, std::int32_t b, Vec3 place) {
        result.middles[ascending(a, b)] = place;
    };
    const std::size_t last = (layers.size() - 1) / 2;
    // Upright edges: through the half layers.
    for (std::size_t l = 0; l < last; ++l) {
        for (std::size_t n = 0; n < count; ++n) {
            middle(number(l, n), number(l + 1, n), layers[2 * l + 1][n]);
        }
    }
    // Edges along the layers: on an edge of the CAD, a wall, the source or the target.
    std::set<std::array<std::size_t, 2>> done;
    for (const auto &quad : quads) {
        for (std::size_t i = 0; i < 4; ++i) {
            std::size_t a = index[quad.points[i]];
            std::size_t b = index[quad.points[(i + 1) % 4]];
            if (a > b) {
                std::swap(a, b);
            }
            if (!done.insert({a, b}).second) {
                continue;
            }
            const auto known = edge_between.find({a, b});
            std::size_t ring_start = 0;
            for (std::size_t l = 0; l <= last; ++l) {
                const Vec3 straight = 0.5 * (layers[2 * l][a] + layers[2 * l][b]);
                if (l > 0 && l < last && ring_of[l] != ring_of[l - 1]) {
                    ring_start = l;
                }
                if (known == edge_between.end()) {
                    if (l == 0 || l == last) {
                        FaceProjection &f = face(l == 0 ? rings.source : rings.target);
                        f.forget();
                        middle(number(l, a), number(l, b), f.nearest(straight));
                    }
                    continue;
                }
                const std::size_t ring = l == last ? ring_of[l - 1] : ring_of[l];
                // The edge of the ring below, and the wall over it.
                int low = known->second;
                for (std::size_t r = 0; r < ring; ++r) {
                    low = rings.rings[r].at(low).high.edge;
                }
                const LoftWall &wall = rings.rings[ring].at(low);
                const int on = l == last ? wall.high.edge : l == ring_start ? low : 0;
                if (on != 0) {
                    EdgeCurve &c = curve(on);
                    FaceProjection &f = face(wall.face);
                    f.forget();
                    const auto part =
                        c.part(layers[2 * l][a], f.nearest(straight), layers[2 * l][b]);
                    middle(number(l, a), number(l, b), c.at(0.5 * (part.from + part.to)));
                } else {
                    FaceProjection &f = face(wall.face);
                    f.forget();
                    middle(number(l, a), number(l, b), f.nearest(straight));
                }
            }
        }
    }
    for (const auto &quad : quads) {
        for (std::size_t l = 0; l < last; ++l) {
            std::array<std::int32_t, 8> hexa{};
            for (std::size_t i = 0; i < 4; ++i) {
                hexa[i] = number(l, index[quad.points[i]]);
                hexa[i + 4] = number(l + 1, index[quad.points[i]]);
            }
            result.hexas.push_back(hexa);
        }
    }
    return result;
}

} // namespace

bool fill_loft(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
               Refusal &refusal, const Progress &progress) {
    const auto rings = loft_rings(shape, solid);
    if (!rings) {
        refusal = {"its faces are not rings of four-sided ones between two others",
                   {entity_name(3, solid)}};
        return false;
    }
    Layout scratch = layout;
    if (!layout_face(shape, rings->source, scratch, options, refusal, progress)) {
        return false;
    }
    Loft loft{shape, *rings, scratch, options.angle, {}, {}, {}, 0, {}, {}, {}, {}, {}, {}, {}, {}};
    loft.collect();
    loft.follow();
    loft.place_boundary();
    loft.place_inside();
    poll(progress, 0.8);
    return add_hexas(shape, solid, loft.mesh(), layout, refusal);
}

} // namespace nmgs::cad
