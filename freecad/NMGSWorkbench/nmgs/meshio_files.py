# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formats that meshio reads (VTK, VTU, Abaqus input) and writes (VTU) well."""

from __future__ import annotations

import os
from typing import Any, Dict, List

import numpy as np

from .atomic import temporary_beside
from .errors import FormatError
from .mesh import CELL_TYPES, Mesh


def write_vtu(path: str, mesh: Mesh) -> None:
    """VTK's XML format, all cells; a group of cells is a 0/1 array of the same name."""
    blocks = list(mesh.cells.items())
    data: Dict[str, List[np.ndarray]] = {}
    for name, (kind, indices) in mesh.groups.items():
        if kind == "node":
            continue
        data[name] = [np.zeros(len(nodes), dtype=np.int8) for _, nodes in blocks]
        data[name][[block for block, _ in blocks].index(kind)][indices] = 1
    points = {}
    for name, (kind, indices) in mesh.groups.items():
        if kind == "node":
            points[name] = np.zeros(len(mesh.points), dtype=np.int8)
            points[name][indices] = 1
    _write(path, mesh.points, blocks, "vtu", cell_data=data, point_data=points)


def module() -> Any:
    """meshio; version 5.0 (Debian 12) lacks the dimension of two cells that it reads and writes."""
    import meshio
    from meshio import _mesh

    for name in ("wedge15", "pyramid13"):
        getattr(_mesh, "topological_dimension", {}).setdefault(name, 3)
    return meshio


def _write(path: str, points: np.ndarray, blocks: list, file_format: str, **sets: Any) -> None:
    meshio = module()
    with temporary_beside(path) as temporary:
        meshio.Mesh(points, blocks, **sets).write(temporary, file_format=file_format)


def read_mesh(path: str) -> Mesh:
    """The points, cells and sets of a .vtu, .vtk or .inp file. Raises FormatError."""
    meshio = module()
    if not os.path.exists(path):
        raise FileNotFoundError(f"no such file: {path}")
    try:
        raw = meshio.read(path)
    except (Exception, SystemExit) as error:  # meshio raises what its readers happen to raise
        raise FormatError(f"{path}: {error or 'not readable'}", path) from error
    cells: Dict[str, List[np.ndarray]] = {}
    for block in raw.cells:
        if block.type in CELL_TYPES:
            cells.setdefault(block.type, []).append(np.asarray(block.data))
        elif block.type != "vertex":
            raise FormatError(f"{path}: {block.type} cells are not known here", path)
    points = np.zeros((len(raw.points), 3))
    points[:, : raw.points.shape[1]] = raw.points
    groups: Dict[str, Any] = {
        name: ("node", np.asarray(indices)) for name, indices in (raw.point_sets or {}).items()
    }
    for name, per_block in (raw.cell_sets or {}).items():
        start: Dict[str, int] = {}
        for block, indices in zip(raw.cells, per_block):
            first = start.get(block.type, 0)
            start[block.type] = first + len(block.data)
            if indices is not None and len(indices) and name not in groups:
                groups[name] = (block.type, np.asarray(indices) + first)
    return Mesh(points, {name: np.concatenate(parts) for name, parts in cells.items()}, groups)
