# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces: .off, .stl and Medit's .mesh by the kernel; .ply and .obj by meshio."""

from __future__ import annotations

import os
from typing import Any, Dict, List

import numpy as np

from . import _kernel
from .errors import FormatError
from .facets import flat_surface
from .mesh import CELL_TYPES, Mesh
from .plc import PLC
from .tetgen_files import as_plc

#: Extensions that plc_of_file reads.
SURFACES = ("off", "stl", "ply", "mesh", "obj", "vtk")


def plc_of_file(path: str) -> PLC:
    """The faces of a surface's file as facets, in the file's order and with the file's own points.

    An STL's triangles keep three points each: TetGen merges them as its own program does.
    Raises FormatError, FileNotFoundError.
    """
    extension = os.path.splitext(path)[1].lower().lstrip(".")
    if extension == "off":
        return PLC.of_arrays(_kernel.core().read_off(path))
    if extension == "stl":
        plc = PLC.of_arrays(_kernel.core().read_stl(path))
        plc.stl = True
        return plc
    if extension == "mesh":
        points, blocks = _kernel.core().read_medit(path)
        return _plc_of_blocks(path, points, blocks)
    raw = _meshio(path)
    blocks = [(block.type, np.asarray(block.data), None) for block in raw.cells]
    return _plc_of_blocks(path, _three(raw.points), blocks)


def _plc_of_blocks(path: str, points: np.ndarray, blocks: Any) -> PLC:
    """Faces of blocks (cell name, nodes, markers or None) in their order."""
    faces = [nodes for kind, nodes, _ in blocks if kind in ("triangle", "quad", "polygon")]
    if not faces:
        raise FormatError(
            f"{path}: expected a surface, found no triangles, quads or polygons", path
        )
    sizes = np.concatenate([np.full(len(f), f.shape[1], np.int64) for f in faces])
    numbers = [m for kind, _, m in blocks if kind in ("triangle", "quad") and m is not None]
    markers = np.concatenate(numbers) if numbers else None
    arrays = {
        "points": points,
        "polygon_nodes": np.concatenate([f.reshape(-1) for f in faces]).astype(np.int32),
        "polygon_offsets": np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64),
        "facet_offsets": np.arange(len(sizes) + 1, dtype=np.int64),
        "markers": markers if markers is not None and len(markers) == len(sizes) else None,
    }
    return PLC.of_arrays(arrays)


def _three(points: np.ndarray) -> np.ndarray:
    full = np.zeros((len(points), 3))
    full[:, : points.shape[1]] = points
    return full


def _meshio(path: str) -> Any:
    import meshio

    if not os.path.exists(path):
        raise FileNotFoundError(f"no such file: {path}")
    try:
        return meshio.read(path)
    except (Exception, SystemExit) as error:  # meshio raises what its readers happen to raise
        raise FormatError(f"{path}: {error or 'not readable'}", path) from error


def _mesh_of_plc(plc: PLC) -> Any:
    """Triangles and quads as a Mesh; with other facets the PLC itself."""
    sizes = np.diff(plc.polygon_offsets)
    if len(sizes) != len(plc) or not np.isin(sizes, (3, 4)).all():
        return plc
    starts = plc.polygon_offsets[:-1]
    cells = {}
    for size, kind in ((3, "triangle"), (4, "quad")):
        rows = starts[sizes == size]
        if len(rows):
            cells[kind] = plc.polygon_nodes[rows[:, None] + np.arange(size)]
    return Mesh(plc.points, cells)


def read_off(path: str) -> Any:
    """A surface Mesh; a PLC where faces have more than four nodes."""
    return _mesh_of_plc(plc_of_file(path))


def read_stl(path: str) -> Mesh:
    """A surface Mesh; equal points become one."""
    plc = plc_of_file(path)
    points, first, place = np.unique(plc.points, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)  # points in the order of the file
    rank = np.empty(len(order), np.int32)
    rank[order] = np.arange(len(order), dtype=np.int32)
    triangles = rank[place.reshape(-1)][plc.polygon_nodes].reshape(-1, 3)
    return Mesh(points[order], {"triangle": triangles})


def read_medit(path: str) -> Mesh:
    """All cells of Medit's .mesh, and a group for each reference number but 0."""
    points, blocks = _kernel.core().read_medit(path)
    cells: Dict[str, List[np.ndarray]] = {}
    numbers: Dict[str, List[np.ndarray]] = {}
    for kind, nodes, references in blocks:
        cells.setdefault(kind, []).append(nodes)
        numbers.setdefault(kind, []).append(references)
    mesh = Mesh(points, {kind: np.concatenate(parts) for kind, parts in cells.items()})
    for kind, parts in numbers.items():
        prefix = {1: "Edge", 2: "Facet", 3: "Region"}[CELL_TYPES[kind][1]]
        values = np.concatenate(parts)
        for value in np.unique(values[values != 0]).tolist():
            mesh.groups[f"{prefix}{value}"] = (
                kind,
                np.flatnonzero(values == value).astype(np.int32),
            )
    return mesh


def read_surface(path: str) -> Mesh:
    """The faces of a .ply or .obj file."""
    raw = _meshio(path)
    cells: Dict[str, List[np.ndarray]] = {}
    for block in raw.cells:
        if block.type in CELL_TYPES:
            cells.setdefault(block.type, []).append(np.asarray(block.data))
    return Mesh(_three(raw.points), {kind: np.concatenate(v) for kind, v in cells.items()})


def write_off(path: str, source: Any) -> None:
    """A PLC of plain polygons, or the faces of a Mesh."""
    _kernel.core().write_off(path, as_plc(source))


def write_stl(path: str, source: Any, binary: bool = True) -> None:
    """Triangles; binary=False writes text, which holds double precision. Of a volume mesh its
    boundary, of quadratic faces flat pieces, of quads two triangles. Raises ValueError for a mesh
    without faces, and for facets of a PLC that are no triangles."""
    if isinstance(source, Mesh):
        source = flat_surface(source).split()
    _kernel.core().write_stl(path, as_plc(source), binary)


def write_ply(path: str, mesh: Mesh) -> None:
    """Triangles and quads, binary, by meshio; of a volume mesh its boundary, of quadratic faces
    flat pieces. The format has no groups. Raises ValueError for a mesh without faces."""
    import meshio

    from .atomic import temporary_beside

    surface = flat_surface(mesh)
    with temporary_beside(path) as temporary:
        raw = meshio.Mesh(surface.points, list(surface.cells.items()))
        meshio.write(temporary, raw, file_format="ply")
