// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/tets_to_hexas.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/cad_tets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace nmgs::cad {
namespace {

// For each corner of a tetrahedron the three others, right-handed.
constexpr std::array<std::array<std::size_t, 3>, 4> others{
    {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}}};
// For each corner of a hexahedron its three neighbours, right-handed.
constexpr std::array<std::array<std::size_t, 3>, 8> next{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

constexpr double doubtful = 0.15; // at the corners

// The hexahedra while their inner points move.
struct Cells {
    std::vector<Vec3> points;
    std::vector<char> free;
    std::vector<std::array<std::int32_t, 8>> hexas;
    std::vector<std::vector<std::int32_t>> around;
    // Of each hexahedron: its place in ends, or -1. By 3 * corner + direction the far end of the
    // tetrahedron's edge, of which this is a half, where the CAD bends it; else -1.
    std::vector<std::int32_t> bent;
    std::vector<std::array<std::int32_t, 24>> ends;
    // Points in faces that may move along them, and how.
    std::map<std::int32_t, std::pair<int, Uv>> sliding;
    std::function<Vec3(int face, Uv guess, Vec3 p)> onto;

    static double scaled(Vec3 u, Vec3 v, Vec3 w) {
        const double l = norm(u) * norm(v) * norm(w);
        return l > 0 ? determinant(u, v, w) / l : -1;
    }
    [[nodiscard]] double worst(std::int32_t number) const {
        const auto &h = hexas[at(number)];
        double least = 1;
        for (std::size_t c = 0; c < 8; ++c) {
            const Vec3 o = points[at(h[c])];
            std::array<Vec3, 3> d{};
            for (std::size_t i = 0; i < 3; ++i) {
                d[i] = points[at(h[next[c][i]])] - o;
            }
            least = std::min(least, scaled(d[0], d[1], d[2]));
            if (bent[at(number)] >= 0) {
                const auto &own = ends[at(bent[at(number)])];
                bool any = false;
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::int32_t far = own[3 * c + i];
                    if (far >= 0) {
                        // The tangent of the quadratic at its end, and in its middle.
                        d[i] = c == 0 ? 4.0 * points[at(h[next[0][i]])] - 3.0 * o - points[at(far)]
                                      : points[at(h[0])] - points[at(far)];
                        any = true;
                    }
                }
                least = any ? std::min(least, scaled(d[0], d[1], d[2])) : least;
            }
        }
        return least < doubtful ? std::min(least, worst_inside(h)) : least;
    }
    // Of what has sound corners the inside may still fold: least at the middles of the edges and
    // faces and in the centre.
    [[nodiscard]] double worst_inside(const std::array<std::int32_t, 8> &h) const {
        const auto edge = [&](std::size_t a, std::size_t b) {
            return points[at(h[b])] - points[at(h[a])];
        };
        const std::array<std::array<Vec3, 4>, 3> d{
            {{edge(0, 1), edge(3, 2), edge(4, 5), edge(7, 6)},
             {edge(0, 3), edge(1, 2), edge(4, 7), edge(5, 6)},
             {edge(0, 4), edge(1, 5), edge(3, 7), edge(2, 6)}}};
        // Between the four parallel edges, at fractions 0, 1/2, 1 along the two other directions.
        const auto between = [](const std::array<Vec3, 4> &four, int i, int j) {
            const double x = 0.5 * i;
            const double y = 0.5 * j;
            return (1 - x) * (1 - y) * four[0] + x * (1 - y) * four[1] + (1 - x) * y * four[2] +
                   x * y * four[3];
        };
        double least = 1;
        for (int k = 0; k < 3; ++k) {
            for (int j = 0; j < 3; ++j) {
                for (int i = 0; i < 3; ++i) {
                    if (i == 1 || j == 1 || k == 1) {
                        least = std::min(least, scaled(between(d[0], j, k), between(d[1], i, k),
                                                       between(d[2], i, j)));
                    }
                }
            }
        }
        return least;
    }
    [[nodiscard]] double worst_around(std::int32_t n) const {
        double least = 1;
        for (const std::int32_t h : around[at(n)]) {
            least = std::min(least, worst(h));
        }
        return least;
    }
    void move(std::int32_t n, double &worst);
    double improve(double good, int sweeps, const Progress &progress);
};

void Cells::move(std::int32_t n, double &worst) {
    double size = 0;
    for (const std::int32_t h : around[at(n)]) {
        size += distance(points[at(hexas[at(h)][0])], points[at(hexas[at(h)][6])]);
    }
    double step = 0.1 * size / static_cast<double>(around[at(n)].size());
    Vec3 last{0, 0, 0};
    const auto slide = sliding.find(n);
    const auto attempt = [&](Vec3 d) {
        const Vec3 old = points[at(n)];
        points[at(n)] = slide == sliding.end()
                            ? old + d
                            : onto(slide->second.first, slide->second.second, old + d);
        const double now = worst_around(n);
        if (now > worst + 1e-9) {
            worst = now;
            last = d;
            return true;
        }
        points[at(n)] = old;
        return false;
    };
    for (int round = 0; round < 7; ++round) {
        bool better = norm2(last) > 0 && attempt(last);
        for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0},
                             Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
            better = attempt(step * d) || better;
        }
        step *= better ? 1.2 : 0.5;
    }
}

constexpr double poor = 0.04; // what also points on faces move for
// So many points may be moved in all, and so many of these along faces, which take longest.
constexpr int most_moves = 30'000;
constexpr int most_slides = 1000;

// Moves the free points of the worst hexahedra; the worst value left.
double Cells::improve(double good, int sweeps, const Progress &progress) {
    double least = 1;
    int moves = 0;
    int slides = 0;
    for (int sweep = 0; sweep <= sweeps; ++sweep) {
        poll(progress, 0.5 + 0.5 * sweep / (sweeps + 1));
        std::vector<std::pair<double, std::int32_t>> bad;
        least = 1;
        for (std::size_t h = 0; h < hexas.size(); ++h) {
            const double q = worst(static_cast<std::int32_t>(h));
            least = std::min(least, q);
            if (q < good) {
                bad.emplace_back(q, static_cast<std::int32_t>(h));
            }
        }
        if (bad.empty() || sweep == sweeps || moves >= most_moves) {
            break;
        }
        std::sort(bad.begin(), bad.end());
        std::vector<char> seen(points.size(), 0);
        for (const auto &[q, h] : bad) {
            for (const std::int32_t n : hexas[at(h)]) {
                const bool slide =
                    q < poor && 2 * sweep >= sweeps && slides < most_slides && sliding.contains(n);
                if ((free[at(n)] != 0 || slide) && seen[at(n)] == 0 && moves < most_moves) {
                    seen[at(n)] = 1;
                    ++moves;
                    slides += slide ? 1 : 0;
                    if (moves % 64 == 0) {
                        poll(progress, 0.5 + 0.5 * sweep / (sweeps + 1));
                    }
                    double now = worst_around(n);
                    move(n, now);
                }
            }
        }
    }
    return least;
}

} // namespace

TetHexas tets_to_hexas(const CadShape &shape, const Skin &skin, std::span<const SolidTets> solids,
                       Layout &layout, const Progress &progress) {
    CadTets mesh(shape, skin, solids);
    mesh.split_grazing();
    mesh.split_folding(4);
    poll(progress, 0.1);
    mesh.smooth(6);
    poll(progress, 0.2);

    Cells cells;
    cells.onto = [&](int face, Uv guess, Vec3 p) {
        return mesh.face(face).at(mesh.face(face).nearest(p, guess));
    };
    // Points of the layout: corners, middles of edges, of faces, of tetrahedra.
    const auto first = static_cast<std::int32_t>(layout.points.size());
    std::vector<std::int32_t> number(mesh.points.size(), -1);
    const auto corner = [&](std::int32_t n) {
        if (number[at(n)] < 0) {
            number[at(n)] = mesh.on[at(n)].dimension == 0
                                ? layout.vertex(shape, mesh.on[at(n)].index)
                                : layout.add_point(mesh.points[at(n)], mesh.on[at(n)]);
        }
        return number[at(n)];
    };
    std::map<std::array<std::int32_t, 2>, std::int32_t> of_edge;
    std::map<std::array<std::int32_t, 3>, std::int32_t> of_face;
    const auto middle = [&](std::int32_t a, std::int32_t b, int solid) {
        const auto [known, fresh] = of_edge.try_emplace(ascending(a, b), 0);
        if (fresh) {
            auto m = mesh.middle(a, b);
            if (m.on.dimension == 3) {
                m.on.index = solid;
            }
            known->second = layout.add_point(m.p, m.on);
            if (m.on.dimension == 2) {
                cells.sliding[known->second] = {m.on.index, m.uv};
            }
        }
        return known->second;
    };
    const auto centre = [&](std::array<std::int32_t, 3> c, int solid) {
        auto key = c;
        std::sort(key.begin(), key.end());
        const auto [known, fresh] = of_face.try_emplace(key, 0);
        if (fresh) {
            const std::array<Vec3, 3> m{layout.points[at(middle(c[0], c[1], solid))],
                                        layout.points[at(middle(c[1], c[2], solid))],
                                        layout.points[at(middle(c[2], c[0], solid))]};
            const auto f = mesh.centre(c, m, solid);
            known->second = layout.add_point(f.p, f.on);
            if (f.on.dimension == 2) {
                cells.sliding[known->second] = {f.on.index, f.uv};
            }
        }
        return known->second;
    };
    const std::size_t first_hexa = layout.hexas.size();
    std::vector<std::int32_t> tet_of;
    // The hexahedra of a solid follow each other.
    std::vector<std::size_t> order(mesh.tets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return mesh.tets[a].solid < mesh.tets[b].solid;
    });
    for (const std::size_t t : order) {
        const auto &[p, solid] = mesh.tets[t];
        Vec3 c{0, 0, 0};
        for (std::size_t i = 0; i < 4; ++i) {
            c += -0.125 * mesh.points[at(p[i])];
            for (std::size_t j = i + 1; j < 4; ++j) {
                c += 0.25 * layout.points[at(middle(p[i], p[j], solid))];
            }
        }
        const std::int32_t inside = layout.add_point(c, {3, solid});
        for (std::size_t v = 0; v < 4; ++v) {
            const std::int32_t o = p[v];
            const std::int32_t i = p[others[v][0]];
            const std::int32_t j = p[others[v][1]];
            const std::int32_t k = p[others[v][2]];
            layout.hexas.push_back(
                {{corner(o), middle(o, i, solid), centre({o, i, j}, solid), middle(o, j, solid),
                  middle(o, k, solid), centre({o, i, k}, solid), inside, centre({o, j, k}, solid)},
                 solid});
            tet_of.push_back(static_cast<std::int32_t>(t));
        }
        if (t % 256 == 0) {
            poll(progress,
                 0.2 + 0.3 * static_cast<double>(t) / static_cast<double>(mesh.tets.size()));
        }
    }
    for (const auto &t : mesh.triangles) {
        const std::int32_t inside = centre(t.p, 0);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t o = t.p[i];
            layout.quads.push_back({{corner(o), middle(o, t.p[(i + 1) % 3], 0), inside,
                                     middle(o, t.p[(i + 2) % 3], 0)},
                                    t.face});
        }
    }
    for (std::size_t e = 1; e < mesh.chains.size(); ++e) {
        const auto &chain = mesh.chains[e].points;
        if (chain.empty() || !layout.edges[e].empty()) {
            continue;
        }
        auto &list = layout.edges[e];
        list.push_back(corner(chain[0]));
        for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
            list.push_back(middle(chain[k], chain[k + 1], 0));
            list.push_back(corner(chain[k + 1]));
        }
    }

    cells.points = layout.points;
    cells.free.assign(layout.points.size(), 0);
    for (std::size_t n = at(first); n < layout.points.size(); ++n) {
        cells.free[n] = layout.on[n].dimension == 3 ? 1 : 0;
    }
    cells.around.resize(layout.points.size());
    for (std::size_t h = first_hexa; h < layout.hexas.size(); ++h) {
        for (const std::int32_t n : layout.hexas[h].points) {
            cells.around[at(n)].push_back(static_cast<std::int32_t>(cells.hexas.size()));
        }
        cells.hexas.push_back(layout.hexas[h].points);
    }
    // Edges on the skin, as quadratics through the layout's three points.
    cells.bent.assign(cells.hexas.size(), -1);
    for (std::size_t h = 0; h < cells.hexas.size(); ++h) {
        const auto &p = mesh.tets[at(tet_of[h])].p;
        const std::size_t v = h % 4;
        const Vec3 o = mesh.points[at(p[v])];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t m = middle(p[v], p[others[v][i]], 0);
            const Vec3 b = mesh.points[at(p[others[v][i]])];
            const Vec3 middle_point = cells.points[at(m)];
            if (layout.on[at(m)].dimension == 3 ||
                norm(middle_point - 0.5 * (o + b)) < 1e-4 * norm(b - o)) {
                continue;
            }
            if (cells.bent[h] < 0) {
                cells.bent[h] = static_cast<std::int32_t>(cells.ends.size());
                cells.ends.emplace_back();
                cells.ends.back().fill(-1);
            }
            auto &own = cells.ends.back();
            // The hexahedron's corners beside its first are 1, 3 and 4.
            const std::size_t there = next[0][i];
            own[i] = corner(p[others[v][i]]);
            for (std::size_t k = 0; k < 3; ++k) {
                if (next[there][k] == 0) {
                    own[3 * there + k] = own[i];
                }
            }
        }
    }
    constexpr double good = 0.12;
    constexpr int sweeps = 10;
    TetHexas result;
    result.worst = cells.improve(good, sweeps, progress);
    layout.points = cells.points;

    // A finer skin helps where the CAD bends a tetrahedron, and a flat one anywhere is still sound.
    constexpr double folded = 0.03;
    constexpr double flat = 1e-5;
    constexpr double bent = 1e-3;
    std::int32_t last = -1;
    for (std::size_t h = 0; h < cells.hexas.size(); ++h) {
        const double quality = cells.worst(static_cast<std::int32_t>(h));
        if (quality > folded || tet_of[h] == last) {
            continue;
        }
        const auto &p = mesh.tets[at(tet_of[h])].p;
        Vec3 place{0, 0, 0};
        double longest = 0;
        double bend = 0;
        bool skin_near = false;
        for (std::size_t i = 0; i < 4; ++i) {
            place += 0.25 * mesh.points[at(p[i])];
            skin_near = skin_near || mesh.on[at(p[i])].dimension < 3;
            for (std::size_t j = i + 1; j < 4; ++j) {
                const Vec3 a = mesh.points[at(p[i])];
                const Vec3 b = mesh.points[at(p[j])];
                const Vec3 m = layout.points[at(middle(p[i], p[j], 0))];
                longest = std::max(longest, distance(a, b));
                if (layout.on[at(middle(p[i], p[j], 0))].dimension < 3) {
                    bend = std::max(bend, distance(m, 0.5 * (a + b)) / distance(a, b));
                }
            }
        }
        if (skin_near && (bend > bent || quality <= flat)) {
            last = tet_of[h];
            result.folded.push_back({place, longest, 0.5 * longest});
        }
    }
    return result;
}

} // namespace nmgs::cad
