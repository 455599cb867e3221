// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/tet_improvement.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>

namespace nmgs {
namespace {

using Corners = std::array<std::int32_t, 4>;
using Face = std::array<std::int32_t, 3>;

// For each corner the three others, right-handed: of the opposite face, seen from the corner.
constexpr std::array<std::array<std::size_t, 3>, 4> others{
    {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}}};
// Number of the edge between two corners.
constexpr std::array<std::array<std::size_t, 4>, 4> edge_of{
    {{9, 0, 1, 2}, {0, 9, 3, 4}, {1, 3, 9, 5}, {2, 4, 5, 9}}};
constexpr std::array<std::array<std::size_t, 2>, 6> ends_of{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

double scaled(Vec3 u, Vec3 v, Vec3 w) {
    const double l = norm2(u) * norm2(v) * norm2(w);
    return l > 0 ? determinant(u, v, w) / std::sqrt(l) : -1;
}

Face sorted(Face f) {
    std::sort(f.begin(), f.end());
    return f;
}

std::uint64_t key_of(std::int32_t a, std::int32_t b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U |
           static_cast<std::uint64_t>(std::max(a, b));
}

// Stops measuring at what is no better than `floor`.
double quality_of(const std::array<Vec3, 4> &p, const std::array<Vec3, 6> &m,
                  const std::array<Vec3, 4> &f, double floor) {
    Vec3 c{0, 0, 0};
    for (const Vec3 q : p) {
        c += -0.125 * q;
    }
    for (const Vec3 q : m) {
        c += 0.25 * q;
    }
    double least = 1;
    const auto take = [&](Vec3 o, Vec3 x, Vec3 y, Vec3 z) {
        least = std::min(least, scaled(x - o, y - o, z - o));
        return least > floor;
    };
    for (std::size_t v = 0; v < 4; ++v) {
        const auto [i, j, k] = others[v];
        const Vec3 vi = m[edge_of[v][i]];
        const Vec3 vj = m[edge_of[v][j]];
        const Vec3 vk = m[edge_of[v][k]];
        if (!take(p[v], vi, vj, vk) || !take(vi, f[k], p[v], f[j]) || !take(vj, p[v], f[k], f[i]) ||
            !take(vk, f[i], f[j], p[v]) || !take(f[k], vj, vi, c) || !take(f[j], vi, vk, c) ||
            !take(f[i], vk, vj, c) || !take(c, f[j], f[i], f[k])) {
            return least;
        }
    }
    return least;
}

class Improver {
public:
    Improver(TetMesh &mesh, const TetImprovementOptions &options);
    double run(const Progress &progress);

private:
    double quality(const Corners &p, double floor = -2);
    double quality_at(const Corners &p, std::int32_t moved, Vec3 place, double floor);
    [[nodiscard]] bool alive(std::int32_t t) const { return mesh_.tets[at(t)].part >= 0; }
    [[nodiscard]] bool kept(std::int32_t a, std::int32_t b) const;
    [[nodiscard]] bool kept(const Face &f) const;
    [[nodiscard]] std::int32_t beyond(std::int32_t tet, const Face &f) const;
    void replace(const std::vector<std::int32_t> &old, const std::vector<Corners> &fresh);
    bool smooth(std::int32_t point, int steps);
    bool remove_edge(std::int32_t tet, std::size_t edge);
    bool flip_face(std::int32_t tet, std::size_t opposite);
    bool fill_cavity(std::vector<std::int32_t> cavity);
    Vec3 best_place(const std::vector<Face> &faces, Vec3 start, double &worth);
    void mend(std::int32_t tet, double good);
    bool around(std::int32_t a, std::int32_t b, std::vector<std::int32_t> &tets) const;

    TetMesh &mesh_;
    TetImprovementOptions options_;
    std::vector<std::vector<std::int32_t>> of_; // tetrahedra of each point
    std::vector<double> quality_;
    std::vector<char> on_face_; // points of faces that stay
    std::unordered_map<std::uint64_t, Vec3> middles_;
    std::vector<std::vector<std::pair<Face, Vec3>>> centres_; // by least corner
    long work_ = 0;
};

Improver::Improver(TetMesh &mesh, const TetImprovementOptions &options)
    : mesh_(mesh), options_(options), of_(mesh.points.size()), quality_(mesh.tets.size()),
      on_face_(mesh.points.size(), 0), centres_(mesh.points.size()) {
    for (const auto &[ends, place] : mesh.middles) {
        middles_.emplace(key_of(ends[0], ends[1]), place);
        on_face_[at(ends[0])] = on_face_[at(ends[1])] = 1;
    }
    for (const auto &[corners, place] : mesh.centres) {
        centres_[at(corners[0])].emplace_back(corners, place);
    }
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const std::int32_t n : mesh.tets[t].p) {
            of_[at(n)].push_back(static_cast<std::int32_t>(t));
        }
        quality_[t] = quality(mesh.tets[t].p);
    }
}

bool Improver::kept(std::int32_t a, std::int32_t b) const {
    return on_face_[at(a)] != 0 && on_face_[at(b)] != 0 && middles_.contains(key_of(a, b));
}

bool Improver::kept(const Face &f) const {
    if (on_face_[at(f[0])] == 0 || on_face_[at(f[1])] == 0 || on_face_[at(f[2])] == 0) {
        return false;
    }
    const Face key = sorted(f);
    const auto &list = centres_[at(key[0])];
    return std::any_of(list.begin(), list.end(), [&](const auto &e) { return e.first == key; });
}

double Improver::quality(const Corners &p, double floor) {
    return quality_at(p, -1, {}, floor);
}

double Improver::quality_at(const Corners &p, std::int32_t moved, Vec3 place, double floor) {
    ++work_;
    std::array<Vec3, 4> x{};
    std::array<bool, 4> on{};
    for (std::size_t i = 0; i < 4; ++i) {
        const bool here = p[i] == moved || p[i] < 0;
        x[i] = here ? place : mesh_.points[at(p[i])];
        on[i] = !here && on_face_[at(p[i])] != 0;
    }
    if (determinant(x[1] - x[0], x[2] - x[0], x[3] - x[0]) <= 0) {
        return -1;
    }
    std::array<Vec3, 6> m{};
    for (std::size_t e = 0; e < 6; ++e) {
        const auto [a, b] = ends_of[e];
        m[e] = 0.5 * (x[a] + x[b]);
        if (on[a] && on[b]) {
            const auto found = middles_.find(key_of(p[a], p[b]));
            if (found != middles_.end()) {
                m[e] = found->second;
            }
        }
    }
    std::array<Vec3, 4> f{};
    for (std::size_t v = 0; v < 4; ++v) {
        const auto [i, j, k] = others[v];
        f[v] = (4.0 / 9) * (m[edge_of[i][j]] + m[edge_of[j][k]] + m[edge_of[k][i]]) -
               (1.0 / 9) * (x[i] + x[j] + x[k]);
        if (on[i] && on[j] && on[k]) {
            const Face key = sorted({p[i], p[j], p[k]});
            for (const auto &[corners, centre] : centres_[at(key[0])]) {
                if (corners == key) {
                    f[v] = centre;
                }
            }
        }
    }
    return quality_of(x, m, f, floor);
}

// The tetrahedron on the other side of a face, or -1 where the face stays.
std::int32_t Improver::beyond(std::int32_t tet, const Face &f) const {
    if (kept(f)) {
        return -1;
    }
    for (const std::int32_t t : of_[at(f[0])]) {
        const auto &p = mesh_.tets[at(t)].p;
        if (t != tet && std::find(p.begin(), p.end(), f[1]) != p.end() &&
            std::find(p.begin(), p.end(), f[2]) != p.end()) {
            return mesh_.tets[at(t)].part == mesh_.tets[at(tet)].part ? t : -1;
        }
    }
    return -1;
}

void Improver::replace(const std::vector<std::int32_t> &old, const std::vector<Corners> &fresh) {
    const std::int32_t part = mesh_.tets[at(old[0])].part;
    for (const std::int32_t t : old) {
        for (const std::int32_t n : mesh_.tets[at(t)].p) {
            std::erase(of_[at(n)], t);
        }
        mesh_.tets[at(t)].part = -1;
    }
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        std::int32_t number = 0;
        if (i < old.size()) {
            number = old[i];
        } else {
            number = static_cast<std::int32_t>(mesh_.tets.size());
            mesh_.tets.emplace_back();
            quality_.push_back(0);
        }
        mesh_.tets[at(number)] = {fresh[i], part};
        for (const std::int32_t n : fresh[i]) {
            of_[at(n)].push_back(number);
        }
        quality_[at(number)] = quality(fresh[i]);
    }
}

// Moves a point to where the worst tetrahedron round it is best: along that one's gradient, else
// along the axes.
bool Improver::smooth(std::int32_t point, int steps) {
    if (mesh_.fixed[at(point)] != 0 || of_[at(point)].empty()) {
        return false;
    }
    auto list = of_[at(point)];
    const auto worse = [&](std::int32_t a, std::int32_t b) {
        return quality_[at(a)] < quality_[at(b)];
    };
    std::sort(list.begin(), list.end(), worse);
    Vec3 here = mesh_.points[at(point)];
    double worth = quality_[at(list[0])];
    double reach = 0;
    Vec3 middle{0, 0, 0};
    for (const std::int32_t t : list) {
        for (const std::int32_t n : mesh_.tets[at(t)].p) {
            reach = std::max(reach, distance(mesh_.points[at(n)], here));
            middle += (1.0 / 3) * mesh_.points[at(n)];
        }
        middle += (-1.0 / 3) * here;
    }
    middle = (1 / static_cast<double>(list.size())) * middle;
    const double start = worth;
    std::size_t worst = 0;
    const auto attempt = [&](Vec3 place) {
        double least = 1;
        std::size_t lowest = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const double q = quality_at(mesh_.tets[at(list[i])].p, point, place, worth);
            if (q <= worth) {
                std::swap(list[i], list[i / 2]); // it will fail early the next time
                worst = 0;
                return false;
            }
            if (q < least) {
                least = q;
                lowest = i;
            }
        }
        worth = least;
        here = place;
        worst = lowest;
        return true;
    };
    attempt(middle);
    double step = 0.1 * reach;
    for (int k = 0; k < steps && worth < options_.good + 0.1; ++k) {
        const auto &p = mesh_.tets[at(list[worst])].p;
        const double h = 1e-5 * reach;
        const double q = quality_at(p, point, here, -2);
        Vec3 slope{quality_at(p, point, here + Vec3{h, 0, 0}, -2) - q,
                   quality_at(p, point, here + Vec3{0, h, 0}, -2) - q,
                   quality_at(p, point, here + Vec3{0, 0, h}, -2) - q};
        slope = unit(slope);
        bool better = attempt(here + step * slope);
        for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0},
                             Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
            if (better) {
                break;
            }
            better = attempt(here + step * d);
        }
        step *= better ? 1.2 : 0.4;
        if (step < 1e-3 * reach) {
            break;
        }
    }
    if (worth <= start) {
        return false;
    }
    mesh_.points[at(point)] = here;
    for (const std::int32_t t : list) {
        quality_[at(t)] = quality(mesh_.tets[at(t)].p);
    }
    return true;
}

// The tetrahedra round an edge; false where they do not close, or are of two parts.
bool Improver::around(std::int32_t a, std::int32_t b, std::vector<std::int32_t> &tets) const {
    for (const std::int32_t t : of_[at(a)]) {
        const auto &p = mesh_.tets[at(t)].p;
        if (std::find(p.begin(), p.end(), b) != p.end()) {
            if (!tets.empty() && mesh_.tets[at(t)].part != mesh_.tets[at(tets[0])].part) {
                return false;
            }
            tets.push_back(t);
        }
    }
    return tets.size() > 2;
}

bool Improver::remove_edge(std::int32_t tet, std::size_t edge) {
    const std::int32_t a = mesh_.tets[at(tet)].p[ends_of[edge][0]];
    const std::int32_t b = mesh_.tets[at(tet)].p[ends_of[edge][1]];
    constexpr std::size_t most = 8;
    std::vector<std::int32_t> tets;
    if (kept(a, b) || !around(a, b, tets) || tets.size() > most) {
        return false;
    }
    double floor = 1;
    // Each tetrahedron (a, b, x, y), positive, leads from x to y.
    std::vector<std::array<std::int32_t, 2>> steps;
    for (const std::int32_t t : tets) {
        floor = std::min(floor, quality_[at(t)]);
        const auto &p = mesh_.tets[at(t)].p;
        for (std::size_t v = 0; v < 4; ++v) {
            if (p[v] != a) {
                continue;
            }
            const auto &o = others[v];
            for (std::size_t i = 0; i < 3; ++i) {
                if (p[o[i]] == b) {
                    steps.push_back({p[o[(i + 1) % 3]], p[o[(i + 2) % 3]]});
                }
            }
        }
    }
    std::vector<std::int32_t> ring{steps[0][0]};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const auto next = std::find_if(steps.begin(), steps.end(),
                                       [&](const auto &s) { return s[0] == ring.back(); });
        if (next == steps.end()) {
            return false;
        }
        if ((*next)[1] == ring[0]) {
            break;
        }
        ring.push_back((*next)[1]);
    }
    const std::size_t n = ring.size();
    if (n != tets.size()) {
        return false;
    }
    // Best worst of the polygon from i to j, and the third corner there.
    std::array<std::array<double, most>, most> best{};
    std::array<std::array<std::size_t, most>, most> third{};
    for (std::size_t i = 0; i + 1 < n; ++i) {
        best[i][i + 1] = 1;
    }
    for (std::size_t span = 2; span < n; ++span) {
        for (std::size_t i = 0; i + span < n; ++i) {
            const std::size_t j = i + span;
            best[i][j] = -2;
            for (std::size_t k = i + 1; k < j; ++k) {
                double q = std::min(best[i][k], best[k][j]);
                const double bar = std::max(floor, best[i][j]);
                if (q <= bar) {
                    continue;
                }
                q = std::min(q, quality({ring[i], ring[k], ring[j], b}, bar));
                q = q > bar ? std::min(q, quality({ring[i], ring[j], ring[k], a}, bar)) : q;
                if (q > best[i][j]) {
                    best[i][j] = q;
                    third[i][j] = k;
                }
            }
        }
    }
    if (best[0][n - 1] <= floor) {
        return false;
    }
    std::vector<Corners> fresh;
    std::vector<std::array<std::size_t, 2>> work{{0, n - 1}};
    while (!work.empty()) {
        const auto [i, j] = work.back();
        work.pop_back();
        if (j < i + 2) {
            continue;
        }
        const std::size_t k = third[i][j];
        fresh.push_back({ring[i], ring[k], ring[j], b});
        fresh.push_back({ring[i], ring[j], ring[k], a});
        work.push_back({i, k});
        work.push_back({k, j});
    }
    replace(tets, fresh);
    return true;
}

// Two tetrahedra become three round a new edge.
bool Improver::flip_face(std::int32_t tet, std::size_t opposite) {
    const Corners p = mesh_.tets[at(tet)].p;
    const auto [i, j, k] = others[opposite];
    const Face f{p[i], p[j], p[k]};
    const std::int32_t other = beyond(tet, f);
    if (other < 0) {
        return false;
    }
    const double floor = std::min(quality_[at(tet)], quality_[at(other)]);
    std::int32_t far = -1;
    for (const std::int32_t n : mesh_.tets[at(other)].p) {
        far = std::find(f.begin(), f.end(), n) == f.end() ? n : far;
    }
    if (kept(p[opposite], far)) {
        return false; // it is an edge elsewhere
    }
    std::vector<Corners> fresh;
    for (std::size_t s = 0; s < 3; ++s) {
        fresh.push_back({p[opposite], f[s], f[(s + 1) % 3], far});
        if (quality(fresh.back(), floor) <= floor) {
            return false;
        }
    }
    replace({tet, other}, fresh);
    return true;
}

// Where the worst tetrahedron over the faces (seen from inside, right-handed) is best.
Vec3 Improver::best_place(const std::vector<Face> &faces, Vec3 start, double &worth) {
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
bool Improver::fill_cavity(std::vector<std::int32_t> cavity) {
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
                const Face f{p[others[v][0]], p[others[v][1]], p[others[v][2]]};
                const auto [known, fresh] = boundary.try_emplace(sorted(f), f, t);
                if (!fresh) {
                    boundary.erase(known);
                }
                points.insert(p[v]);
            }
            for (const auto &[a, b] : ends_of) {
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

// Tries what may help a tetrahedron that is worse than `good`, the cheapest first.
void Improver::mend(std::int32_t t, double good) {
    const auto still = [&] { return alive(t) && quality_[at(t)] < good; };
    const Corners p = mesh_.tets[at(t)].p;
    const auto same = [&] { return still() && mesh_.tets[at(t)].p == p; };
    for (std::size_t e = 0; e < 6 && same(); ++e) {
        remove_edge(t, e);
    }
    for (std::size_t v = 0; v < 4 && same(); ++v) {
        flip_face(t, v);
    }
    for (std::size_t v = 0; v < 4 && still(); ++v) {
        smooth(mesh_.tets[at(t)].p[v], 12);
    }
    // New points only where nothing else has helped.
    constexpr double poor = 0.8;
    if (!still() || quality_[at(t)] > poor * good) {
        return;
    }
    if (!fill_cavity({t}) && same()) {
        for (const auto &[a, b] : ends_of) {
            std::vector<std::int32_t> ring;
            if (same() && !kept(p[a], p[b]) && around(p[a], p[b], ring)) {
                fill_cavity(ring);
            }
        }
    }
}

double Improver::run(const Progress &progress) {
    const auto lacking = [&] {
        double lack = 0;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (mesh_.tets[t].part >= 0) {
                lack += std::max(0.0, options_.good - quality_[t]);
            }
        }
        return lack;
    };
    constexpr long least_work = 1'000'000;
    constexpr long work_each = 250;
    constexpr long most_work = 4'000'000;
    const long limit =
        options_.work > 0
            ? options_.work
            : std::min(least_work + work_each * static_cast<long>(mesh_.tets.size()), most_work);
    double last = lacking();
    for (int round = 0; round < options_.rounds && work_ < limit; ++round) {
        // What is worst first, all over the mesh.
        constexpr std::array<double, 4> stages{0.3, 0.5, 0.8, 1};
        const double good =
            options_.good * stages[std::min<std::size_t>(static_cast<std::size_t>(round), 3)];
        std::vector<std::pair<double, std::int32_t>> bad;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            if (mesh_.tets[t].part >= 0 && quality_[t] < good) {
                bad.emplace_back(quality_[t], static_cast<std::int32_t>(t));
            }
        }
        std::sort(bad.begin(), bad.end());
        for (std::size_t i = 0; i < bad.size() && work_ < limit; ++i) {
            if (i % 16 == 0) {
                poll(progress, static_cast<double>(round) / options_.rounds);
            }
            mend(bad[i].second, good);
        }
        const double now = lacking();
        if (round > 3 && now > 0.97 * last) {
            break;
        }
        last = now;
    }
    std::erase_if(mesh_.tets, [](const TetMesh::Tet &t) { return t.part < 0; });
    double worst = 1;
    for (const auto &t : mesh_.tets) {
        worst = std::min(worst, quality(t.p));
    }
    return worst;
}

} // namespace

double hexas_quality(const std::array<Vec3, 4> &corners, const std::array<Vec3, 6> &middles,
                     const std::array<Vec3, 4> &centres) {
    return quality_of(corners, middles, centres, -2);
}

double improve_tets(TetMesh &mesh, const TetImprovementOptions &options, const Progress &progress) {
    return Improver(mesh, options).run(progress);
}

} // namespace nmgs
