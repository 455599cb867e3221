// SPDX-License-Identifier: LGPL-2.1-or-later
// Splitting tetrahedra that would fold on a curved skin.
#include "nmgs_cad/cad_tets.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/occt_vec.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace nmgs::cad {
namespace {

template <std::size_t n>
bool has(const std::array<std::int32_t, n> &list, std::int32_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

constexpr double smooth_cosine = 0.64;    // of the angle between normals: 50 degrees
constexpr double straight_cosine = -0.76; // of the angle between edges: 140 degrees
constexpr double grazing_sine = 0.2;      // of the angle between an edge and the skin

} // namespace

std::int32_t CadTets::split(std::int32_t a, std::int32_t b) {
    const Middle m = middle(a, b);
    const auto n = static_cast<std::int32_t>(points.size());
    std::vector<std::int32_t> touched;
    for (const std::int32_t t : tets_of_[at(a)]) {
        if (has(tets[at(t)].p, b)) {
            touched.push_back(t);
        }
    }
    if (touched.empty()) {
        return -1;
    }
    points.push_back(m.p);
    on.push_back(m.on.dimension == 3 ? CadEntity{3, tets[at(touched[0])].solid} : m.on);
    tets_of_.emplace_back();
    triangles_of_.emplace_back();
    for (const std::int32_t t : touched) {
        Tet second = tets[at(t)];
        std::replace(second.p.begin(), second.p.end(), a, n);
        std::replace(tets[at(t)].p.begin(), tets[at(t)].p.end(), b, n);
        std::erase(tets_of_[at(b)], t);
        tets_of_[at(n)].push_back(t);
        for (const std::int32_t p : second.p) {
            tets_of_[at(p)].push_back(static_cast<std::int32_t>(tets.size()));
        }
        tets.push_back(second);
    }
    std::vector<std::int32_t> covered;
    for (const std::int32_t t : triangles_of_[at(a)]) {
        if (has(triangles[at(t)].p, b)) {
            covered.push_back(t);
        }
    }
    for (const std::int32_t t : covered) {
        Triangle second = triangles[at(t)];
        const Uv uv = face(second.face).nearest(m.p, second.uv[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            if (second.p[i] == a) {
                second.p[i] = n;
                second.uv[i] = uv;
            }
            if (triangles[at(t)].p[i] == b) {
                triangles[at(t)].p[i] = n;
                triangles[at(t)].uv[i] = uv;
            }
        }
        std::erase(triangles_of_[at(b)], t);
        triangles_of_[at(n)].push_back(t);
        for (const std::int32_t p : second.p) {
            triangles_of_[at(p)].push_back(static_cast<std::int32_t>(triangles.size()));
        }
        triangles.push_back(second);
    }
    if (m.on.dimension == 1) {
        Chain &chain = chains[at(m.on.index)];
        std::size_t k = 0;
        while (ascending(chain.points[k], chain.points[k + 1]) != ascending(a, b)) {
            ++k;
        }
        const auto where = static_cast<std::ptrdiff_t>(k) + 1;
        chain.points.insert(chain.points.begin() + where, n);
        chain.parameters.insert(chain.parameters.begin() + where, m.t);
        segments_.erase(ascending(a, b));
        segments_[ascending(a, n)] = m.on.index;
        segments_[ascending(n, b)] = m.on.index;
    }
    return n;
}

void CadTets::split_inside(std::size_t tet) {
    const Tet old = tets[tet];
    const auto n = static_cast<std::int32_t>(points.size());
    Vec3 middle{0, 0, 0};
    for (const std::int32_t p : old.p) {
        middle += 0.25 * points[at(p)];
    }
    points.push_back(middle);
    on.push_back({3, old.solid});
    tets_of_.emplace_back();
    triangles_of_.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
        Tet part = old;
        part.p[i] = n;
        if (i == 0) {
            std::erase(tets_of_[at(old.p[0])], static_cast<std::int32_t>(tet));
            tets[tet] = part;
            tets_of_[at(n)].push_back(static_cast<std::int32_t>(tet));
        } else {
            for (const std::int32_t p : part.p) {
                tets_of_[at(p)].push_back(static_cast<std::int32_t>(tets.size()));
            }
            tets.push_back(part);
        }
    }
}

Vec3 CadTets::direction(std::int32_t from, std::int32_t to, std::int32_t edge) {
    const Chain &chain = chains[at(edge)];
    std::size_t k = 0;
    while (ascending(chain.points[k], chain.points[k + 1]) != ascending(from, to)) {
        ++k;
    }
    const bool forward = chain.points[k] == from;
    gp_Pnt p;
    gp_Vec d;
    curve(edge).D1(chain.parameters[forward ? k : k + 1], p, d);
    const double l = d.Magnitude();
    return l > 0 ? ((forward ? 1 : -1) / l) * vec(d.XYZ()) : Vec3{0, 0, 0};
}

void CadTets::split_grazing() {
    // Normals of the curved faces at each point of the skin.
    std::vector<std::vector<Vec3>> normals(points.size());
    for (const Triangle &t : triangles) {
        for (std::size_t i = 0; i < 3 && !face(t.face).planar(); ++i) {
            auto &list = normals[at(t.p[i])];
            const bool alone = on[at(t.p[i])].dimension == 2;
            if (alone && !list.empty()) {
                continue;
            }
            const SurfaceFrame frame = face(t.face).frame(t.uv[i]);
            const auto same = [&](Vec3 n) { return dot(n, frame.normal) > 0.99; };
            if (frame.regular && std::none_of(list.begin(), list.end(), same)) {
                list.push_back(frame.normal);
            }
        }
    }
    std::set<std::array<std::int32_t, 2>> wanted;
    for (const Tet &t : tets) {
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                const std::int32_t a = t.p[i];
                const std::int32_t b = t.p[j];
                if (on[at(a)].dimension == 3 || on[at(b)].dimension == 3) {
                    continue;
                }
                const auto &here = triangles_of_[at(a)];
                if (std::any_of(here.begin(), here.end(),
                                [&](std::int32_t s) { return has(triangles[at(s)].p, b); })) {
                    continue;
                }
                const Vec3 d = points[at(b)] - points[at(a)];
                const double limit = grazing_sine * norm(d);
                const auto grazes = [&](Vec3 n) { return std::abs(dot(n, d)) < limit; };
                for (const std::int32_t end : {a, b}) {
                    const auto &list = normals[at(end)];
                    if (std::any_of(list.begin(), list.end(), grazes)) {
                        wanted.insert(ascending(a, b));
                    }
                }
            }
        }
    }
    for (const auto &e : wanted) {
        split(e[0], e[1]);
    }
}

void CadTets::split_folding(int rounds) {
    for (int round = 0; round < rounds; ++round) {
        std::set<std::array<std::int32_t, 2>> wanted;
        std::vector<std::size_t> inside;
        const std::size_t count = tets.size();
        for (std::size_t t = 0; t < count; ++t) {
            const auto p = tets[t].p;
            std::array<std::int32_t, 4> skin{};
            for (std::size_t i = 0; i < 4; ++i) {
                skin[i] = triangle(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]);
            }
            std::set<std::array<std::int32_t, 2>> mine;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = i + 1; j < 4; ++j) {
                    if (skin[i] < 0 || skin[j] < 0) {
                        continue;
                    }
                    // Faces i and j meet at the edge of the other two corners.
                    std::array<std::int32_t, 2> hinge{};
                    std::size_t k = 0;
                    for (std::size_t m = 0; m < 4; ++m) {
                        if (m != i && m != j) {
                            hinge[k++] = p[m];
                        }
                    }
                    const auto normal = [&](std::size_t apex) {
                        const Vec3 a = points[at(hinge[0])];
                        const Vec3 n = cross(points[at(hinge[1])] - a, points[at(p[apex])] - a);
                        const double l = norm(n);
                        return l > 0 ? (1 / l) * n : n;
                    };
                    const bool folds = segment(hinge[0], hinge[1]) == 0 ||
                                       -dot(normal(i), normal(j)) > smooth_cosine;
                    if (folds) {
                        mine.insert(ascending(p[i], p[j]));
                    }
                }
            }
            for (std::size_t v = 0; v < 4; ++v) {
                for (std::size_t i = 0; i < 4; ++i) {
                    for (std::size_t j = i + 1; j < 4; ++j) {
                        if (i == v || j == v) {
                            continue;
                        }
                        const std::int32_t e = segment(p[v], p[i]);
                        const std::int32_t f = segment(p[v], p[j]);
                        if (e != 0 && f != 0 &&
                            dot(direction(p[v], p[i], e), direction(p[v], p[j], f)) <
                                straight_cosine) {
                            mine.insert(ascending(p[i], p[j]));
                        }
                    }
                }
            }
            if (mine.empty()) {
                continue;
            }
            bool on_skin = mine.size() > 1;
            for (const auto &e : mine) {
                on_skin = on_skin || segment(e[0], e[1]) != 0;
                for (const std::int32_t s : triangles_of_[at(e[0])]) {
                    on_skin = on_skin || has(triangles[at(s)].p, e[1]);
                }
            }
            if (on_skin) {
                inside.push_back(t);
            } else {
                wanted.insert(mine.begin(), mine.end());
            }
        }
        if (wanted.empty() && inside.empty()) {
            break;
        }
        // A point inside parts all four faces; an edge that is split then is one of this
        // tetrahedron's neighbours as well.
        for (const std::size_t t : inside) {
            split_inside(t);
        }
        for (const auto &e : wanted) {
            split(e[0], e[1]);
        }
    }
}

} // namespace nmgs::cad
