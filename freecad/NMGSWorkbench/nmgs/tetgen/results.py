# SPDX-License-Identifier: LGPL-2.1-or-later
"""An answer of the worker as a Mesh with groups, and all that TetGen tells beside the mesh."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional

import numpy as np

from ..mesh import Group, Mesh
from ..plc import PLC


@dataclass
class Voronoi:
    """Voronoi diagram of the points (-v), dual to their Delaunay tetrahedra.

    points: float64 (V, 3), the circumcentres. edges: int32 (E, 2) into points, -1 for a ray to
    infinity; rays: float64 (E, 3), its direction. facets: offsets (F + 1) into facet_edges (-1
    closes over infinity); facet_cells: (F, 2), the two sites that a facet parts. cells: offsets
    (N + 1) into cell_facets, one cell a site.
    """

    points: np.ndarray
    edges: np.ndarray
    rays: np.ndarray
    facets: np.ndarray
    facet_edges: np.ndarray
    facet_cells: np.ndarray
    cells: np.ndarray
    cell_facets: np.ndarray


@dataclass
class TetGenData:
    """What TetGen returns beside points and cells, as mesh.tetgen. None where it was not asked for.

    version, switches, log: of the run. Per node: point_markers (N,), point_attributes (N, k),
    point_sizes (N, 1). Per tetrahedron: attributes (M, k), neighbours (M, 4), the tetrahedron
    opposite to each corner, -1 for none (-n). Per triangle: triangle_markers (T,), triangle_tetra
    (T, 2) (-nn). edges (E, 2 | 3): the segments, or all edges with -e; edge_markers (E,).
    """

    version: str
    switches: str
    log: str
    point_markers: Optional[np.ndarray] = None
    point_attributes: Optional[np.ndarray] = None
    point_sizes: Optional[np.ndarray] = None
    attributes: Optional[np.ndarray] = None
    neighbours: Optional[np.ndarray] = None
    triangle_markers: Optional[np.ndarray] = None
    triangle_tetra: Optional[np.ndarray] = None
    edges: Optional[np.ndarray] = None
    edge_markers: Optional[np.ndarray] = None
    voronoi: Optional[Voronoi] = field(default=None, repr=False)


def mesh_of(arrays: Dict[str, np.ndarray], source: Any, data: TetGenData) -> Mesh:
    """The Mesh of an answer: tetra or tetra10, and triangle or triangle6 of the boundary."""
    cells: Dict[str, np.ndarray] = {}
    tetra = arrays.get("tetra")
    if tetra is not None and len(tetra):
        cells["tetra" if tetra.shape[1] == 4 else "tetra10"] = tetra
    triangles = arrays.get("triangles")
    if triangles is not None and len(triangles):
        cells["triangle" if triangles.shape[1] == 3 else "triangle6"] = triangles
    for name in (
        "point_markers point_attributes point_sizes neighbours "
        "triangle_markers triangle_tetra edges edge_markers"
    ).split():
        setattr(data, name, arrays.get(name))
    data.attributes = arrays.get("tetra_attributes")
    if data.attributes is not None and data.attributes.ndim == 1:
        data.attributes = data.attributes[:, None]
    if "voronoi_points" in arrays:
        data.voronoi = _voronoi(arrays)
    groups = _facet_groups(cells, data, source)
    groups.update(_region_groups(cells, data, source))
    mesh = Mesh(arrays.get("points", np.empty((0, 3))), cells, groups)
    mesh.tetgen = data  # type: ignore[attr-defined]
    return mesh


def _voronoi(arrays: Dict[str, np.ndarray]) -> Voronoi:
    return Voronoi(
        points=arrays["voronoi_points"],
        edges=arrays["voronoi_edges"],
        rays=arrays["voronoi_rays"],
        facets=arrays["voronoi_facet_offsets"],
        facet_edges=arrays["voronoi_facet_edges"],
        facet_cells=arrays["voronoi_facet_cells"],
        cells=arrays["voronoi_cell_offsets"],
        cell_facets=arrays["voronoi_cell_facets"],
    )


def cells_of(mesh: Mesh, first: str, second: str) -> str:
    """Which of two cell types the mesh has, or ""."""
    return _kind(mesh.cells, first, second)


def _kind(cells: Dict[str, np.ndarray], first: str, second: str) -> str:
    return first if first in cells else second if second in cells else ""


def _facet_groups(cells: Dict[str, np.ndarray], data: TetGenData, source: Any) -> Dict[str, Group]:
    kind = _kind(cells, "triangle", "triangle6")
    if not kind or data.triangle_markers is None or not isinstance(source, PLC):
        return {}
    if source.markers is None:
        return {}
    markers = np.unique(source.markers)
    names: Dict[str, List[int]] = dict(source.groups)
    named = {m for group in names.values() for m in group}
    names.update({f"Facet{m}": [m] for m in markers.tolist() if m not in named and m != 0})
    return _members(names, data.triangle_markers, kind)


def _region_groups(cells: Dict[str, np.ndarray], data: TetGenData, source: Any) -> Dict[str, Group]:
    kind = _kind(cells, "tetra", "tetra10")
    if not kind or data.attributes is None or not isinstance(source, PLC):
        return {}
    attribute = data.attributes[:, -1]
    names: Dict[str, List[float]] = dict(source.region_groups)
    named = {a for group in names.values() for a in group}
    rest = [a for a in np.unique(attribute).tolist() if a not in named]
    names.update({f"Region{a:g}": [a] for a in rest})
    return _members(names, attribute, kind)


def _members(names: Dict[str, List[Any]], values: np.ndarray, kind: str) -> Dict[str, Group]:
    order = np.argsort(values, kind="stable")
    ranked = values[order]
    groups = {}
    for name, wanted in names.items():
        parts = [
            order[np.searchsorted(ranked, v, "left") : np.searchsorted(ranked, v, "right")]
            for v in wanted
        ]
        indices = np.sort(np.concatenate(parts)) if parts else np.empty(0, np.int64)
        if len(indices):
            groups[name] = (kind, indices.astype(np.int32))
    return groups
