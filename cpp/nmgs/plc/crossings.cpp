// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/plc/crossings.h"

#include "nmgs/support/parallel.h"
#include "nmgs/support/predicates.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

namespace nmgs {
namespace {

struct Meeting {
    std::int32_t edge_facet, facet;
    Vec3 place;
};

bool has_node(const Plc &plc, std::size_t facet, std::int32_t node) {
    const auto first = plc.polygon_offsets[static_cast<std::size_t>(plc.facet_offsets[facet])];
    const auto last = plc.polygon_offsets[static_cast<std::size_t>(plc.facet_offsets[facet + 1])];
    const auto begin = plc.polygon_nodes.begin();
    return std::find(begin + first, begin + last, node) != begin + last;
}

class EdgeAgainstFacet {
public:
    EdgeAgainstFacet(const Welded &welded, const PlcEdge &edge, std::size_t facet)
        : welded_(welded), edge_(edge), facet_(facet), plane_(welded.planes[facet]),
          rings_(welded.rings[facet].bounding), p_(welded.point(edge.a)), q_(welded.point(edge.b)) {
    }

    // Where the edge meets the facet as it must not.
    [[nodiscard]] std::optional<Vec3> meeting() const {
        const double tolerance = std::max(welded_.tolerance, plane_.off);
        const double dp = plane_.distance(p_);
        const double dq = plane_.distance(q_);
        const bool p_in = std::abs(dp) <= tolerance;
        const bool q_in = std::abs(dq) <= tolerance;
        if (p_in && q_in) {
            return within_plane();
        }
        if (p_in || q_in) {
            return touching(p_in ? edge_.a : edge_.b);
        }
        if ((dp > 0) == (dq > 0) || pierce(welded_.plc, rings_, p_, q_) == Where::outside) {
            return std::nullopt;
        }
        return p_ + (dp / (dp - dq)) * (q_ - p_);
    }

private:
    [[nodiscard]] bool deep_inside(Vec3 place) const {
        return locate(welded_.plc, rings_, plane_, place) == Where::inside &&
               distance_to_edges(place) > welded_.tolerance;
    }

    [[nodiscard]] double distance_to_edges(Vec3 place) const {
        double best = std::numeric_limits<double>::infinity();
        for (const auto ring : rings_) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Vec3 a = welded_.point(ring[k]);
                const Vec3 ab = welded_.point(ring[(k + 1) % ring.size()]) - a;
                const double along =
                    norm2(ab) > 0 ? std::clamp(dot(place - a, ab) / norm2(ab), 0.0, 1.0) : 0.0;
                best = std::min(best, distance(place, a + along * ab));
            }
        }
        return best;
    }

    [[nodiscard]] std::optional<Vec3> touching(std::int32_t node) const {
        const Vec3 place = welded_.point(node);
        return !has_node(welded_.plc, facet_, node) && deep_inside(place) ? std::optional(place)
                                                                          : std::nullopt;
    }

    // An edge in the facet's plane: it may run along the facet's edges and between its points only
    // where the facet has it as an edge.
    [[nodiscard]] std::optional<Vec3> within_plane() const {
        for (const auto *list : {&welded_.rings[facet_].bounding, &welded_.rings[facet_].inner}) {
            for (const auto ring : *list) {
                for (std::size_t k = 0; k < ring.size(); ++k) {
                    const Vec3 a = welded_.point(ring[k]);
                    const Vec3 b = welded_.point(ring[(k + 1) % ring.size()]);
                    if (const auto place = proper_crossing(a, b)) {
                        return place;
                    }
                }
            }
        }
        const Vec3 middle = 0.5 * (p_ + q_);
        return !has_edge() && deep_inside(middle) ? std::optional(middle) : std::nullopt;
    }

    [[nodiscard]] double c(Vec3 p, int axis) const {
        return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    }
    [[nodiscard]] int turn(Vec3 a, Vec3 b, Vec3 d) const {
        const int u = plane_.u;
        const int v = plane_.v;
        return orient2d(c(a, u), c(a, v), c(b, u), c(b, v), c(d, u), c(d, v));
    }

    [[nodiscard]] std::optional<Vec3> proper_crossing(Vec3 a, Vec3 b) const {
        if (turn(a, b, p_) * turn(a, b, q_) >= 0 || turn(p_, q_, a) * turn(p_, q_, b) >= 0) {
            return std::nullopt;
        }
        // All four ends must be off the other line by more than the tolerance.
        const Vec3 d = q_ - p_;
        const Vec3 e = b - a;
        const double area = norm(cross(d, e));
        const auto off = [](Vec3 from, Vec3 along, Vec3 point) {
            return norm(cross(point - from, along)) / norm(along);
        };
        if (off(a, e, p_) <= welded_.tolerance || off(a, e, q_) <= welded_.tolerance ||
            off(p_, d, a) <= welded_.tolerance || off(p_, d, b) <= welded_.tolerance || area == 0) {
            return std::nullopt;
        }
        return p_ + (off(a, e, p_) / (off(a, e, p_) + off(a, e, q_))) * d;
    }

    [[nodiscard]] bool has_edge() const {
        for (std::uint32_t s = edge_.first; s < edge_.last; ++s) {
            if (static_cast<std::size_t>(welded_.sides[s].facet) == facet_) {
                return true;
            }
        }
        return false;
    }

    const Welded &welded_;
    const PlcEdge &edge_;
    std::size_t facet_;
    const FacetPlane &plane_;
    const std::vector<std::span<const std::int32_t>> &rings_;
    Vec3 p_, q_;
};

bool belongs(const Welded &welded, const PlcEdge &edge, std::uint32_t facet) {
    for (std::uint32_t s = edge.first; s < edge.last; ++s) {
        if (static_cast<std::uint32_t>(welded.sides[s].facet) == facet) {
            return true;
        }
    }
    return false;
}

} // namespace

std::vector<PlcProblem> crossings(const Welded &welded, const BoxTree &tree, std::size_t limit,
                                  const Progress &progress) {
    std::vector<Meeting> meetings;
    std::mutex mutex;
    parallel_for(
        welded.edges.size(), 1024,
        [&](std::size_t first, std::size_t last) {
            std::vector<Meeting> found;
            for (std::size_t e = first; e < last; ++e) {
                const PlcEdge &edge = welded.edges[e];
                Box box;
                box.add(welded.point(edge.a));
                box.add(welded.point(edge.b));
                tree.near(box, welded.tolerance, [&](std::uint32_t facet) {
                    if (welded.degenerate(facet) || belongs(welded, edge, facet)) {
                        return;
                    }
                    const auto place = EdgeAgainstFacet(welded, edge, facet).meeting();
                    // All facets at the edge meet the other one there.
                    for (std::uint32_t s = edge.first; place && s < edge.last; ++s) {
                        found.push_back(
                            {welded.sides[s].facet, static_cast<std::int32_t>(facet), *place});
                    }
                });
            }
            const std::lock_guard lock(mutex);
            meetings.insert(meetings.end(), found.begin(), found.end());
        },
        progress, 0.5, 1.0);
    // One place a pair, the same for any number of threads: the smallest one.
    std::map<std::pair<std::int32_t, std::int32_t>, Vec3> pairs;
    for (const Meeting &m : meetings) {
        const std::pair key = std::minmax(m.edge_facet, m.facet);
        const auto [at, fresh] = pairs.try_emplace(key, m.place);
        if (!fresh && std::tie(m.place.x, m.place.y, m.place.z) <
                          std::tie(at->second.x, at->second.y, at->second.z)) {
            at->second = m.place;
        }
    }
    std::vector<PlcProblem> problems;
    for (const auto &[pair, place] : pairs) {
        if (problems.size() == limit) {
            break;
        }
        problems.push_back({PlcFault::crossing_facets, {pair.first, pair.second}, {}, place, 0});
    }
    return problems;
}

} // namespace nmgs
