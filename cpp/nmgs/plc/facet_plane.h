// SPDX-License-Identifier: LGPL-2.1-or-later
// The plane of a facet, and which points and segments lie in the facet.
#pragma once

#include "nmgs/plc/plc.h"

#include <span>

namespace nmgs {

// The polygons of a facet with three nodes and more. Polygons within the outer one that do not
// bound a hole are no part of it: the facet goes on behind them.
struct FacetRings {
    std::vector<std::span<const std::int32_t>> bounding;
    std::vector<std::span<const std::int32_t>> inner;
};

struct FacetPlane {
    Vec3 origin{};
    Vec3 normal{};   // of length 1; 0 for a facet without area
    double area = 0; // of its outer polygon
    double size = 0; // largest extent
    double off = 0;  // largest distance of a node from the plane
    // The two coordinates that are left when the largest of the normal's is dropped, so that a
    // counter-clockwise polygon stays so.
    int u = 0;
    int v = 1;
    [[nodiscard]] double distance(Vec3 p) const { return dot(normal, p - origin); }
};

// Newell's normal of the outer polygon.
FacetPlane facet_plane(const Plc &plc, std::size_t facet);

// How the facet's polygons bound it. Needs its plane.
FacetRings facet_rings(const Plc &plc, std::size_t facet, const FacetPlane &plane);

enum class Where { outside, boundary, inside };

// Where a point of the plane lies in the area that the rings bound, exact in the projection.
Where locate(const Plc &plc, const std::vector<std::span<const std::int32_t>> &rings,
             const FacetPlane &plane, Vec3 point);

// Whether the line through p and q goes through the area that the rings bound, exact.
Where pierce(const Plc &plc, const std::vector<std::span<const std::int32_t>> &rings, Vec3 p,
             Vec3 q);

} // namespace nmgs
