// SPDX-License-Identifier: LGPL-2.1-or-later
// A piecewise linear complex: planar facets that bound a volume (Miller, Talmor, Teng, Walkington,
// Wang 1996), as TetGen understands it. All numbers are 0-based.
#pragma once

#include "nmgs/support/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

// A point inside a part of the volume, its attribute, and its largest element volume (below 0:
// none).
struct PlcRegion {
    Vec3 point;
    double attribute;
    double volume;
};
static_assert(sizeof(PlcRegion) == 5 * sizeof(double));

// A facet is one or more polygons in one plane: the outer one, those round its holes, and segments
// or single points inside (polygons of two nodes or one). Facet f has the polygons
// facet_offsets[f] to facet_offsets[f + 1], polygon p the nodes polygon_offsets[p] to
// polygon_offsets[p + 1] of polygon_nodes.
struct Plc {
    std::vector<Vec3> points;
    std::vector<std::int32_t> point_markers; // one a point, or none
    std::vector<double> point_attributes;    // attribute_count a point
    std::int32_t attribute_count = 0;

    std::vector<std::int32_t> polygon_nodes;
    std::vector<std::int64_t> polygon_offsets{0};
    std::vector<std::int64_t> facet_offsets{0};
    std::vector<std::int32_t> facet_markers; // one a facet, or none
    std::vector<Vec3> facet_holes;           // a point in each hole of each facet
    std::vector<std::int64_t> facet_hole_offsets{0};

    std::vector<Vec3> holes;
    std::vector<PlcRegion> regions;

    [[nodiscard]] std::size_t facet_count() const { return facet_offsets.size() - 1; }
    // Closes the polygon whose nodes were appended to polygon_nodes.
    void end_polygon() {
        polygon_offsets.push_back(static_cast<std::int64_t>(polygon_nodes.size()));
    }
    // Closes the facet whose polygons (and holes) were appended.
    void end_facet() {
        facet_offsets.push_back(static_cast<std::int64_t>(polygon_offsets.size()) - 1);
        facet_hole_offsets.push_back(static_cast<std::int64_t>(facet_holes.size()));
    }
};

} // namespace nmgs
