// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/hexas_of_tet.h"
#include "nmgs/quality/tet_improver.h"
#include "nmgs/support/ascending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace nmgs {

// Where the worst tetrahedron over the faces (seen from inside, right-handed) is best.
Vec3 TetImprover::best_place(const std::vector<Face> &faces, Vec3 start, double &worth) {
    double reach = 0;
    for (const Face &f : faces) {
        for (const std::int32_t n : f) {
            reach = std::max(reach, distance(mesh_.points[at(n)], start));
        }
    }
    std::vector<std::size_t> order(faces.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    const auto value = [&](Vec3 place, double floor) {
        double least = 1;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Face &f = faces[order[i]];
            least = std::min(least, quality_at({-1, f[0], f[1], f[2]}, -1, place, floor));
            if (least <= floor) {
                std::swap(order[i], order[i / 2]);
                break;
            }
        }
        return least;
    };
    Vec3 here = start;
    worth = value(here, -2);
    double step = 0.3 * reach;
    for (int k = 0; k < 12 && step > 0.01 * reach; ++k) {
        bool better = false;
        for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0},
                             Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
            const Vec3 there = here + step * d;
            const double q = value(there, worth);
            if (q > worth) {
                worth = q;
                here = there;
                better = true;
            }
        }
        step *= better ? 1 : 0.5;
    }
    return here;
}

// Fills a cavity from a point inside; it grows over the worst face as long as this helps.
bool TetImprover::fill_cavity(std::vector<std::int32_t> cavity) {
    constexpr int growth = 10;
    constexpr double gain = 1e-3;
    std::vector<Face> best_faces;
    std::vector<std::int32_t> best_cavity;
    Vec3 best_point{};
    double best = -2;
    double floor = 1;
    for (const std::int32_t t : cavity) {
        floor = std::min(floor, quality_[at(t)]);
    }
    for (int grown = 0; grown <= growth; ++grown) {
        std::map<Face, std::pair<Face, std::int32_t>> boundary;
        std::set<std::uint64_t> edges;
        std::set<std::int32_t> points;
        for (const std::int32_t t : cavity) {
            const auto &p = mesh_.tets[at(t)].p;
            for (std::size_t v = 0; v < 4; ++v) {
                const Face f{p[tet_others[v][0]], p[tet_others[v][1]], p[tet_others[v][2]]};
                const auto [known, fresh] = boundary.try_emplace(sorted(f), f, t);
                if (!fresh) {
                    boundary.erase(known);
                }
                points.insert(p[v]);
            }
            for (const auto &[a, b] : tet_edges) {
                if (kept(p[a], p[b])) {
                    edges.insert(key_of(p[a], p[b]));
                }
            }
        }
        std::vector<Face> faces;
        std::vector<std::int32_t> owner;
        for (const auto &[key, entry] : boundary) {
            faces.push_back(entry.first);
            owner.push_back(entry.second);
            for (std::size_t i = 0; i < 3; ++i) {
                edges.erase(key_of(entry.first[i], entry.first[(i + 1) % 3]));
                points.erase(entry.first[i]);
            }
        }
        const bool loses =
            !edges.empty() || std::any_of(points.begin(), points.end(),
                                          [&](std::int32_t n) { return mesh_.fixed[at(n)] != 0; });
        if (loses) {
            break;
        }
        Vec3 start{0, 0, 0};
        for (const Face &f : faces) {
            for (const std::int32_t n : f) {
                start += (1.0 / 3 / static_cast<double>(faces.size())) * mesh_.points[at(n)];
            }
        }
        if (best > -2 && best > 0) {
            start = best_point;
        }
        double worth = 0;
        const Vec3 place = best_place(faces, start, worth);
        if (worth > best) {
            best = worth;
            best_point = place;
            best_faces = faces;
            best_cavity = cavity;
        }
        // Over the worst face that may go.
        std::int32_t next = -1;
        double lowest = best + 0.05;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const Face &f = faces[i];
            const double q = quality_at({-1, f[0], f[1], f[2]}, -1, place, -2);
            if (q < lowest) {
                const std::int32_t t = beyond(owner[i], f);
                if (t >= 0 && std::find(cavity.begin(), cavity.end(), t) == cavity.end()) {
                    lowest = q;
                    next = t;
                }
            }
        }
        if (next < 0) {
            break;
        }
        floor = std::min(floor, quality_[at(next)]);
        cavity.push_back(next);
    }
    double was = 1;
    for (const std::int32_t t : best_cavity) {
        was = std::min(was, quality_[at(t)]);
    }
    if (best <= was + gain) {
        return false;
    }
    const auto point = static_cast<std::int32_t>(mesh_.points.size());
    mesh_.points.push_back(best_point);
    mesh_.fixed.push_back(0);
    on_face_.push_back(0);
    of_.emplace_back();
    centres_.emplace_back();
    std::vector<Corners> fresh;
    fresh.reserve(best_faces.size());
    for (const Face &f : best_faces) {
        fresh.push_back({point, f[0], f[1], f[2]});
    }
    replace(best_cavity, fresh);
    return true;
}

} // namespace nmgs
