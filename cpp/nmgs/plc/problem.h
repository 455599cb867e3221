// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "nmgs/support/vec3.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace nmgs {

// What can be wrong with a PLC before it is meshed.
enum class PlcFault {
    duplicate_point,  // points: the later one, the first one
    degenerate_facet, // a facet without area
    duplicate_facet,  // facets: the later one, the first one
    nonplanar_facet,  // amount: how far its points are off the plane
    crossing_facets,  // facets: two that meet where neither has an edge or a point of the other
    open_edge,        // points: an edge that bounds one facet only
    flipped_facet,    // two facets at an edge are oriented against each other
    inside_out,       // a closed surface whose normals point into it
    hole_outside,     // points: the number of the hole
    region_outside,   // points: the number of the region
};

// The name as Python knows it, for example "crossing_facets".
std::string_view name(PlcFault fault);

struct PlcProblem {
    PlcFault fault;
    std::vector<std::int32_t> facets; // 0-based
    std::vector<std::int32_t> points; // 0-based
    Vec3 place;                       // where
    double amount = 0;                // in the model's unit of length
};

} // namespace nmgs
