# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be meshed: points, PLC, path, Mesh, BlockModel, and FreeCAD's shapes and meshes."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Tuple

import numpy as np

from ..block_model import BlockModel
from ..mesh import Mesh
from ..plc import PLC
from .options import TetOptions

#: Faces of a surface mesh; mid-side nodes are left out, TetGen's facets are straight.
FACES = ("triangle", "triangle6", "quad", "quad8")
CORNERS = {"triangle": 3, "triangle6": 3, "quad": 4, "quad8": 4}
TETRA = ("tetra", "tetra10")

#: TetGen's mid-nodes are on the edges 23, 03, 01, 12, 13, 02; VTK's on 01, 12, 02, 03, 13, 23.
TO_TETGEN = [0, 1, 2, 3, 9, 7, 4, 5, 8, 6]


def to_source(source: Any, surface: bool, deviation: float = 0.0, progress: Any = None) -> Any:
    """The source as a PLC, a Mesh with tetrahedra, or (N, 3) points.

    surface: a PLC is wanted; a BlockModel then gives the surface of its mesh, else its nodes.
    deviation: for CAD, how far a facet may be from its face; 0 for a thousandth of the size.
    Raises TypeError, ValueError, GeometryError, FormatError.
    """
    if isinstance(source, (str, os.PathLike)):
        return to_source(_read(os.fspath(source), surface), surface, deviation, progress)
    if isinstance(source, PLC):
        return source
    if isinstance(source, Mesh):
        return source if any(t in source.cells for t in TETRA) else plc_of_surface(source)
    if isinstance(source, BlockModel):
        return _of_blocks(source, surface)
    for attribute in ("Shape", "Mesh"):  # a document object
        if hasattr(source, attribute) and hasattr(source, "TypeId"):
            return to_source(getattr(source, attribute), surface, deviation, progress)
    if hasattr(source, "Topology") and hasattr(source, "CountFacets"):
        points, facets = source.Topology
        return PLC([tuple(p) for p in points], np.array(facets, np.int32).reshape(-1, 3))
    shapes = source if isinstance(source, (list, tuple)) and len(source) else [source]
    if all(hasattr(item, "exportBrepToString") or hasattr(item, "Shape") for item in shapes):
        from ..cad_plc import plc_of_shape

        return plc_of_shape(source, deviation, progress)
    return _points(source)


def _read(path: str, surface: bool) -> Any:
    from ..io import read
    from ..surface_files import SURFACES, plc_of_file

    if surface and os.path.splitext(path)[1].lower().lstrip(".") in SURFACES:
        return plc_of_file(path)
    return read(path)


def _points(source: Any, argument: str = "source") -> np.ndarray:
    try:
        points = np.ascontiguousarray(source, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(
            f"{argument}: cannot mesh a {type(source).__name__}; expected points, a PLC, a path,"
            " a Mesh, a BlockModel, or a FreeCAD shape, mesh or object"
        ) from None
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"{argument}: expected (N, 3) points, got shape {points.shape}")
    if not np.isfinite(points).all():
        row = int(np.argwhere(~np.isfinite(points))[0][0])
        raise ValueError(f"{argument}: point {row} is not finite: {points[row].tolist()}")
    return points


def _of_blocks(model: BlockModel, surface: bool) -> Any:
    if not surface:
        return np.unique(model.nodes.reshape(-1, 3), axis=0)
    mesh = model.generate()
    return plc_of_surface(mesh if model.dimension == 2 else mesh.boundary())


def plc_of_surface(mesh: Mesh) -> PLC:
    """Each triangle and quad as a facet; groups of faces become markers and groups of the PLC."""
    blocks = [(t, mesh.cells[t][:, : CORNERS[t]]) for t in FACES if t in mesh.cells]
    if not blocks:
        raise ValueError(f"source: {mesh!r} has neither tetrahedra nor a surface of faces")
    nodes = np.concatenate([rows.reshape(-1) for _, rows in blocks])
    sizes = np.concatenate([np.full(len(rows), rows.shape[1], np.int64) for _, rows in blocks])
    markers, groups = _markers(mesh, blocks)
    plc = PLC.of_arrays(
        {
            "points": mesh.points,
            "polygon_nodes": nodes,
            "polygon_offsets": np.concatenate([[0], np.cumsum(sizes)]),
            "facet_offsets": np.arange(len(sizes) + 1),
            "markers": markers,
        }
    )
    plc.groups = groups
    return plc


def _markers(
    mesh: Mesh, blocks: List[Tuple[str, np.ndarray]]
) -> Tuple["np.ndarray | None", Dict[str, List[int]]]:
    """A marker for every combination of groups that a face is in, and the markers of each group."""
    names = [name for name, (kind, _) in mesh.groups.items() if kind in FACES]
    if not names:
        return None, {}
    first = {}
    total = 0
    for kind, rows in blocks:
        first[kind] = total
        total += len(rows)
    member = np.zeros((total, len(names)), bool)
    for column, name in enumerate(names):
        kind, cells = mesh.groups[name]
        member[first[kind] + cells, column] = True
    combinations, markers = np.unique(member, axis=0, return_inverse=True)
    return markers.astype(np.int32).reshape(-1) + 1, {
        name: [int(m) + 1 for m in np.flatnonzero(combinations[:, column])]
        for column, name in enumerate(names)
    }


def request_of(source: Any) -> Dict[str, np.ndarray]:
    """The arrays that the worker is sent for a PLC, a Mesh with tetrahedra, or points."""
    if isinstance(source, PLC):
        return _request_of_plc(source)
    if isinstance(source, Mesh):
        kind = next(t for t in TETRA if t in source.cells)
        tetra = source.cells[kind]
        arrays = {
            "points": source.points,
            "tetra": tetra if kind == "tetra" else tetra[:, TO_TETGEN],
        }
        faces = [
            (t, source.cells[t][:, :3]) for t in ("triangle", "triangle6") if t in source.cells
        ]
        if faces:
            arrays["triangles"] = np.concatenate([rows for _, rows in faces])
            markers, _ = _markers(source, faces)
            if markers is not None:
                arrays["triangle_markers"] = markers
        return arrays
    return {"points": source}


def _request_of_plc(plc: PLC) -> Dict[str, np.ndarray]:
    arrays = {"points": plc.points}
    if len(plc):
        arrays["polygon_nodes"] = plc.polygon_nodes
        arrays["polygon_offsets"] = plc.polygon_offsets
        arrays["facet_offsets"] = plc.facet_offsets
        arrays["stl"] = np.array([plc.stl], np.int32)
    if len(plc.facet_holes):
        arrays["facet_holes"] = plc.facet_holes
        arrays["facet_hole_offsets"] = plc.facet_hole_offsets
    optional = {
        "facet_markers": plc.markers,
        "point_markers": plc.point_markers,
        "point_attributes": plc.point_attributes,
        "point_sizes": plc.point_sizes,
        "facet_constraints": plc.facet_constraints,
        "segment_constraints": plc.segment_constraints,
        "edges": plc.edges,
        "edge_markers": plc.edge_markers,
        "holes": plc.holes,
        "regions": plc.regions,
    }
    arrays.update({k: v for k, v in optional.items() if v is not None and len(v)})
    return arrays


def extra_arrays(
    arrays: Dict[str, np.ndarray],
    options: TetOptions,
    sizes: Any,
    volumes: Any,
    added_points: Any,
    background: Any,
) -> Dict[str, np.ndarray]:
    """The request's arrays for tetrahedralize()'s arguments; turns their switches on."""
    extra: Dict[str, np.ndarray] = {}
    if sizes is not None:
        extra["point_sizes"] = _per(sizes, "sizes", len(arrays["points"]), "point")
        options.sizes = True
    if volumes is not None:
        extra["tetra_volumes"] = _per(
            volumes, "volumes", len(arrays.get("tetra", ())), "tetrahedron"
        )
        options.volumes = True
    if added_points is not None:
        extra["added_points"] = _points(added_points, "added_points")
        options.insert_points = True
    if background is not None:
        mesh, lengths = background
        kind = next((t for t in TETRA if t in mesh.cells), None)
        if kind is None:
            raise ValueError(f"background: expected a Mesh of tetrahedra, got {mesh!r}")
        extra["background_points"] = mesh.points
        extra["background_tetra"] = mesh.cells[kind][:, :4]
        extra["background_sizes"] = _per(lengths, "background", len(mesh.points), "point")
        options.sizes = True
    return extra


def _per(values: Any, argument: str, count: int, what: str) -> np.ndarray:
    array = np.ascontiguousarray(values, dtype=np.float64).reshape(-1)
    if len(array) != count:
        raise ValueError(f"{argument}: expected {count} numbers, one a {what}, got {len(array)}")
    if not np.isfinite(array).all():
        raise ValueError(f"{argument}: number {int(np.argmin(np.isfinite(array)))} is not finite")
    return array
