// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/metric.h"

#include "nmgs/support/error.h"

#include <string>

namespace nmgs {
namespace {

constexpr MetricRow rows[] = {
    {Metric::scaled_jacobian, "scaled_jacobian", true},
    {Metric::shape, "shape", true},
    {Metric::aspect_ratio, "aspect_ratio", false},
    {Metric::edge_ratio, "edge_ratio", false},
    {Metric::skew, "skew", false},
    {Metric::warpage, "warpage", false},
    {Metric::min_angle, "min_angle", true},
    {Metric::max_angle, "max_angle", false},
    {Metric::radius_edge_ratio, "radius_edge_ratio", false},
    {Metric::length, "length", true},
    {Metric::area, "area", true},
    {Metric::volume, "volume", true},
    {Metric::min_jacobian, "min_jacobian", true},
    {Metric::jacobian_ratio, "jacobian_ratio", true},
};

} // namespace

std::span<const MetricRow> metrics() {
    return rows;
}

Metric metric_of(std::string_view name) {
    std::string known;
    for (const MetricRow &row : rows) {
        if (row.name == name) {
            return row.metric;
        }
        known += (known.empty() ? "" : ", ") + std::string(row.name);
    }
    throw ArgumentError("metric: no such metric '" + std::string(name) + "'; known: " + known);
}

} // namespace nmgs
