// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/tets_to_hexas.h"

#include "nmgs/quality/volume_metrics.h"
#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/cad_tets.h"
#include "nmgs_cad/untangle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace nmgs::cad {
namespace {

// For each corner of a tetrahedron the three others, right-handed.
constexpr std::array<std::array<std::size_t, 3>, 4> others{
    {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}}};
// Listens to a part of the work.
Progress part_of(const Progress &progress, double from, double to) {
    return progress ? Progress([&progress, from, to](double f) {
        return progress(from + f * (to - from));
    })
                    : Progress();
}

double scaled(Vec3 u, Vec3 v, Vec3 w) {
    const double l = norm(u) * norm(v) * norm(w);
    return l > 0 ? determinant(u, v, w) / l : -1;
}

// Of what has sound corners the inside may still fold: least at the middles of the edges and faces
// and in the centre.
double worst_inside(const std::array<Vec3, 8> &p) {
    const auto edge = [&](std::size_t a, std::size_t b) { return p[b] - p[a]; };
    const std::array<std::array<Vec3, 4>, 3> d{{{edge(0, 1), edge(3, 2), edge(4, 5), edge(7, 6)},
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

std::array<Vec3, 8> places(const Layout &layout, const Layout::Hexa &hexa) {
    std::array<Vec3, 8> p{};
    for (std::size_t i = 0; i < 8; ++i) {
        p[i] = layout.points[at(hexa.points[i])];
    }
    return p;
}

double corners_of(const Layout &layout, const Layout::Hexa &hexa) {
    const auto p = places(layout, hexa);
    return hexahedron::scaled_jacobian(p.data());
}

double worst_of(const Layout &layout, const Layout::Hexa &hexa) {
    constexpr double doubtful = 0.15; // at the corners
    const double least = corners_of(layout, hexa);
    return least < doubtful ? std::min(least, worst_inside(places(layout, hexa))) : least;
}

constexpr double sound = 1e-3;

// Where a hexahedron is not what it must keep, its points go back, and so on round them.
void put_back(Layout &layout, std::size_t first, const std::vector<Vec3> &before,
              const std::vector<double> &least) {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t h = first; h < layout.hexas.size(); ++h) {
            if (worst_of(layout, layout.hexas[h]) >= least[h - first]) {
                continue;
            }
            for (const std::int32_t n : layout.hexas[h].points) {
                changed = changed || !(layout.points[at(n)] == before[at(n)]);
                layout.points[at(n)] = before[at(n)];
            }
        }
    }
}

// Points on curved edges that slide apart leave faces short of their area, or give them too much of
// it: those go back. They are marked as points that stay. Whether there were any.
bool keep_areas(Layout &layout, std::size_t first, const std::vector<Vec3> &before,
                std::vector<CadEntity> &on) {
    constexpr double change = 0.01;
    std::map<std::int32_t, std::array<double, 2>> areas;
    const auto area = [](const std::vector<Vec3> &points, const std::array<std::int32_t, 4> &q) {
        return 0.5 * norm(cross(points[at(q[2])] - points[at(q[0])],
                                points[at(q[3])] - points[at(q[1])]));
    };
    for (const auto &quad : layout.quads) {
        auto &both = areas[quad.face];
        both[0] += area(before, quad.points);
        both[1] += area(layout.points, quad.points);
    }
    bool any = false;
    for (const auto &quad : layout.quads) {
        const auto &both = areas[quad.face];
        if (std::abs(both[1] - both[0]) <= change * both[0]) {
            continue;
        }
        any = true;
        for (const std::int32_t n : quad.points) {
            layout.points[at(n)] = before[at(n)];
            on[at(n)] = {-1, 0};
        }
    }
    if (any) {
        std::vector<double> least;
        std::vector<Vec3> now = layout.points;
        layout.points = before;
        for (std::size_t h = first; h < layout.hexas.size(); ++h) {
            least.push_back(std::min(sound, worst_of(layout, layout.hexas[h])));
        }
        layout.points = std::move(now);
        put_back(layout, first, before, least);
    }
    return any;
}

// Moves points round the hexahedra below `bad`. That looks at their corners only: where it folds
// the inside of a sound one, its points go back (strict), and so on round them.
void raise(const CadShape &shape, Layout &layout, std::size_t first, double bad, double good,
           bool strict, const Progress &progress) {
    const std::vector<Vec3> before = layout.points;
    std::vector<std::int32_t> nodes;
    std::vector<double> least; // that each hexahedron must keep
    for (std::size_t h = first; h < layout.hexas.size(); ++h) {
        nodes.insert(nodes.end(), layout.hexas[h].points.begin(), layout.hexas[h].points.end());
        least.push_back(std::min(sound, worst_of(layout, layout.hexas[h])));
    }
    improve_mesh(shape, layout.points, layout.on, nodes, {}, {}, bad, {.good = good}, progress);
    if (strict) {
        put_back(layout, first, before, least);
    }
}

// Raises what is below 0.25: corner by corner, then the neighbourhoods that stay below 0.2.
// on: as the layout's, or dimension -1 for points that stay.
void polish(const CadShape &shape, Layout &layout, std::size_t first,
            const std::vector<CadEntity> &on, const Progress &progress) {
    constexpr double good = 0.25;
    constexpr double poor = 0.2;
    std::vector<std::array<std::int32_t, 8>> nodes;
    std::vector<Vec3> before = layout.points;
    std::vector<double> least;
    for (std::size_t h = first; h < layout.hexas.size(); ++h) {
        nodes.push_back(layout.hexas[h].points);
        least.push_back(std::min(sound, worst_of(layout, layout.hexas[h])));
    }
    const auto keep = [&] {
        put_back(layout, first, before, least);
        before = layout.points;
    };
    constexpr int visits = 12'000;
    raise_mesh(shape, layout.points, on, nodes, good, visits, part_of(progress, 0, 0.5));
    keep();
    constexpr int turns = 2;
    constexpr int spots = 60;
    for (int turn = 0; turn < turns; ++turn) {
        const double from = 0.5 + 0.25 * turn;
        if (!improve_spots(shape, layout.points, on, nodes, poor, good, spots,
                           part_of(progress, from, from + 0.1))) {
            break;
        }
        keep();
        raise_mesh(shape, layout.points, on, nodes, good, visits / 4,
                   part_of(progress, from + 0.1, from + 0.25));
        keep();
    }
}

// A point of a tetrahedron's hexahedra where its faces are plane and its edges straight.
struct StraightPoint {
    std::int32_t number;
    Vec3 place;
    bool leaves; // the CAD
};

// Hexahedra of straight tetrahedra are positive. Where some are not, all points of theirs go where
// the straight tetrahedron has them, and so on where that spoils a neighbour. The number of points
// that have left a face. parts: the hexahedra of each tetrahedron.
int straighten(Layout &layout, const std::vector<std::vector<std::int32_t>> &parts,
               const std::function<std::vector<StraightPoint>(std::size_t)> &straight) {
    std::vector<std::vector<std::int32_t>> tets_at(layout.points.size());
    for (std::size_t t = 0; t < parts.size(); ++t) {
        for (const std::int32_t h : parts[t]) {
            for (const std::int32_t n : layout.hexas[at(h)].points) {
                auto &list = tets_at[at(n)];
                if (list.empty() || list.back() != static_cast<std::int32_t>(t)) {
                    list.push_back(static_cast<std::int32_t>(t));
                }
            }
        }
    }
    std::vector<char> done(parts.size(), 0);
    std::vector<std::int32_t> work(parts.size());
    std::iota(work.begin(), work.end(), 0);
    int off = 0;
    while (!work.empty()) {
        std::set<std::int32_t> next;
        for (const std::int32_t t : work) {
            const bool bad = std::any_of(parts[at(t)].begin(), parts[at(t)].end(), [&](auto h) {
                return worst_of(layout, layout.hexas[at(h)]) < sound;
            });
            if (!bad || done[at(t)] != 0) {
                continue;
            }
            done[at(t)] = 1;
            for (const auto &[n, place, leaves] : straight(at(t))) {
                if (layout.points[at(n)] == place) {
                    continue;
                }
                layout.points[at(n)] = place;
                next.insert(tets_at[at(n)].begin(), tets_at[at(n)].end());
                if (leaves) {
                    layout.on[at(n)] = {3, layout.hexas[at(parts[at(t)][0])].solid};
                    ++off;
                }
            }
        }
        work.assign(next.begin(), next.end());
    }
    return off;
}

} // namespace

TetHexas tets_to_hexas(const CadShape &shape, const Skin &skin, std::span<const SolidTets> solids,
                       Layout &layout, const Progress &progress, bool split) {
    CadTets mesh(shape, skin, solids);
    if (split) {
        mesh.split_grazing();
        mesh.split_folding(4);
    }
    mesh.improve(split ? 0.1 : 0.3, part_of(progress, 0, 0.3));

    // Points of the layout: corners, middles of edges, of faces, of tetrahedra.
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
                 0.3 + 0.1 * static_cast<double>(t) / static_cast<double>(mesh.tets.size()));
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

    const std::vector<Vec3> start = layout.points;
    // The few that are inside out first: they need many sweeps over few points.
    raise(shape, layout, first_hexa, 0.005, 0.1, true, part_of(progress, 0.4, 0.5));
    // Where many stay so, a finer skin must help first.
    const std::ptrdiff_t many = split ? 200 : 20;
    const auto folded_ones = std::count_if(
        layout.hexas.begin() + static_cast<std::ptrdiff_t>(first_hexa), layout.hexas.end(),
        [&](const auto &hexa) { return corners_of(layout, hexa) < sound; });
    if (folded_ones < many) {
        raise(shape, layout, first_hexa, 0.1, 0.2, true, part_of(progress, 0.45, 0.5));
    }
    std::vector<CadEntity> on = layout.on;
    for (int turn = 0; turn < 2 && folded_ones < many; ++turn) {
        polish(shape, layout, first_hexa, on,
               part_of(progress, 0.5 + 0.2 * turn, 0.7 + 0.2 * turn));
        if (!keep_areas(layout, first_hexa, start, on)) {
            break;
        }
    }

    // A finer skin helps where the CAD bends a tetrahedron, and a flat one anywhere is still sound.
    constexpr double folded = 0.03;
    constexpr double flat = 1e-5;
    constexpr double bent = 1e-3;
    std::int32_t last = -1;
    TetHexas result;
    for (std::size_t h = 0; h < tet_of.size(); ++h) {
        const double quality = worst_of(layout, layout.hexas[first_hexa + h]);
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
                const Vec3 m = start[at(middle(p[i], p[j], 0))];
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
    // What is left becomes straight.
    const double near = 1e-10 * shape.diagonal();
    std::vector<std::vector<std::int32_t>> parts(mesh.tets.size());
    for (std::size_t h = 0; h < tet_of.size(); ++h) {
        parts[at(tet_of[h])].push_back(static_cast<std::int32_t>(first_hexa + h));
    }
    const auto straight = [&](std::size_t t) {
        const auto &[p, solid] = mesh.tets[t];
        std::vector<StraightPoint> list;
        // Curves along the CAD's edges stay.
        const auto add = [&](std::int32_t n, Vec3 place) {
            const Vec3 was = start[at(n)];
            const int dimension = layout.on[at(n)].dimension;
            const bool same = dimension < 2 || (dimension == 2 && distance(place, was) < near);
            list.push_back({n, same ? was : place, !same && dimension == 2});
        };
        Vec3 all{0, 0, 0};
        for (std::size_t i = 0; i < 4; ++i) {
            add(corner(p[i]), mesh.points[at(p[i])]);
            all += 0.25 * mesh.points[at(p[i])];
            const auto &[j, k, l] = others[i];
            for (const std::size_t other : others[i]) {
                if (other > i) {
                    add(middle(p[i], p[other], solid),
                        0.5 * (mesh.points[at(p[i])] + mesh.points[at(p[other])]));
                }
            }
            add(centre({p[j], p[k], p[l]}, solid),
                (1.0 / 3) *
                    (mesh.points[at(p[j])] + mesh.points[at(p[k])] + mesh.points[at(p[l])]));
        }
        add(layout.hexas[at(parts[t][0])].points[6], all);
        return list;
    };
    const auto measure = [&](int off) {
        result.worst = result.inside = 1;
        for (std::size_t h = first_hexa; h < layout.hexas.size(); ++h) {
            result.worst = std::min(result.worst, corners_of(layout, layout.hexas[h]));
            result.inside = std::min(result.inside, worst_of(layout, layout.hexas[h]));
        }
        result.off_cad = off;
        return std::tuple(result.worst >= sound, result.inside > 0, -off, result.worst);
    };
    auto best = measure(0);
    if (!split && folded_ones >= many) {
        return result;
    }
    Layout found = layout;
    const int off = straighten(layout, parts, straight);
    // What has left the CAD is free now; the inside of hexahedra counts less than their corners.
    for (const bool strict : {true, false}) {
        if (off == 0 && std::get<0>(best) && std::get<1>(best)) {
            break;
        }
        raise(shape, layout, first_hexa, 0.02, 0.1, strict, progress);
        const auto now = measure(off);
        if (now > best) {
            best = now;
            found = layout;
        }
        if (std::get<0>(best) && std::get<1>(best)) {
            break;
        }
    }
    layout = std::move(found);
    measure(-std::get<2>(best));
    return result;
}

} // namespace nmgs::cad
