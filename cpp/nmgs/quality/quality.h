// SPDX-License-Identifier: LGPL-2.1-or-later
// A quality metric of every cell of a mesh.
#pragma once

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/quality/metric.h"
#include "nmgs/support/progress.h"

#include <span>

namespace nmgs {

// Whether the metric is defined for cells of the type. min_jacobian and jacobian_ratio are for
// quadratic cells; skew and warpage need quadrilaterals; see surface_metrics.h and
// volume_metrics.h.
bool has_metric(CellType type, Metric metric);

// One value a cell. Of quadratic cells, scaled_jacobian, min_jacobian, jacobian_ratio, length, area
// and volume are those of the curved cell (see curved_metrics.h), the others those of the linear
// cell with its corners; of pyramid13 and wedge15 all are the linear cell's. Raises ArgumentError
// when the metric is not defined for the type, or a node is not in [0, points.size()).
Array<double> quality(std::span<const Vec3> points, const CellView &cells, Metric metric,
                      const Progress &progress = {});

} // namespace nmgs
