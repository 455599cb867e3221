// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_general.h"

#include "nmgs/convert/matching.h"
#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/face_triangles.h"
#include "nmgs_cad/quad_cleanup.h"
#include "nmgs_cad/quad_repair.h"
#include "nmgs_cad/quad_smoothing.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <set>
#include <span>

namespace nmgs::cad {
namespace {

constexpr double pi = std::numbers::pi;
using Quad = std::array<std::int32_t, 4>;
using Cell = std::vector<std::int32_t>; // three or four nodes, counter-clockwise

// How near to right the quad's angles are: 1 for a rectangle, 0 when one is straight or nothing.
double rightness(const FaceMesh &mesh, const Quad &quad) {
    double worst = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        worst = std::max(worst, std::abs(pi / 2 - corner_angle(mesh, quad, c)));
    }
    return std::max(0.0, 1 - worst / (pi / 2));
}

// What a pair of triangles is worth: one with a straight corner on the boundary, which no smoothing
// mends, costs more than several good ones bring.
double worth(const FaceMesh &mesh, const Quad &quad) {
    constexpr double straight = 0.9 * pi;
    constexpr double price = 4;
    double value = rightness(mesh, quad);
    for (std::size_t c = 0; c < 4; ++c) {
        const double angle = corner_angle(mesh, quad, c);
        if (mesh.fixed(quad[c]) && !unavoidable(mesh, quad, c) && (angle > straight || angle < 0)) {
            value -= price;
        }
    }
    return value;
}

struct Pairing {
    const FaceTriangles &from;
    std::vector<Cell> cells;

    [[nodiscard]] bool kept(std::int32_t a, std::int32_t b) const {
        return from.kept.contains(ascending(a, b));
    }
    void match() {
        std::map<std::array<std::int32_t, 2>, std::int32_t> of_edge;
        for (std::size_t t = 0; t < from.triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto &v = from.triangles[t];
                of_edge[{v[i], v[(i + 1) % 3]}] = static_cast<std::int32_t>(t);
            }
        }
        constexpr double steps = 1e4;
        const auto base =
            static_cast<std::int64_t>(steps * (20.0 + static_cast<double>(from.triangles.size())));
        std::vector<WeightedPair> pairs;
        std::map<std::array<std::int32_t, 2>, Quad> quads;
        for (const auto &[e, s] : of_edge) {
            const auto twin = of_edge.find({e[1], e[0]});
            if (e[0] > e[1] || twin == of_edge.end() || kept(e[0], e[1]) || twin->second == s) {
                continue;
            }
            const std::int32_t t = twin->second;
            const std::array<std::int32_t, 2> key{std::min(s, t), std::max(s, t)};
            const Quad quad{e[0], third(t, e), e[1], third(s, e)};
            const double value = worth(from.nodes, quad);
            // Two triangles with two common edges: at a pole.
            if (quads.contains(key)) {
                continue;
            }
            quads[key] = quad;
            pairs.push_back({key[0], key[1], base + std::llround(steps * value)});
        }
        const auto mate =
            maximum_weight_matching(static_cast<std::int32_t>(from.triangles.size()), pairs);
        for (std::size_t t = 0; t < from.triangles.size(); ++t) {
            const auto me = static_cast<std::int32_t>(t);
            if (mate[t] < 0) {
                cells.push_back({from.triangles[t].begin(), from.triangles[t].end()});
            } else if (me < mate[t]) {
                const Quad &q = quads.at({me, mate[t]});
                cells.push_back({q.begin(), q.end()});
            }
        }
    }
    [[nodiscard]] std::int32_t third(std::int32_t t, std::array<std::int32_t, 2> e) const {
        for (const std::int32_t v : from.triangles[at(t)]) {
            if (v != e[0] && v != e[1]) {
                return v;
            }
        }
        return -1;
    }
    // Signed area about the normal of the triangle's first node.
    [[nodiscard]] double area(std::int32_t a, std::int32_t b, std::int32_t c) const {
        const auto &p = from.nodes.points;
        Vec3 n = from.nodes.normals[at(a)] + from.nodes.normals[at(b)] + from.nodes.normals[at(c)];
        return dot(n, cross(p[at(b)] - p[at(a)], p[at(c)] - p[at(a)]));
    }
    // Joins a triangle left over with the nearest other one: it walks from quad to quad, of each
    // pentagon of the two another quad and triangle are made. False when there is no way.
    bool walk() {
        std::int32_t start = -1;
        for (std::size_t c = 0; c < cells.size() && start < 0; ++c) {
            start = cells[c].size() == 3 ? static_cast<std::int32_t>(c) : -1;
        }
        if (start < 0) {
            return false;
        }
        std::map<std::array<std::int32_t, 2>, std::int32_t> of_edge;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            for (std::size_t i = 0; i < cells[c].size(); ++i) {
                of_edge[{cells[c][i], cells[c][(i + 1) % cells[c].size()]}] =
                    static_cast<std::int32_t>(c);
            }
        }
        std::vector<std::int32_t> before(cells.size(), -2);
        std::deque<std::int32_t> queue{start};
        before[at(start)] = -1;
        std::int32_t goal = -1;
        while (!queue.empty() && goal < 0) {
            const std::int32_t c = queue.front();
            queue.pop_front();
            const Cell &cell = cells[at(c)];
            for (std::size_t i = 0; i < cell.size(); ++i) {
                const std::int32_t a = cell[i];
                const std::int32_t b = cell[(i + 1) % cell.size()];
                const auto next = of_edge.find({b, a});
                if (next == of_edge.end() || kept(a, b) || before[at(next->second)] != -2) {
                    continue;
                }
                before[at(next->second)] = c;
                if (cells[at(next->second)].size() == 3) {
                    goal = next->second;
                    break;
                }
                queue.push_back(next->second);
            }
        }
        if (goal < 0) {
            return false;
        }
        std::vector<std::int32_t> path;
        for (std::int32_t c = goal; c >= 0; c = before[at(c)]) {
            path.push_back(c);
        }
        std::reverse(path.begin(), path.end());
        // The triangle is always the cell path[k].
        for (std::size_t k = 0; k + 2 < path.size(); ++k) {
            const Cell ring = joined(cells[at(path[k])], cells[at(path[k + 1])]);
            // Where the next cell joins.
            const Cell &next = cells[at(path[k + 2])];
            std::size_t place = 5;
            for (std::size_t i = 0; i < 5; ++i) {
                for (std::size_t j = 0; j < next.size(); ++j) {
                    if (ring[i] == next[(j + 1) % next.size()] && ring[(i + 1) % 5] == next[j]) {
                        place = i;
                    }
                }
            }
            if (ring.size() != 5 || place == 5) {
                return false;
            }
            const auto r = [&](std::size_t i) { return ring[(place + i) % 5]; };
            // The triangle on the edge r0 r1 with r2 or r4.
            const bool with_r2 = rightness(from.nodes, {r(2), r(3), r(4), r(0)}) >
                                 rightness(from.nodes, {r(1), r(2), r(3), r(4)});
            cells[at(path[k])] =
                with_r2 ? Cell{r(2), r(3), r(4), r(0)} : Cell{r(1), r(2), r(3), r(4)};
            cells[at(path[k + 1])] = with_r2 ? Cell{r(0), r(1), r(2)} : Cell{r(0), r(1), r(4)};
        }
        const std::int32_t last = path[path.size() - 2];
        const Cell ring = joined(cells[at(last)], cells[at(goal)]);
        if (ring.size() != 4) {
            return false;
        }
        cells[at(last)] = ring;
        cells.erase(cells.begin() + goal);
        return true;
    }
    // The polygon of two cells that share one edge.
    static Cell joined(const Cell &s, const Cell &t) {
        for (std::size_t i = 0; i < s.size(); ++i) {
            for (std::size_t j = 0; j < t.size(); ++j) {
                if (s[i] == t[(j + 1) % t.size()] && s[(i + 1) % s.size()] == t[j]) {
                    Cell ring;
                    for (std::size_t k = 1; k < s.size(); ++k) {
                        ring.push_back(s[(i + k) % s.size()]);
                    }
                    for (std::size_t k = 1; k < t.size(); ++k) {
                        ring.push_back(t[(j + k) % t.size()]);
                    }
                    return ring;
                }
            }
        }
        return {};
    }
};

constexpr double good = 0.4;

struct Attempt {
    FaceMesh mesh;
    double quality; // the worst that could be avoided
    std::set<std::array<std::int32_t, 2>> kept;
    bool mended = false;
};

void mend(Attempt &made, const FaceSurface &surface) {
    constexpr double wanted = 0.3;
    FaceMesh mesh = made.mesh;
    repair_quads(mesh, surface, made.kept, wanted);
    const double quality = worst_avoidable(mesh, surface);
    if (quality >= made.quality) {
        made.quality = quality;
        made.mesh = std::move(mesh);
    }
    made.mended = true;
}

std::optional<Attempt> attempt(const FaceSurface &surface,
                               const std::vector<BoundaryLoop> &boundary,
                               const std::vector<BoundaryLoop> &inner, const Spacing &spacing,
                               Refusal &refusal) {
    const auto triangles = triangulate_face(surface, boundary, inner, spacing, refusal);
    if (!triangles) {
        return std::nullopt;
    }
    if (triangles->triangles.size() % 2 != 0) {
        refusal = {"the boundary has an odd number of segments", {}};
        return std::nullopt;
    }
    Pairing pairing{*triangles, {}};
    pairing.match();
    while (std::any_of(pairing.cells.begin(), pairing.cells.end(),
                       [](const Cell &c) { return c.size() == 3; })) {
        if (!pairing.walk()) {
            refusal = {"the triangles cannot be paired", {}};
            return std::nullopt;
        }
    }
    FaceMesh mesh = triangles->nodes;
    for (const Cell &c : pairing.cells) {
        mesh.quads.push_back({c[0], c[1], c[2], c[3]});
    }
    FaceMesh plain = mesh;
    clean_up_quads(mesh, surface, triangles->kept);
    smooth_quads(mesh, surface, 8, 20);
    double quality = worst_avoidable(mesh, surface);
    if (quality <= good) {
        smooth_quads(plain, surface, 5, 12);
        const double before = worst_avoidable(plain, surface);
        if (before > quality) {
            mesh = std::move(plain);
            quality = before;
        }
    }
    return Attempt{std::move(mesh), quality, triangles->kept, false};
}

} // namespace

std::optional<FaceMesh> general_quads(const FaceSurface &surface,
                                      const std::vector<BoundaryLoop> &boundary,
                                      const std::vector<BoundaryLoop> &inner,
                                      const LayoutOptions &options, Refusal &refusal,
                                      const Progress &progress) {
    constexpr double fair = 0.25; // of large layouts, and of what has to be repaired
    constexpr std::size_t many = 400;
    constexpr std::size_t most = 3000;
    constexpr int most_mends = 2;
    constexpr double scales[] = {1.0, 0.7, 0.5, 0.35, 1.4};
    // A search over cuts lays out hundreds of sections.
    const bool quick = options.attempts < LayoutOptions{}.attempts;
    std::vector<Attempt> kept; // the best one
    std::size_t tried = 0;
    int mends = 0;
    for (const double scale : std::span(scales).first(quick ? 2 : std::size(scales))) {
        poll(progress, 0);
        if (tried > most) {
            break;
        }
        const Spacing spacing{scale, std::min(options.angle, pi / 4), options.size};
        auto made = attempt(surface, boundary, inner, spacing, refusal);
        if (!made) {
            continue;
        }
        tried += made->mesh.quads.size();
        // Where it is poor is the same at every scale in a large layout: mended at once that costs
        // less than to begin anew.
        if (made->quality <= fair && (tried > many || scale == 1.0) && mends < most_mends) {
            mend(*made, surface);
            ++mends;
        }
        if (kept.empty() || made->quality > kept.front().quality) {
            kept.clear();
            kept.push_back(std::move(*made));
        }
        if (kept.front().quality > (tried > many ? fair : good)) {
            break;
        }
    }
    if (kept.empty()) {
        return std::nullopt;
    }
    Attempt &best = kept.front();
    if (best.quality <= fair && !best.mended) {
        mend(best, surface);
    }
    return std::move(best.mesh);
}

} // namespace nmgs::cad
