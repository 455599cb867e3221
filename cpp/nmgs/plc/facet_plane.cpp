// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/plc/facet_plane.h"

#include "nmgs/support/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nmgs {
namespace {

double coordinate(Vec3 p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

std::span<const std::int32_t> polygon(const Plc &plc, std::int64_t p) {
    const auto at = static_cast<std::size_t>(p);
    const auto first = static_cast<std::size_t>(plc.polygon_offsets[at]);
    const auto last = static_cast<std::size_t>(plc.polygon_offsets[at + 1]);
    return {plc.polygon_nodes.data() + first, last - first};
}

Vec3 point(const Plc &plc, std::int32_t node) {
    return plc.points[static_cast<std::size_t>(node)];
}

} // namespace

FacetPlane facet_plane(const Plc &plc, std::size_t facet) {
    FacetPlane plane;
    const std::int64_t first = plc.facet_offsets[facet];
    const std::int64_t last = plc.facet_offsets[facet + 1];
    if (first == last || polygon(plc, first).empty()) {
        return plane;
    }
    const auto outer = polygon(plc, first);
    Box box;
    Vec3 middle{0, 0, 0};
    for (const std::int32_t node : outer) {
        box.add(point(plc, node));
        middle += (1.0 / static_cast<double>(outer.size())) * point(plc, node);
    }
    plane.origin = middle;
    const Vec3 extent = box.high - box.low;
    plane.size = std::max({extent.x, extent.y, extent.z});
    Vec3 normal{0, 0, 0};
    for (std::size_t k = 0; k < outer.size(); ++k) {
        normal += cross(point(plc, outer[k]) - middle,
                        point(plc, outer[(k + 1) % outer.size()]) - middle);
    }
    const double length = norm(normal);
    plane.area = 0.5 * length;
    if (length == 0) {
        return plane;
    }
    plane.normal = (1 / length) * normal;
    const Vec3 n = plane.normal;
    const Vec3 a{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    plane.u = (axis + 1) % 3;
    plane.v = (axis + 2) % 3;
    if (coordinate(n, axis) < 0) {
        std::swap(plane.u, plane.v);
    }
    for (std::int64_t p = first; p < last; ++p) {
        for (const std::int32_t node : polygon(plc, p)) {
            plane.off = std::max(plane.off, std::abs(plane.distance(point(plc, node))));
        }
    }
    return plane;
}

FacetRings facet_rings(const Plc &plc, std::size_t facet, const FacetPlane &plane) {
    FacetRings rings;
    const std::int64_t first = plc.facet_offsets[facet];
    for (std::int64_t p = first; p < plc.facet_offsets[facet + 1]; ++p) {
        const auto nodes = polygon(plc, p);
        if (nodes.size() < 3) {
            continue;
        }
        bool bounds = p == first;
        for (std::int64_t h = plc.facet_hole_offsets[facet];
             !bounds && h < plc.facet_hole_offsets[facet + 1]; ++h) {
            bounds = locate(plc, {nodes}, plane, plc.facet_holes[static_cast<std::size_t>(h)]) ==
                     Where::inside;
        }
        (bounds ? rings.bounding : rings.inner).push_back(nodes);
    }
    return rings;
}

Where locate(const Plc &plc, const std::vector<std::span<const std::int32_t>> &rings,
             const FacetPlane &plane, Vec3 place) {
    const double x = coordinate(place, plane.u);
    const double y = coordinate(place, plane.v);
    bool inside = false;
    for (const auto ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec3 a = point(plc, ring[k]);
            const Vec3 b = point(plc, ring[(k + 1) % ring.size()]);
            const double ax = coordinate(a, plane.u);
            const double ay = coordinate(a, plane.v);
            const double bx = coordinate(b, plane.u);
            const double by = coordinate(b, plane.v);
            if (std::max(ay, by) < y || std::min(ay, by) > y || std::max(ax, bx) < x) {
                continue;
            }
            const int side = orient2d(ax, ay, bx, by, x, y);
            if (side == 0 && std::min(ax, bx) <= x && x <= std::max(ax, bx)) {
                return Where::boundary;
            }
            if ((ay > y) != (by > y) && (side > 0) == (by > ay)) {
                inside = !inside;
            }
        }
    }
    return inside ? Where::inside : Where::outside;
}

// Counts the polygons' edges that cross a half-plane bounded by the line: that is the point in
// polygon test seen along the line, and every decision in it is the sign of a determinant.
Where pierce(const Plc &plc, const std::vector<std::span<const std::int32_t>> &rings, Vec3 p,
             Vec3 q) {
    const Vec3 d = q - p;
    const Vec3 a{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    const double length = a.x + a.y + a.z;
    Vec3 r = p; // off the line: along the coordinate that changes least
    (a.x <= a.y && a.x <= a.z ? r.x : a.y <= a.z ? r.y : r.z) += length;
    bool inside = false;
    for (const auto ring : rings) {
        int last = orient3d(p, q, r, point(plc, ring.back()));
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec3 u = point(plc, ring[(k + ring.size() - 1) % ring.size()]);
            const Vec3 v = point(plc, ring[k]);
            const int here = orient3d(p, q, r, v);
            if ((last >= 0) != (here >= 0)) {
                const int turn = orient3d(p, q, u, v);
                if (turn == 0) {
                    return Where::boundary;
                }
                if ((turn > 0) == (here >= 0)) {
                    inside = !inside;
                }
            } else if (last == 0 && here == 0 && orient3d(p, q, u, v) == 0) {
                // The edge is in the half-plane's plane: does the line meet it?
                const double s = dot(u - p, r - p) * norm2(d) - dot(u - p, d) * dot(r - p, d);
                const double t = dot(v - p, r - p) * norm2(d) - dot(v - p, d) * dot(r - p, d);
                if ((s <= 0 && t >= 0) || (s >= 0 && t <= 0)) {
                    return Where::boundary;
                }
            }
            last = here;
        }
    }
    return inside ? Where::inside : Where::outside;
}

} // namespace nmgs
