// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cad_tets.h"

#include "nmgs/quality/tet_improvement.h"
#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/occt_vec.h"

#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <cmath>
#include <set>

namespace nmgs::cad {
namespace {

template <std::size_t n>
bool has(const std::array<std::int32_t, n> &list, std::int32_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

} // namespace

std::vector<int> inner_vertices(const CadShape &shape, int solid) {
    std::set<int> faces;
    for (TopExp_Explorer f(shape.solid(solid), TopAbs_FACE); f.More(); f.Next()) {
        for (TopExp_Explorer v(f.Current(), TopAbs_VERTEX); v.More(); v.Next()) {
            faces.insert(shape.vertices.FindIndex(v.Current()));
        }
    }
    std::set<int> result;
    for (TopExp_Explorer v(shape.solid(solid), TopAbs_VERTEX, TopAbs_FACE); v.More(); v.Next()) {
        const int n = shape.vertices.FindIndex(v.Current());
        if (!faces.contains(n)) {
            result.insert(n);
        }
    }
    return {result.begin(), result.end()};
}

CadTets::CadTets(const CadShape &shape, const Skin &skin, std::span<const SolidTets> solids)
    : points(skin.points), on(skin.on), shape_(shape), faces_(at(shape.faces.Extent()) + 1),
      curves_(at(shape.edges.Extent()) + 1) {
    const auto shared = static_cast<std::int32_t>(skin.points.size());
    for (const SolidTets &solid : solids) {
        const auto shift = static_cast<std::int32_t>(points.size()) - shared;
        const auto vertices = inner_vertices(shape, solid.solid);
        for (const Vec3 p : solid.inner) {
            points.push_back(p);
            on.push_back({3, solid.solid});
            for (const int v : vertices) {
                if (p == shape.point(v)) {
                    on.back() = {0, v};
                }
            }
        }
        for (auto t : solid.tets) {
            for (std::int32_t &n : t) {
                n = n < shared ? n : n + shift;
            }
            tets.push_back({t, solid.solid});
        }
    }
    for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
        triangles.push_back({skin.triangles[t], skin.uv[t], skin.faces[t]});
    }
    chains.resize(skin.edges.size());
    for (std::size_t e = 0; e < skin.edges.size(); ++e) {
        chains[e] = {skin.edges[e], skin.parameters[e]};
        for (std::size_t k = 0; k + 1 < skin.edges[e].size(); ++k) {
            segments_[ascending(skin.edges[e][k], skin.edges[e][k + 1])] =
                static_cast<std::int32_t>(e);
        }
    }
    link();
}

void CadTets::link() {
    tets_of_.assign(points.size(), {});
    triangles_of_.assign(points.size(), {});
    for (std::size_t t = 0; t < tets.size(); ++t) {
        for (const std::int32_t n : tets[t].p) {
            tets_of_[at(n)].push_back(static_cast<std::int32_t>(t));
        }
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const std::int32_t n : triangles[t].p) {
            triangles_of_[at(n)].push_back(static_cast<std::int32_t>(t));
        }
    }
}

const FaceGeometry &CadTets::face(int n) {
    auto &geometry = faces_[at(n)];
    if (!geometry) {
        geometry = std::make_unique<FaceGeometry>(shape_.face(n));
    }
    return *geometry;
}

const BRepAdaptor_Curve &CadTets::curve(int n) {
    auto &geometry = curves_[at(n)];
    if (!geometry) {
        geometry = std::make_unique<BRepAdaptor_Curve>(shape_.edge(n));
    }
    return *geometry;
}

std::int32_t CadTets::segment(std::int32_t a, std::int32_t b) const {
    const auto found = segments_.find(ascending(a, b));
    return found == segments_.end() ? 0 : found->second;
}

std::int32_t CadTets::triangle(std::int32_t a, std::int32_t b, std::int32_t c) const {
    for (const std::int32_t t : triangles_of_[at(a)]) {
        if (has(triangles[at(t)].p, b) && has(triangles[at(t)].p, c)) {
            return t;
        }
    }
    return -1;
}

CadTets::Middle CadTets::middle(std::int32_t a, std::int32_t b) {
    if (on[at(a)].dimension == 3 || on[at(b)].dimension == 3) {
        return {0.5 * (points[at(a)] + points[at(b)]), {3, 0}, 0, {}};
    }
    const auto known = middles_.find(ascending(a, b));
    if (known != middles_.end()) {
        return known->second;
    }
    const Middle found = find_middle(a, b);
    if (found.on.dimension < 3) {
        middles_.emplace(ascending(a, b), found);
    }
    return found;
}

CadTets::Middle CadTets::find_middle(std::int32_t a, std::int32_t b) {
    const Vec3 straight = 0.5 * (points[at(a)] + points[at(b)]);
    const std::int32_t edge = segment(a, b);
    if (edge != 0) {
        const Chain &chain = chains[at(edge)];
        std::size_t k = 0;
        while (ascending(chain.points[k], chain.points[k + 1]) != ascending(a, b)) {
            ++k;
        }
        const double low = chain.parameters[k];
        const double high = chain.parameters[k + 1];
        double t = 0.5 * (low + high);
        const BRepAdaptor_Curve &c = curve(edge);
        if (c.GetType() != GeomAbs_Line && c.GetType() != GeomAbs_Circle) {
            const double length = GCPnts_AbscissaPoint::Length(c, low, high);
            const GCPnts_AbscissaPoint half(c, 0.5 * length, low);
            if (half.IsDone() && half.Parameter() > low && half.Parameter() < high) {
                t = half.Parameter();
            }
        }
        return {vec(c.Value(t).XYZ()), {1, edge}, t, {}};
    }
    for (const std::int32_t t : triangles_of_[at(a)]) {
        const Triangle &triangle = triangles[at(t)];
        if (!has(triangle.p, b)) {
            continue;
        }
        const FaceGeometry &geometry = face(triangle.face);
        Middle best{straight, {2, triangle.face}, 0, {}};
        double nearest = -1;
        for (std::size_t i = 0; i < 3; ++i) {
            if (triangle.p[i] == a || triangle.p[i] == b) {
                const Uv uv = geometry.nearest(straight, triangle.uv[i]);
                const Vec3 p = geometry.at(uv);
                if (nearest < 0 || distance(p, straight) < nearest) {
                    nearest = distance(p, straight);
                    best.p = p;
                    best.uv = uv;
                }
                if (geometry.elementary() ||
                    nearest < 0.2 * distance(points[at(a)], points[at(b)])) {
                    break;
                }
            }
        }
        return best;
    }
    return {straight, {3, 0}, 0, {}};
}

CadTets::Middle CadTets::centre(const std::array<std::int32_t, 3> &c,
                                const std::array<Vec3, 3> &middles, int solid) {
    // The quadratic triangle's middle.
    const Vec3 p = (4.0 / 9) * (middles[0] + middles[1] + middles[2]) -
                   (1.0 / 9) * (points[at(c[0])] + points[at(c[1])] + points[at(c[2])]);
    const std::int32_t t = triangle(c[0], c[1], c[2]);
    if (t < 0) {
        return {p, {3, solid}, 0, {}};
    }
    auto key = c;
    std::sort(key.begin(), key.end());
    const auto known = centres_.find(key);
    if (known != centres_.end()) {
        return known->second;
    }
    const double size = distance(points[at(c[0])], points[at(c[1])]);
    return centres_.emplace(key, find_centre(triangles[at(t)], p, size)).first->second;
}

CadTets::Middle CadTets::find_centre(const Triangle &triangle, Vec3 p, double size) {
    const FaceGeometry &geometry = face(triangle.face);
    Middle best{p, {2, triangle.face}, 0, {}};
    double nearest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const Uv uv = geometry.nearest(p, triangle.uv[i]);
        const Vec3 q = geometry.at(uv);
        if (nearest < 0 || distance(q, p) < nearest) {
            nearest = distance(q, p);
            best.p = q;
            best.uv = uv;
        }
        if (geometry.elementary() || nearest < 0.2 * size) {
            break;
        }
    }
    return best;
}

double CadTets::improve(const Progress &progress) {
    TetMesh mesh;
    mesh.points = points;
    for (const CadEntity &entity : on) {
        mesh.fixed.push_back(entity.dimension < 3 ? 1 : 0);
    }
    for (const Tet &t : tets) {
        mesh.tets.push_back({t.p, t.solid});
    }
    for (const Triangle &t : triangles) {
        std::array<Vec3, 3> m{};
        for (std::size_t i = 0; i < 3; ++i) {
            m[i] = middle(t.p[i], t.p[(i + 1) % 3]).p;
            mesh.middles[ascending(t.p[i], t.p[(i + 1) % 3])] = m[i];
        }
        auto key = t.p;
        std::sort(key.begin(), key.end());
        mesh.centres[key] = centre(t.p, m, 0).p;
    }
    for (const auto &[ends, edge] : segments_) {
        mesh.middles[ends] = middle(ends[0], ends[1]).p;
    }
    const double worst = improve_tets(mesh, {}, progress);
    points = std::move(mesh.points);
    on.resize(points.size());
    tets.clear();
    for (const auto &t : mesh.tets) {
        tets.push_back({t.p, t.part});
        for (const std::int32_t n : t.p) {
            if (mesh.fixed[at(n)] == 0) {
                on[at(n)] = {3, t.part};
            }
        }
    }
    link();
    return worst;
}

std::vector<Vec3> inner_vertex_places(const CadShape &shape, int solid) {
    std::vector<Vec3> places;
    for (const int v : inner_vertices(shape, solid)) {
        places.push_back(shape.point(v));
    }
    return places;
}

} // namespace nmgs::cad
