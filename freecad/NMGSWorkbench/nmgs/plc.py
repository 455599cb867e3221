# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLC: a piecewise linear complex (Miller et al. 1996), TetGen's input.

A facet is one or more polygons in one plane: an outer one, those that bound its holes, and
segments or single points inside it (polygons of two nodes or one). All arrays are flat, with
offsets: facet f has the polygons facet_offsets[f] to facet_offsets[f + 1], polygon p the nodes
polygon_nodes[polygon_offsets[p]:polygon_offsets[p + 1]].
"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _kernel
from .plc_problem import PLCProblem, problems_of

Facets = Any  # (F, k) array; or per facet a polygon, or a list of polygons


def _points(values: Any, argument: str) -> np.ndarray:
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.size == 0:
        return np.empty((0, 3))
    if array.ndim == 1 and array.size == 3:
        array = array[None, :]
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{argument}: expected shape (N, 3), got {array.shape}")
    if not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0][0])
        raise ValueError(f"{argument}: row {row} is not finite: {array[row].tolist()}")
    return array


def _ints(values: Any, argument: str, count: int) -> Optional[np.ndarray]:
    if values is None:
        return None
    array = np.asarray(values)
    if array.ndim != 1 or len(array) != count or (array.size and array.dtype.kind not in "iu"):
        raise ValueError(f"{argument}: expected {count} whole numbers, got shape {array.shape}")
    return np.ascontiguousarray(array, dtype=np.int32)


def _table(values: Any, argument: str, rows: Optional[int], columns: Sequence[int]) -> np.ndarray:
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.ndim == 1 and rows is not None and len(array) == rows:
        array = array[:, None]
    if array.size == 0:
        return np.empty((0, columns[0] if columns else 1))
    if array.ndim != 2 or (rows is not None and len(array) != rows):
        raise ValueError(f"{argument}: expected {rows} rows, got shape {array.shape}")
    if columns and array.shape[1] not in columns:
        raise ValueError(f"{argument}: expected {columns} columns, got {array.shape[1]}")
    if not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0][0])
        raise ValueError(f"{argument}: row {row} is not finite: {array[row].tolist()}")
    return array


def _flatten(facets: Facets) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """polygon_nodes, polygon_offsets, facet_offsets of any of the accepted forms."""
    if isinstance(facets, np.ndarray) and facets.ndim == 2:
        count, corners = facets.shape
        return (
            np.ascontiguousarray(facets, dtype=np.int32).reshape(-1),
            np.arange(count + 1, dtype=np.int64) * corners,
            np.arange(count + 1, dtype=np.int64),
        )
    nodes: List[int] = []
    polygon_offsets = [0]
    facet_offsets = [0]
    for number, facet in enumerate(facets):
        rings = facet if len(facet) and np.ndim(facet[0]) == 1 else [facet]
        for ring in rings:
            row = np.asarray(ring)
            if row.ndim != 1 or row.size == 0 or row.dtype.kind not in "iu":
                raise ValueError(f"facets: facet {number} has a polygon that is no list of nodes")
            nodes.extend(int(n) for n in row)
            polygon_offsets.append(len(nodes))
        facet_offsets.append(len(polygon_offsets) - 1)
    return (
        np.array(nodes, np.int32),
        np.array(polygon_offsets, np.int64),
        np.array(facet_offsets, np.int64),
    )


class PLC:
    """Points and planar facets that bound a volume.

    points: float64 (N, 3). facets: (F, k) int array, or per facet the 0-based nodes of its polygon
    or a list of such polygons. holes: (H, 3), a point inside each cavity. regions: (R, 4 | 5), a
    point inside each region, its attribute, and its largest element volume (below 0: none).
    markers: int per facet. facet_holes: facet -> (h, 3) points in the holes of that facet.
    point_markers: int per point. point_attributes: (N, k). point_sizes: wanted edge length at each
    point, for -m; below or equal 0: none. facet_constraints: (C, 2) marker, largest area of a
    boundary triangle. segment_constraints: (C, 3) two nodes, largest edge length. edges: (E, 2)
    further segments, with edge_markers. groups: name -> facet markers that belong to it.
    region_groups: name -> region attributes. Raises ValueError that names the argument and row.
    """

    def __init__(
        self,
        points: Any,
        facets: Facets,
        holes: Any = (),
        regions: Any = (),
        *,
        markers: Any = None,
        facet_holes: Optional[Mapping[int, Any]] = None,
        point_markers: Any = None,
        point_attributes: Any = None,
        point_sizes: Any = None,
        facet_constraints: Any = (),
        segment_constraints: Any = (),
        edges: Any = None,
        edge_markers: Any = None,
        groups: Optional[Mapping[str, Sequence[int]]] = None,
        region_groups: Optional[Mapping[str, Sequence[float]]] = None,
    ):
        self.points = _points(points, "points")
        count = len(self.points)
        self.polygon_nodes, self.polygon_offsets, self.facet_offsets = _flatten(facets)
        self._check_nodes()
        self.markers = _ints(markers, "markers", len(self))
        self._set_facet_holes(facet_holes or {})
        self.holes = _points(holes, "holes")
        self.regions = self._checked_regions(regions)
        self.point_markers = _ints(point_markers, "point_markers", count)
        self.point_attributes = (
            None
            if point_attributes is None
            else _table(point_attributes, "point_attributes", count, ())
        )
        self.point_sizes = (
            None if point_sizes is None else _table(point_sizes, "point_sizes", count, (1, 6))
        )
        self.facet_constraints = _table(facet_constraints, "facet_constraints", None, (2,))
        self.segment_constraints = _table(segment_constraints, "segment_constraints", None, (3,))
        self.edges = None if edges is None else self._checked_edges(edges)
        self.edge_markers = (
            None if self.edges is None else _ints(edge_markers, "edge_markers", len(self.edges))
        )
        self.groups: Dict[str, List[int]] = {k: list(v) for k, v in (groups or {}).items()}
        self.region_groups: Dict[str, List[float]] = {
            k: list(v) for k, v in (region_groups or {}).items()
        }
        #: Whether the facets are the triangles of an STL file, each with points of its own, which
        #: TetGen treats in a way of its own.
        self.stl = False
        #: What mend() did, in words.
        self.notes: List[str] = []

    @classmethod
    def of_arrays(cls, arrays: Mapping[str, Any]) -> "PLC":
        """A PLC of the flat arrays themselves, under the names of its attributes."""
        plc = cls(arrays["points"], ())
        plc.polygon_nodes = np.ascontiguousarray(arrays["polygon_nodes"], dtype=np.int32)
        plc.polygon_offsets = np.ascontiguousarray(arrays["polygon_offsets"], dtype=np.int64)
        plc.facet_offsets = np.ascontiguousarray(arrays["facet_offsets"], dtype=np.int64)
        plc.facet_hole_offsets = np.zeros(len(plc) + 1, np.int64)
        plc._check_nodes()
        for name in ("facet_holes", "facet_hole_offsets", "holes", "regions"):
            if arrays.get(name) is not None:
                setattr(plc, name, np.ascontiguousarray(arrays[name]))
        plc.markers = _ints(arrays.get("markers"), "markers", len(plc))
        plc.point_markers = _ints(arrays.get("point_markers"), "point_markers", len(plc.points))
        plc.point_attributes = arrays.get("point_attributes")
        return plc

    def __len__(self) -> int:
        """Number of facets."""
        return len(self.facet_offsets) - 1

    def __repr__(self) -> str:
        return (
            f"<nmgs.PLC: {len(self.points)} points, {len(self)} facets, "
            f"{len(self.holes)} holes, {len(self.regions)} regions>"
        )

    def check(
        self,
        tolerance: Optional[float] = None,
        planarity: float = 1e-6,
        limit: int = 1000,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> List[PLCProblem]:
        """What is wrong before meshing: which facets and points, and where.

        tolerance: points nearer than this are one, and lie in a plane; None for 1e-8 of the
        diagonal, as TetGen. planarity: share of its size that a facet may be off its plane. limit:
        most problems of a kind. Decisions beyond the tolerance are exact. An empty list: TetGen
        has no reason to fail. Raises Cancelled, ValueError.
        """
        self._check_tolerance(tolerance)
        rows = _kernel.core().check_plc(self, tolerance, planarity, limit, False, progress)
        return problems_of(rows)

    def mend(
        self,
        tolerance: Optional[float] = None,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> "PLC":
        """A new PLC without what can be mended safely; its notes say what was done.

        Merges duplicate points, removes facets without area and duplicate facets, and turns facets
        so that surfaces are oriented, outwards where they close. Geometry does not change.
        Facet and segment constraints and further edges are kept. Raises Cancelled, ValueError.
        """
        self._check_tolerance(tolerance)
        arrays, old, notes = _kernel.core().mend_plc(self, tolerance, progress)
        plc = PLC.of_arrays(arrays)
        plc.groups = {name: list(markers) for name, markers in self.groups.items()}
        plc.region_groups = {name: list(a) for name, a in self.region_groups.items()}
        plc.facet_constraints = self.facet_constraints.copy()
        self._carry_points(plc)
        plc.notes = notes
        #: facet of the old PLC for each facet of this one
        plc.old_facets = np.array(old, np.int32)
        return plc

    def _carry_points(self, plc: "PLC") -> None:
        """What belongs to nodes goes to where the same places are in the mended PLC."""
        if self.edges is None and not len(self.segment_constraints) and self.point_sizes is None:
            return
        place = {tuple(p): i for i, p in reversed(list(enumerate(plc.points.tolist())))}
        new = np.array([place.get(tuple(p), -1) for p in self.points.tolist()], np.int32)
        if self.point_sizes is not None:
            kept = np.flatnonzero(new >= 0)
            sizes = np.zeros((len(plc.points), self.point_sizes.shape[1]))
            sizes[new[kept]] = self.point_sizes[kept]
            plc.point_sizes = sizes
        if self.edges is not None:
            edges = new[self.edges]
            keep = (edges >= 0).all(axis=1) & (edges[:, 0] != edges[:, 1])
            plc.edges = np.ascontiguousarray(edges[keep])
            if self.edge_markers is not None:
                plc.edge_markers = np.ascontiguousarray(self.edge_markers[keep])
        if len(self.segment_constraints):
            table = self.segment_constraints.copy()
            table[:, :2] = new[table[:, :2].astype(np.int64)]
            plc.segment_constraints = table[(table[:, :2] >= 0).all(axis=1)]

    @staticmethod
    def _check_tolerance(tolerance: Optional[float]) -> None:
        if tolerance is not None and not 0 <= tolerance < float("inf"):
            raise ValueError(f"tolerance: expected 0 or more, got {tolerance!r}")

    def facet(self, number: int) -> List[np.ndarray]:
        """The polygons of one facet, each as its nodes."""
        first, last = self.facet_offsets[number], self.facet_offsets[number + 1]
        ends = self.polygon_offsets
        return [self.polygon_nodes[ends[p] : ends[p + 1]] for p in range(first, last)]

    def facets_of_nodes(self, nodes: Any) -> np.ndarray:
        """Ascending facets that have any of the nodes."""
        hit = np.isin(self.polygon_nodes, np.asarray(nodes))
        polygons = np.searchsorted(self.polygon_offsets, np.flatnonzero(hit), side="right") - 1
        return np.unique(np.searchsorted(self.facet_offsets, polygons, side="right") - 1)

    def _check_nodes(self) -> None:
        nodes = self.polygon_nodes
        bad = np.flatnonzero((nodes < 0) | (nodes >= len(self.points)))
        if len(bad):
            polygon = int(np.searchsorted(self.polygon_offsets, bad[0], side="right")) - 1
            facet = int(np.searchsorted(self.facet_offsets, polygon, side="right")) - 1
            raise ValueError(
                f"facets: facet {facet} has node {int(nodes[bad[0]])}, "
                f"but there are {len(self.points)} points"
            )

    def _set_facet_holes(self, facet_holes: Mapping[int, Any]) -> None:
        rows = {}
        for facet, places in facet_holes.items():
            if not 0 <= int(facet) < len(self):
                raise ValueError(f"facet_holes: no facet {facet}; there are {len(self)}")
            rows[int(facet)] = _points(places, f"facet_holes[{facet}]")
        counts = np.zeros(len(self) + 1, np.int64)
        for facet, places in rows.items():
            counts[facet + 1] = len(places)
        self.facet_hole_offsets = np.cumsum(counts)
        ordered = [rows[facet] for facet in sorted(rows)]
        self.facet_holes = np.concatenate(ordered) if ordered else np.empty((0, 3))

    @staticmethod
    def _checked_regions(regions: Any) -> np.ndarray:
        table = _table(regions, "regions", None, (5, 4))
        if table.shape[1] == 4:
            table = np.column_stack([table, np.full(len(table), -1.0)])
        return np.ascontiguousarray(table)

    def _checked_edges(self, edges: Any) -> np.ndarray:
        array = np.ascontiguousarray(edges, dtype=np.int32).reshape(-1, 2)
        if array.size and (array.min() < 0 or array.max() >= len(self.points)):
            raise ValueError(f"edges: a node is outside 0 to {len(self.points) - 1}")
        return array
