# SPDX-License-Identifier: LGPL-2.1-or-later
"""What Results > Analysis shows of a mesh: counts, bounds, size, quality, worst elements."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Tuple

import numpy as np

from . import _kernel

if TYPE_CHECKING:
    from .mesh import Mesh

#: The metrics of a report; of each cell type those that are defined for it.
METRICS: Tuple[str, ...] = (
    "scaled_jacobian",
    "shape",
    "aspect_ratio",
    "skew",
    "warpage",
    "min_angle",
    "max_angle",
    "radius_edge_ratio",
    "min_jacobian",
    "jacobian_ratio",
)
#: Histogram ranges of the metrics that have one by definition.
_RANGES = {
    "scaled_jacobian": (0.0, 1.0),
    "shape": (0.0, 1.0),
    "skew": (0.0, 1.0),
    "jacobian_ratio": (0.0, 1.0),
}


@dataclass
class MetricSummary:
    """One metric of the cells of one type. worst_cells: int32 (K,), the worst first;
    worst_values (K,); worst_places (K, 3), the means of the cells' nodes. histogram: int64 (bins,)
    over edges (bins + 1,). mean and histogram leave out the `infinite` cells without a finite value
    (flat ones, for ratios)."""

    metric: str
    cell_type: str
    worst: float
    best: float
    mean: float
    histogram: np.ndarray
    edges: np.ndarray
    infinite: int
    worst_cells: np.ndarray
    worst_values: np.ndarray
    worst_places: np.ndarray


@dataclass
class Report:
    """counts: "points" and each cell type. bounds: (2, 3), lowest and highest coordinates. length:
    of the line cells; area: of the surface cells, or of the outer faces where there are volume
    cells; volume: of the volume cells. groups: name -> (cell type or "node", size).
    metrics: cell type -> metric -> MetricSummary. str(report) is the table to read."""

    counts: Dict[str, int]
    bounds: np.ndarray
    length: float
    area: float
    volume: float
    groups: Dict[str, Tuple[str, int]] = field(default_factory=dict)
    metrics: Dict[str, Dict[str, MetricSummary]] = field(default_factory=dict)

    def __str__(self) -> str:
        lines = ["Counts"]
        lines += [f"  {name:<20} {count}" for name, count in self.counts.items()]
        if self.counts["points"]:
            lines.append("Bounds")
            for axis, low, high in zip("xyz", *self.bounds):
                lines.append(f"  {axis:<20} {low:.6g} to {high:.6g}")
        lines.append("Size")
        for name in ("length", "area", "volume"):
            if getattr(self, name):
                lines.append(f"  {name:<20} {getattr(self, name):.9g}")
        if self.groups:
            lines.append("Groups")
            lines += [f"  {k:<20} {size} {kind}" for k, (kind, size) in self.groups.items()]
        for cell_type, summaries in self.metrics.items():
            lines.append(f"Quality of {cell_type}")
            lines.append(f"  {'':<20} {'worst':>12} {'mean':>12} {'best':>12}   worst cell at")
            for s in summaries.values():
                place = ""
                if len(s.worst_cells):
                    x, y, z = s.worst_places[0]
                    place = f"{s.worst_cells[0]} ({x:.6g}, {y:.6g}, {z:.6g})"
                lines.append(
                    f"  {s.metric:<20} {s.worst:>12.6g} {s.mean:>12.6g} {s.best:>12.6g}   {place}"
                )
            for s in summaries.values():
                if s.metric == "scaled_jacobian":
                    lines.append("  histogram of scaled_jacobian")
                    for low, high, count in zip(s.edges, s.edges[1:], s.histogram):
                        lines.append(f"    {low:6.2f} to {high:6.2f} {count:>12}")
        return "\n".join(lines)


def _summary(
    mesh: "Mesh",
    cell_type: str,
    metric: str,
    values: np.ndarray,
    larger: bool,
    bins: int,
    worst: int,
) -> MetricSummary:
    badness = -values if larger else values
    count = min(worst, len(values))
    # Ties go to the lower cell number, so that the answer does not depend on the sort.
    if count < len(values):
        limit = np.partition(badness, len(values) - count)[len(values) - count]
        candidates = np.flatnonzero(badness >= limit)
    else:
        candidates = np.arange(len(values))
    order = candidates[np.argsort(-badness[candidates], kind="stable")][:count]
    finite = values[np.isfinite(values)]
    low, high = _RANGES.get(metric, (0.0, 0.0))
    if len(finite):
        low, high = min(low, finite.min()), max(high, finite.max())
        if metric not in _RANGES:
            low = finite.min()
            # Values that differ by rounding only leave no room for the bins.
            if high - low <= 1e-9 * max(abs(low), abs(high)):
                low, high = low - 0.5, high + 0.5
    histogram, edges = np.histogram(finite, bins=bins, range=(low, high))
    nodes = mesh.cells[cell_type][order]
    return MetricSummary(
        metric=metric,
        cell_type=cell_type,
        worst=float(values[order[0]]) if count else float("nan"),
        best=float(values.max() if larger else values.min()) if count else float("nan"),
        mean=float(finite.mean()) if len(finite) else float("nan"),
        histogram=histogram,
        edges=edges,
        infinite=len(values) - len(finite),
        worst_cells=order.astype(np.int32),
        worst_values=values[order],
        worst_places=mesh.points[nodes].mean(axis=1) if count else np.zeros((0, 3)),
    )


def report(
    mesh: "Mesh", bins: int = 10, worst: int = 10, progress: Optional[Callable[[float], Any]] = None
) -> Report:
    """See Mesh.report."""
    if bins < 1:
        raise ValueError(f"bins: expected 1 or more, got {bins!r}")
    if worst < 0:
        raise ValueError(f"worst: expected 0 or more, got {worst!r}")
    from .mesh import CELL_TYPES  # only here: mesh.py imports this module's function

    kernel = _kernel.core()
    larger = kernel.metrics()

    def values(metric: str, of: "Mesh") -> Dict[str, np.ndarray]:
        return kernel.quality(of.points, of.cells, metric, progress)

    def total(metric: str, of: "Mesh") -> float:
        return float(sum(v.sum() for v in values(metric, of).values()))

    solid = any(CELL_TYPES[name][1] == 3 and len(nodes) for name, nodes in mesh.cells.items())
    result = Report(
        counts={"points": len(mesh.points), **{k: len(v) for k, v in mesh.cells.items()}},
        bounds=(
            np.array([mesh.points.min(axis=0), mesh.points.max(axis=0)])
            if len(mesh.points)
            else np.zeros((2, 3))
        ),
        length=total("length", mesh),
        area=total("area", mesh.boundary() if solid else mesh),
        volume=total("volume", mesh),
        groups={name: (kind, len(indices)) for name, (kind, indices) in mesh.groups.items()},
    )
    for metric in METRICS:
        for cell_type, of_cells in values(metric, mesh).items():
            if len(of_cells):
                summary = _summary(mesh, cell_type, metric, of_cells, larger[metric], bins, worst)
                result.metrics.setdefault(cell_type, {})[metric] = summary
    return result
