// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/plc/surface.h"

#include <algorithm>
#include <array>
#include <limits>

namespace nmgs {
namespace {

struct Link {
    std::int32_t other;
    bool agrees; // the two facets run against each other along the edge, as they should
};

// CSR of facets joined at edges of two bounding sides.
struct Links {
    std::vector<std::uint32_t> offsets;
    std::vector<Link> links;
};

bool two_sided(const Welded &welded, const PlcEdge &edge) {
    return edge.last - edge.first == 2 && !welded.sides[edge.first].inner &&
           !welded.sides[edge.first + 1].inner;
}

Links links_of(const Welded &welded) {
    Links result;
    result.offsets.assign(welded.plc.facet_count() + 1, 0);
    for (const PlcEdge &edge : welded.edges) {
        if (two_sided(welded, edge)) {
            for (std::uint32_t s = edge.first; s < edge.last; ++s) {
                ++result.offsets[static_cast<std::size_t>(welded.sides[s].facet) + 1];
            }
        }
    }
    for (std::size_t f = 1; f < result.offsets.size(); ++f) {
        result.offsets[f] += result.offsets[f - 1];
    }
    result.links.resize(result.offsets.back());
    std::vector<std::uint32_t> next(result.offsets.begin(), result.offsets.end() - 1);
    for (const PlcEdge &edge : welded.edges) {
        if (two_sided(welded, edge)) {
            const EdgeSide &a = welded.sides[edge.first];
            const EdgeSide &b = welded.sides[edge.first + 1];
            const bool agrees = a.forward != b.forward;
            result.links[next[static_cast<std::size_t>(a.facet)]++] = {b.facet, agrees};
            result.links[next[static_cast<std::size_t>(b.facet)]++] = {a.facet, agrees};
        }
    }
    return result;
}

// Six times the volume under the facet, seen from a point.
double volume_under(const Welded &welded, std::size_t facet, Vec3 from) {
    double volume = 0;
    for (const auto ring : welded.rings[facet].bounding) {
        for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
            volume += determinant(welded.point(ring[0]) - from, welded.point(ring[k]) - from,
                                  welded.point(ring[k + 1]) - from);
        }
    }
    return volume;
}

void spread(const Welded &welded, const Links &links, std::size_t start, std::int32_t number,
            Surfaces &surfaces) {
    std::vector<std::int32_t> members{static_cast<std::int32_t>(start)};
    surfaces.of_facet[start] = number;
    bool oriented = true;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto f = static_cast<std::size_t>(members[i]);
        for (std::uint32_t l = links.offsets[f]; l < links.offsets[f + 1]; ++l) {
            const auto other = static_cast<std::size_t>(links.links[l].other);
            const bool flipped = surfaces.flipped[f] != !links.links[l].agrees;
            if (surfaces.of_facet[other] < 0) {
                surfaces.of_facet[other] = number;
                surfaces.flipped[other] = flipped;
                turned += flipped ? 1 : 0;
                members.push_back(links.links[l].other);
            } else {
                oriented = oriented && surfaces.flipped[other] == flipped;
            }
        }
    }
    const bool most = 2 * turned > members.size();
    const Vec3 from = welded.planes[start].origin;
    double volume = 0;
    for (const std::int32_t m : members) {
        const auto f = static_cast<std::size_t>(m);
        surfaces.flipped[f] = surfaces.flipped[f] != most;
        volume += (surfaces.flipped[f] ? -1.0 : 1.0) * volume_under(welded, f, from) / 6;
    }
    surfaces.oriented.push_back(oriented);
    surfaces.closed.push_back(true);
    surfaces.volume.push_back(volume);
}

} // namespace

Surfaces surfaces_of(const Welded &welded) {
    Surfaces surfaces;
    const std::size_t count = welded.plc.facet_count();
    surfaces.of_facet.assign(count, -1);
    surfaces.flipped.assign(count, false);
    const Links links = links_of(welded);
    for (std::size_t f = 0; f < count; ++f) {
        if (surfaces.of_facet[f] < 0) {
            spread(welded, links, f, static_cast<std::int32_t>(surfaces.size()), surfaces);
        }
    }
    // A surface that ends at an edge, or that others join there, does not close by itself.
    for (const PlcEdge &edge : welded.edges) {
        if (!two_sided(welded, edge)) {
            for (std::uint32_t s = edge.first; s < edge.last; ++s) {
                if (!welded.sides[s].inner) {
                    const auto f = static_cast<std::size_t>(welded.sides[s].facet);
                    surfaces.closed[static_cast<std::size_t>(surfaces.of_facet[f])] = false;
                }
            }
        }
    }
    return surfaces;
}

int facets_to_outside(const Welded &welded, const BoxTree &tree, Vec3 point,
                      const Surfaces &surfaces, std::int32_t without) {
    Box all;
    for (const Vec3 p : welded.plc.points) {
        all.add(p);
    }
    const double far = 2 * (all.diagonal() + distance(point, all.low));
    // No direction is along an axis or a usual diagonal.
    constexpr std::array<Vec3, 7> directions{{{0.9321, 0.2417, 0.2703},
                                              {-0.9127, 0.3313, -0.2391},
                                              {0.2179, 0.9471, -0.2353},
                                              {-0.2897, -0.9283, 0.2333},
                                              {0.3137, -0.2239, 0.9227},
                                              {0.2213, 0.3079, -0.9253},
                                              {-0.5413, 0.6151, 0.5737}}};
    int fewest = std::numeric_limits<int>::max();
    for (const Vec3 direction : directions) {
        const Vec3 end = point + far * direction;
        Box box;
        box.add(point);
        box.add(end);
        int hits = 0;
        tree.near(box, 0, [&](std::uint32_t facet) {
            if (surfaces.of_facet[facet] == without || welded.degenerate(facet)) {
                return;
            }
            const FacetPlane &plane = welded.planes[facet];
            const bool across = (plane.distance(point) > 0) != (plane.distance(end) > 0);
            if (across &&
                pierce(welded.plc, welded.rings[facet].bounding, point, end) != Where::outside) {
                ++hits;
            }
        });
        fewest = std::min(fewest, hits);
    }
    return fewest;
}

std::vector<bool> inside_out(const Welded &welded, const BoxTree &tree, const Surfaces &surfaces) {
    std::vector<bool> result(surfaces.size(), false);
    std::vector<bool> done(surfaces.size(), false);
    // Every surface would have to be looked for in every other: beyond this many, none is.
    constexpr std::size_t most_surfaces = 2000;
    if (surfaces.size() > most_surfaces) {
        return result;
    }
    for (std::size_t f = 0; f < welded.plc.facet_count(); ++f) {
        const auto s = static_cast<std::size_t>(surfaces.of_facet[f]);
        if (done[s] || welded.rings[f].bounding.empty()) {
            continue;
        }
        done[s] = true;
        if (!surfaces.closed[s] || !surfaces.oriented[s] || surfaces.volume[s] == 0) {
            continue;
        }
        const Vec3 point = welded.point(welded.rings[f].bounding[0][0]);
        const int around =
            facets_to_outside(welded, tree, point, surfaces, static_cast<std::int32_t>(s));
        result[s] = (surfaces.volume[s] > 0) == (around % 2 == 1);
    }
    return result;
}

std::vector<PlcProblem> surface_problems(const Welded &welded, const BoxTree &tree,
                                         std::size_t limit) {
    std::vector<PlcProblem> problems;
    std::size_t count = 0;
    for (const PlcEdge &edge : welded.edges) {
        if (edge.last - edge.first == 1 && !welded.sides[edge.first].inner && count++ < limit) {
            problems.push_back({PlcFault::open_edge,
                                {welded.sides[edge.first].facet},
                                {edge.a, edge.b},
                                0.5 * (welded.point(edge.a) + welded.point(edge.b)),
                                distance(welded.point(edge.a), welded.point(edge.b))});
        }
    }
    const Surfaces surfaces = surfaces_of(welded);
    count = 0;
    for (std::size_t f = 0; f < surfaces.flipped.size(); ++f) {
        if (surfaces.flipped[f] && count++ < limit) {
            problems.push_back({PlcFault::flipped_facet,
                                {static_cast<std::int32_t>(f)},
                                {},
                                welded.planes[f].origin,
                                0});
        }
    }
    const std::vector<bool> wrong = inside_out(welded, tree, surfaces);
    for (std::size_t s = 0; s < wrong.size(); ++s) {
        if (wrong[s]) {
            PlcProblem problem{PlcFault::inside_out, {}, {}, {}, std::abs(surfaces.volume[s])};
            for (std::size_t f = 0; f < surfaces.of_facet.size(); ++f) {
                if (surfaces.of_facet[f] == static_cast<std::int32_t>(s)) {
                    problem.facets.push_back(static_cast<std::int32_t>(f));
                }
            }
            problem.place = welded.planes[static_cast<std::size_t>(problem.facets[0])].origin;
            problems.push_back(std::move(problem));
        }
    }
    const auto add_outside = [&](PlcFault fault, std::size_t number, Vec3 point) {
        if (facets_to_outside(welded, tree, point, surfaces) == 0) {
            problems.push_back({fault, {}, {static_cast<std::int32_t>(number)}, point, 0});
        }
    };
    for (std::size_t h = 0; h < welded.plc.holes.size(); ++h) {
        add_outside(PlcFault::hole_outside, h, welded.plc.holes[h]);
    }
    for (std::size_t r = 0; r < welded.plc.regions.size(); ++r) {
        add_outside(PlcFault::region_outside, r, welded.plc.regions[r].point);
    }
    return problems;
}

} // namespace nmgs
