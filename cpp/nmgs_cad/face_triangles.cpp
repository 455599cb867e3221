// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_triangles.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs/support/predicates.h"
#include "nmgs_cad/constrained_delaunay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace nmgs::cad {
namespace {

constexpr double pi = std::numbers::pi;
using Triangle = std::array<std::int32_t, 3>;
using Pair = std::array<std::int32_t, 2>;

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 d = b - a;
    const double l = norm2(d);
    const double t = l > 0 ? std::clamp(dot(p - a, d) / l, 0.0, 1.0) : 0.0;
    return distance(p, a + t * d);
}

struct Placer {
    const FaceSurface &surface;
    const FaceMesh &mesh;
    const std::vector<Pair> &segments;
    const Spacing &spacing;
    const std::vector<Segment> &bounds;
    std::vector<Vec3> sources;
    std::vector<double> asked;
    std::vector<Uv> accepted;
    std::vector<Vec3> places;

    [[nodiscard]] double wanted(Uv p, Vec3 x) const {
        constexpr double growth = 0.5;
        constexpr double finest = 0.3;
        double h = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < sources.size(); ++i) {
            h = std::min(h, asked[i] + growth * distance(x, sources[i]));
        }
        h *= spacing.scale;
        const double k = surface.curvature(p);
        if (k > 0 && spacing.angle > 0) {
            // Not without end: at the tip of a cone there is no curvature.
            h = std::max(std::min(h, spacing.angle / k), finest * h);
        }
        return spacing.size > 0 ? std::min(h, spacing.size) : h;
    }
    // The domain is on the left of its boundary: the crossings of a ray, counted with their sign.
    [[nodiscard]] bool inside(Uv p) const {
        int winding = 0;
        for (const Segment &s : bounds) {
            const Uv a = mesh.uv[at(s.a)];
            const Uv b = mesh.uv[at(s.b)];
            if ((a.v <= p.v) != (b.v <= p.v)) {
                const double u = a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u);
                if (u > p.u) {
                    winding += b.v > a.v ? 1 : -1;
                }
            }
        }
        return winding != 0;
    }
    void consider(Uv p) {
        const Vec3 x = surface.at(p);
        const double h = wanted(p, x);
        for (const Vec3 q : places) {
            if (norm2(q - x) < 0.4 * h * h) {
                return;
            }
        }
        for (const Pair &s : segments) {
            if (distance_to_segment(x, mesh.points[at(s[0])], mesh.points[at(s[1])]) < 0.55 * h) {
                return;
            }
        }
        if (inside(p)) {
            accepted.push_back(p);
            places.push_back(x);
        }
    }
    void divide(Uv low, Uv high, int depth) {
        const Uv middle = 0.5 * (low + high);
        const Vec3 x = surface.at(middle);
        const auto across = [&](bool along_u) {
            const Uv a = along_u ? Uv{low.u, middle.v} : Uv{middle.u, low.v};
            const Uv b = along_u ? Uv{high.u, middle.v} : Uv{middle.u, high.v};
            double length = 0;
            Vec3 last = surface.at(a);
            for (int i = 1; i <= 4; ++i) {
                const Vec3 next = surface.at(a + (0.25 * i) * (b - a));
                length += distance(last, next);
                last = next;
            }
            return length;
        };
        const double u = across(true);
        const double v = across(false);
        const double h = 1.42 * wanted(middle, x);
        constexpr int deepest = 22;
        constexpr std::size_t most = 20000;
        if ((u > h || v > h) && depth < deepest && accepted.size() < most) {
            if (u > v) {
                divide(low, {middle.u, high.v}, depth + 1);
                divide({middle.u, low.v}, high, depth + 1);
            } else {
                divide(low, {high.u, middle.v}, depth + 1);
                divide({low.u, middle.v}, high, depth + 1);
            }
            return;
        }
        consider(middle);
    }
};

// The fourth corners of the quads in sharp corners of the face: a little beyond the line between
// their neighbours, so that only the corner itself is sharp.
std::vector<Uv> points_in_tips(const FaceMesh &mesh) {
    constexpr double sharp = 0.35;
    constexpr double beyond = 0.3; // of the line's length
    std::vector<Uv> result;
    for (std::size_t n = 0; n < mesh.rim.size(); ++n) {
        const FaceMesh::Rim &rim = mesh.rim[n];
        if (rim.before < 0 || rim.after < 0 || rim.angle >= sharp || norm2(mesh.normals[n]) == 0) {
            continue;
        }
        const Vec3 a = mesh.points[at(rim.before)];
        const Vec3 b = mesh.points[at(rim.after)];
        const Vec3 middle = 0.5 * (a + b);
        const double way = distance(middle, mesh.points[n]);
        if (way > distance(a, b)) {
            const Uv half = 0.5 * (mesh.uv[at(rim.before)] + mesh.uv[at(rim.after)]);
            const double share = beyond * distance(a, b) / way;
            result.push_back(half + share * (half - mesh.uv[n]));
        }
    }
    return result;
}

// Signed by the normal; 1 for an equilateral triangle.
double shape_of(const FaceMesh &mesh, const Triangle &t) {
    const Vec3 a = mesh.points[at(t[0])];
    const Vec3 b = mesh.points[at(t[1])];
    const Vec3 c = mesh.points[at(t[2])];
    const Vec3 n = mesh.normals[at(t[0])] + mesh.normals[at(t[1])] + mesh.normals[at(t[2])];
    const Vec3 area = cross(b - a, c - a);
    const double lengths = norm2(b - a) + norm2(c - b) + norm2(a - c);
    const double sign = norm2(n) > 0 && dot(area, n) < 0 ? -1 : 1;
    return lengths > 0 ? sign * 2 * std::sqrt(3.0) * norm(area) / lengths : -1;
}

struct Flipper {
    FaceTriangles &result;
    const std::vector<Point2> &plane;
    const std::vector<char> &pole;
    std::map<Pair, std::int32_t> of_edge;

    void index() {
        of_edge.clear();
        for (std::size_t t = 0; t < result.triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto &v = result.triangles[t];
                of_edge[{v[i], v[(i + 1) % 3]}] = static_cast<std::int32_t>(t);
            }
        }
    }
    [[nodiscard]] bool upright(const Triangle &t) const {
        if (pole[at(t[0])] != 0 || pole[at(t[1])] != 0 || pole[at(t[2])] != 0) {
            return true;
        }
        const auto &a = plane[at(t[0])];
        const auto &b = plane[at(t[1])];
        const auto &c = plane[at(t[2])];
        return orient2d(a[0], a[1], b[0], b[1], c[0], c[1]) > 0;
    }
    bool pass() {
        bool any = false;
        index();
        std::vector<Pair> edges;
        for (const auto &entry : of_edge) {
            edges.push_back(entry.first);
        }
        for (const Pair &e : edges) {
            const auto left = of_edge.find(e);
            const auto right = of_edge.find({e[1], e[0]});
            if (left == of_edge.end() || right == of_edge.end() ||
                result.kept.contains(ascending(e[0], e[1]))) {
                continue;
            }
            const std::int32_t s = left->second;
            const std::int32_t t = right->second;
            const auto third = [&](std::int32_t k) {
                for (const std::int32_t v : result.triangles[at(k)]) {
                    if (v != e[0] && v != e[1]) {
                        return v;
                    }
                }
                return std::int32_t{-1};
            };
            const std::int32_t c = third(s);
            const std::int32_t d = third(t);
            if (c < 0 || d < 0 || c == d || of_edge.contains({c, d}) || of_edge.contains({d, c})) {
                continue;
            }
            const Triangle one{e[0], d, c};
            const Triangle two{d, e[1], c};
            if (!upright(one) || !upright(two)) {
                continue;
            }
            const double before = std::min(shape_of(result.nodes, result.triangles[at(s)]),
                                           shape_of(result.nodes, result.triangles[at(t)]));
            const double after = std::min(shape_of(result.nodes, one), shape_of(result.nodes, two));
            if (after > before + 1e-6) {
                result.triangles[at(s)] = one;
                result.triangles[at(t)] = two;
                of_edge.erase(e);
                of_edge.erase({e[1], e[0]});
                for (const auto &[k, tri] : {std::pair{s, one}, std::pair{t, two}}) {
                    for (std::size_t i = 0; i < 3; ++i) {
                        of_edge[{tri[i], tri[(i + 1) % 3]}] = k;
                    }
                }
                any = true;
            }
        }
        return any;
    }
};

// One node a pole: the two ends of its degenerated edge become one, and the triangle between goes.
void join_poles(const std::vector<BoundaryLoop> &boundary,
                const std::vector<std::vector<std::int32_t>> &numbers, FaceTriangles &result,
                std::vector<char> &pole) {
    FaceMesh &mesh = result.nodes;
    for (std::size_t l = 0; l < boundary.size(); ++l) {
        const std::size_t count = boundary[l].size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::int32_t keep = numbers[l][i];
            const std::int32_t gone = numbers[l][(i + 1) % count];
            if (!boundary[l][i].pole || keep == gone ||
                mesh.layout_point[at(keep)] != mesh.layout_point[at(gone)]) {
                continue;
            }
            for (Triangle &t : result.triangles) {
                std::replace(t.begin(), t.end(), gone, keep);
            }
            std::erase_if(result.triangles, [](const Triangle &t) {
                return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
            });
            mesh.rim[at(keep)].after = mesh.rim[at(gone)].after;
            mesh.rim[at(keep)].to_after = mesh.rim[at(gone)].to_after;
            mesh.rim[at(keep)].middle_after = mesh.rim[at(gone)].middle_after;
            for (auto &rim : mesh.rim) {
                rim.before = rim.before == gone ? keep : rim.before;
                rim.after = rim.after == gone ? keep : rim.after;
            }
            if (mesh.rim[at(keep)].before == keep) {
                mesh.rim[at(keep)].before = mesh.rim[at(gone)].before;
            }
            // No single normal, and the angle is what the triangles have there.
            mesh.normals[at(keep)] = {0, 0, 0};
            double angle = 0;
            for (const Triangle &t : result.triangles) {
                for (std::size_t c = 0; c < 3; ++c) {
                    if (t[c] == keep) {
                        const Vec3 a = mesh.points[at(t[(c + 1) % 3])] - mesh.points[at(keep)];
                        const Vec3 b = mesh.points[at(t[(c + 2) % 3])] - mesh.points[at(keep)];
                        angle += std::atan2(norm(cross(a, b)), dot(a, b));
                    }
                }
            }
            mesh.rim[at(keep)].angle = std::min(angle, 2 * pi);
            pole[at(keep)] = 1;
            pole[at(gone)] = 1;
        }
    }
}

} // namespace

std::optional<FaceTriangles> triangulate_face(const FaceSurface &surface,
                                              const std::vector<BoundaryLoop> &boundary,
                                              const std::vector<BoundaryLoop> &inner,
                                              const Spacing &spacing, Refusal &refusal) {
    FaceTriangles result;
    std::vector<std::vector<std::int32_t>> numbers;
    std::vector<BoundaryLoop> lines = boundary;
    lines.insert(lines.end(), inner.begin(), inner.end());
    result.nodes = face_mesh_of(surface, lines, numbers);
    FaceMesh &mesh = result.nodes;

    std::vector<Segment> segments;
    std::vector<Segment> bounds; // in the surface's own sense
    std::vector<Pair> pieces;
    for (std::size_t l = 0; l < lines.size(); ++l) {
        const std::size_t count = lines[l].size();
        const bool is_inner = l >= boundary.size();
        for (std::size_t i = 0; i + (is_inner ? 1 : 0) < count; ++i) {
            const std::int32_t a = numbers[l][i];
            const std::int32_t b = numbers[l][(i + 1) % count];
            if (a == b) {
                continue;
            }
            segments.push_back({a, b, !is_inner});
            if (!is_inner) {
                bounds.push_back({a, b, true});
            }
            if (!lines[l][i].pole) {
                pieces.push_back({a, b});
            }
            if (is_inner) {
                result.kept.insert(ascending(a, b));
            }
        }
        if (is_inner) {
            for (const std::int32_t n : numbers[l]) {
                // Inside the face the tangents of the boundary do not apply.
                auto &rim = mesh.rim[at(n)];
                if (rim.angle == pi || rim.angle == 0) {
                    rim.angle = 2 * pi;
                }
            }
        }
    }
    // An edge that the face has on both sides is no end of the domain.
    std::map<Pair, int> uses;
    for (const Segment &s : segments) {
        ++uses[ascending(s.a, s.b)];
    }
    for (const auto &[ends, count] : uses) {
        if (count > 1) {
            result.kept.insert(ends);
        }
    }
    // Parameters scaled so that they are near to lengths.
    Uv scale{0, 0};
    constexpr int samples = 5;
    for (int i = 0; i < samples; ++i) {
        for (int j = 0; j < samples; ++j) {
            const Uv span = surface.high() - surface.low();
            const auto d = surface.derivatives(
                surface.low() + Uv{(i + 0.5) / samples * span.u, (j + 0.5) / samples * span.v});
            scale.u += norm(d[1]) / (samples * samples);
            scale.v += norm(d[2]) / (samples * samples);
        }
    }
    scale.u = scale.u > 0 && std::isfinite(scale.u) ? scale.u : 1;
    scale.v = scale.v > 0 && std::isfinite(scale.v) ? scale.v : 1;
    const double mirror = surface.reversed() ? -1 : 1;
    const auto plane_of = [&](Uv p) {
        return Point2{mirror * scale.u * (p.u - surface.low().u),
                      scale.v * (p.v - surface.low().v)};
    };

    Placer placer{surface, mesh, pieces, spacing, bounds, {}, {}, {}, {}};
    for (const Pair &s : pieces) {
        const double length = distance(mesh.points[at(s[0])], mesh.points[at(s[1])]);
        for (const double t : {0.0, 0.5, 1.0}) {
            placer.sources.push_back(mesh.points[at(s[0])] +
                                     t * (mesh.points[at(s[1])] - mesh.points[at(s[0])]));
            placer.asked.push_back(length);
        }
    }
    for (const Uv p : points_in_tips(mesh)) {
        if (placer.inside(p)) {
            placer.accepted.push_back(p);
            placer.places.push_back(surface.at(p));
        }
    }
    placer.divide(surface.low(), surface.high(), 0);
    for (const Uv p : placer.accepted) {
        mesh.add(surface, p);
    }
    std::vector<Point2> plane;
    for (const Uv p : mesh.uv) {
        plane.push_back(plane_of(p));
    }
    const auto triangles = constrained_delaunay(plane, segments);
    if (!triangles) {
        refusal = {"the boundary crosses or touches itself", {}};
        return std::nullopt;
    }
    result.triangles = *triangles;
    std::vector<char> pole(mesh.points.size(), 0);
    join_poles(boundary, numbers, result, pole);
    Flipper flipper{result, plane, pole, {}};
    constexpr int passes = 20;
    for (int i = 0; i < passes && flipper.pass(); ++i) {
    }
    return result;
}

} // namespace nmgs::cad
