// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/quality.h"

#include "nmgs/quality/curved_metrics.h"
#include "nmgs/quality/surface_metrics.h"
#include "nmgs/quality/volume_metrics.h"
#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace nmgs {
namespace {

using OfCell = double (*)(const Vec3 *);

double line_length(const Vec3 *p) {
    return distance(p[0], p[1]);
}

template <CellType type>
double edge_ratio(const Vec3 *p) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const LocalEdge &edge : edges(type)) {
        const double length = norm2(p[edge.a] - p[edge.b]);
        least = std::min(least, length);
        most = std::max(most, length);
    }
    return least > 0 ? std::sqrt(most / least) : std::numeric_limits<double>::infinity();
}

template <CellType type>
double solid_volume(const Vec3 *p) {
    return solid::volume(type, p);
}
template <CellType type>
double solid_min_angle(const Vec3 *p) {
    return solid::min_angle(type, p);
}
template <CellType type>
double solid_max_angle(const Vec3 *p) {
    return solid::max_angle(type, p);
}
template <CellType type>
double solid_warpage(const Vec3 *p) {
    return solid::warpage(type, p);
}

template <CellType type>
OfCell solid_metric(Metric metric) {
    switch (metric) {
    case Metric::edge_ratio:
        return edge_ratio<type>;
    case Metric::volume:
        return solid_volume<type>;
    case Metric::min_angle:
        return solid_min_angle<type>;
    case Metric::max_angle:
        return solid_max_angle<type>;
    case Metric::warpage:
        return type == CellType::tetra ? nullptr : solid_warpage<type>;
    default:
        return nullptr;
    }
}

OfCell triangle_metric(Metric metric) {
    switch (metric) {
    case Metric::area:
        return triangle::area;
    case Metric::scaled_jacobian:
        return triangle::scaled_jacobian;
    case Metric::shape:
        return triangle::shape;
    case Metric::aspect_ratio:
        return triangle::aspect_ratio;
    case Metric::edge_ratio:
        return edge_ratio<CellType::triangle>;
    case Metric::min_angle:
        return triangle::min_angle;
    case Metric::max_angle:
        return triangle::max_angle;
    case Metric::radius_edge_ratio:
        return triangle::radius_edge_ratio;
    default:
        return nullptr;
    }
}

OfCell quad_metric(Metric metric) {
    switch (metric) {
    case Metric::area:
        return quad::area;
    case Metric::scaled_jacobian:
        return quad::scaled_jacobian;
    case Metric::shape:
        return quad::shape;
    case Metric::aspect_ratio:
        return quad::aspect_ratio;
    case Metric::edge_ratio:
        return edge_ratio<CellType::quad>;
    case Metric::skew:
        return quad::skew;
    case Metric::warpage:
        return quad::warpage;
    case Metric::min_angle:
        return quad::min_angle;
    case Metric::max_angle:
        return quad::max_angle;
    default:
        return nullptr;
    }
}

OfCell tetra_metric(Metric metric) {
    switch (metric) {
    case Metric::volume:
        return tetra::volume;
    case Metric::scaled_jacobian:
        return tetra::scaled_jacobian;
    case Metric::shape:
        return tetra::shape;
    case Metric::aspect_ratio:
        return tetra::aspect_ratio;
    case Metric::radius_edge_ratio:
        return tetra::radius_edge_ratio;
    default:
        return solid_metric<CellType::tetra>(metric);
    }
}

OfCell hexahedron_metric(Metric metric) {
    switch (metric) {
    case Metric::scaled_jacobian:
        return hexahedron::scaled_jacobian;
    case Metric::shape:
        return hexahedron::shape;
    case Metric::aspect_ratio:
        return hexahedron::aspect_ratio;
    case Metric::skew:
        return hexahedron::skew;
    default:
        return solid_metric<CellType::hexahedron>(metric);
    }
}

// Of the linear cell with the corners of the type; none where the metric is not defined.
OfCell linear_metric(CellType type, Metric metric) {
    switch (linear_type(type)) {
    case CellType::line:
        return metric == Metric::length ? line_length : nullptr;
    case CellType::triangle:
        return triangle_metric(metric);
    case CellType::quad:
        return quad_metric(metric);
    case CellType::tetra:
        return tetra_metric(metric);
    case CellType::pyramid:
        return metric == Metric::scaled_jacobian ? pyramid::scaled_jacobian
                                                 : solid_metric<CellType::pyramid>(metric);
    case CellType::wedge:
        return metric == Metric::scaled_jacobian ? wedge::scaled_jacobian
                                                 : solid_metric<CellType::wedge>(metric);
    default:
        return hexahedron_metric(metric);
    }
}

template <CellType type>
OfCell curved_metric(Metric metric) {
    switch (metric) {
    case Metric::scaled_jacobian:
        return [](const Vec3 *p) { return curved::scaled_jacobian(type, p); };
    case Metric::min_jacobian:
        return [](const Vec3 *p) { return curved::min_jacobian(type, p); };
    case Metric::jacobian_ratio:
        return [](const Vec3 *p) { return curved::jacobian_ratio(type, p); };
    case Metric::area:
        return dimension(type) == 2 ? [](const Vec3 *p) { return curved::area(type, p); }
                                    : OfCell();
    case Metric::volume:
        return dimension(type) == 3 ? [](const Vec3 *p) { return curved::volume(type, p); }
                                    : OfCell();
    default:
        return linear_metric(type, metric);
    }
}

OfCell metric_for(CellType type, Metric metric) {
    switch (type) {
    case CellType::line3:
        return metric == Metric::length ? curved::length : nullptr;
    case CellType::triangle6:
        return curved_metric<CellType::triangle6>(metric);
    case CellType::quad8:
        return curved_metric<CellType::quad8>(metric);
    case CellType::tetra10:
        return curved_metric<CellType::tetra10>(metric);
    case CellType::hexahedron20:
        return curved_metric<CellType::hexahedron20>(metric);
    default:
        return linear_metric(type, metric);
    }
}

} // namespace

bool has_metric(CellType type, Metric metric) {
    return metric_for(type, metric) != nullptr;
}

Array<double> quality(std::span<const Vec3> points, const CellView &cells, Metric metric,
                      const Progress &progress) {
    check_nodes({&cells, 1}, points.size());
    const OfCell of_cell = metric_for(cells.type, metric);
    if (of_cell == nullptr) {
        throw ArgumentError(
            "metric: " + std::string(metrics()[static_cast<std::size_t>(metric)].name) +
            " is not defined for cells of type " + std::string(name(cells.type)));
    }
    const auto k = static_cast<std::size_t>(node_count(cells.type));
    Array<double> values(cells.size());
    parallel_for(
        cells.size(), is_quadratic(cells.type) ? 64 : 1 << 12,
        [&](std::size_t first, std::size_t last) {
            std::array<Vec3, 20> p{};
            for (std::size_t c = first; c < last; ++c) {
                for (std::size_t i = 0; i < k; ++i) {
                    p[i] = points[static_cast<std::size_t>(cells.nodes[c * k + i])];
                }
                values[c] = of_cell(p.data());
            }
        },
        progress);
    return values;
}

} // namespace nmgs
