// SPDX-License-Identifier: LGPL-2.1-or-later
// Names of the quality metrics and what each is worth.
#pragma once

#include <span>
#include <string_view>

namespace nmgs {

enum class Metric {
    scaled_jacobian,
    shape,
    aspect_ratio,
    edge_ratio,
    skew,
    warpage,
    min_angle,
    max_angle,
    radius_edge_ratio,
    length,
    area,
    volume,
    min_jacobian,
    jacobian_ratio,
};

struct MetricRow {
    Metric metric;
    std::string_view name;
    bool larger_is_better;
};

// All metrics, in the order of the enumeration.
std::span<const MetricRow> metrics();
// Raises ArgumentError that lists the known names when no metric has this one.
Metric metric_of(std::string_view name);

} // namespace nmgs
