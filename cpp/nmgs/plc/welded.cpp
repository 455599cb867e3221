// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/plc/welded.h"

#include "nmgs/mesh/point_hash.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace nmgs {
namespace {

struct RawSide {
    std::int32_t a, b;
    EdgeSide side;
};

void add_polygon(std::vector<RawSide> &raw, std::span<const std::int32_t> nodes, std::int32_t facet,
                 bool inner) {
    const std::size_t edges = nodes.size() == 2 ? 1 : nodes.size();
    for (std::size_t k = 0; k < edges; ++k) {
        const std::int32_t a = nodes[k];
        const std::int32_t b = nodes[(k + 1) % nodes.size()];
        if (a != b) {
            raw.push_back({std::min(a, b), std::max(a, b), {facet, a < b, inner}});
        }
    }
}

} // namespace

std::vector<std::int32_t> first_of_equal(const std::vector<Vec3> &points, double tolerance) {
    std::vector<std::int32_t> first(points.size());
    PointHash hash(tolerance > 0 ? tolerance : 1e-300);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::int64_t found = hash.find(points[i]);
        first[i] = static_cast<std::int32_t>(found < 0 ? static_cast<std::int64_t>(i) : found);
        if (found < 0) {
            hash.insert(points[i], static_cast<std::int64_t>(i));
        }
    }
    return first;
}

Welded::Welded(const Plc &source, double tolerance_, const Progress &progress)
    : plc(source), tolerance(tolerance_), first(first_of_equal(source.points, tolerance_)) {
    poll(progress, 0.05);
    for (std::int32_t &node : plc.polygon_nodes) {
        node = first[static_cast<std::size_t>(node)];
    }
    std::vector<RawSide> raw;
    raw.reserve(plc.polygon_nodes.size());
    const std::size_t count = plc.facet_count();
    planes.reserve(count);
    rings.reserve(count);
    for (std::size_t f = 0; f < count; ++f) {
        if (f % 4096 == 0) {
            poll(progress, 0.05 + 0.15 * static_cast<double>(f) / static_cast<double>(count));
        }
        planes.push_back(facet_plane(plc, f));
        rings.push_back(facet_rings(plc, f, planes.back()));
        const auto facet = static_cast<std::int32_t>(f);
        for (const auto ring : rings.back().bounding) {
            add_polygon(raw, ring, facet, false);
        }
        for (const auto ring : rings.back().inner) {
            add_polygon(raw, ring, facet, true);
        }
        for (std::int64_t p = plc.facet_offsets[f]; p < plc.facet_offsets[f + 1]; ++p) {
            const auto begin =
                static_cast<std::size_t>(plc.polygon_offsets[static_cast<std::size_t>(p)]);
            const auto end =
                static_cast<std::size_t>(plc.polygon_offsets[static_cast<std::size_t>(p) + 1]);
            if (end - begin == 2) {
                add_polygon(raw, {plc.polygon_nodes.data() + begin, 2}, facet, true);
            }
        }
    }
    std::sort(raw.begin(), raw.end(), [](const RawSide &x, const RawSide &y) {
        return std::tie(x.a, x.b, x.side.facet, x.side.forward) <
               std::tie(y.a, y.b, y.side.facet, y.side.forward);
    });
    sides.reserve(raw.size());
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (i == 0 || raw[i].a != raw[i - 1].a || raw[i].b != raw[i - 1].b) {
            const auto at = static_cast<std::uint32_t>(i);
            edges.push_back({raw[i].a, raw[i].b, at, at});
        }
        sides.push_back(raw[i].side);
        edges.back().last = static_cast<std::uint32_t>(i) + 1;
    }
    poll(progress, 0.25);
}

Box Welded::box(std::size_t facet) const {
    Box box;
    for (const auto ring : rings[facet].bounding) {
        for (const std::int32_t node : ring) {
            box.add(point(node));
        }
    }
    return box;
}

} // namespace nmgs
