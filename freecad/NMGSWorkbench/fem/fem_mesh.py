# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh as Fem.FemMesh: nodes, cells, boundary faces, groups."""

from __future__ import annotations

from collections import deque
from typing import Any, Callable, Dict, Optional, Tuple

import numpy as np

from ..nmgs import _kernel
from ..nmgs.errors import Cancelled
from ..nmgs.mesh import CELL_TYPES, Mesh

#: Fem.FemMesh's node order, as indices into VTK's; found by Jacobian signs, by CalculiX, and for
#: pyramids by the MED files it writes.
_HEX = (7, 4, 5, 6, 3, 0, 1, 2, 15, 12, 13, 14, 11, 8, 9, 10, 19, 16, 17, 18)
_WEDGE = (5, 3, 4, 2, 0, 1, 11, 9, 10, 8, 6, 7, 14, 12, 13)
_PYRAMID = (0, 3, 2, 1, 4, 8, 7, 6, 5, 9, 12, 11, 10)
_TET = (1, 0, 2, 3, 4, 6, 5, 8, 7, 9)
NODE_ORDER: Dict[str, Tuple[int, ...]] = {
    "hexahedron": _HEX[:8],
    "hexahedron20": _HEX,
    "wedge": _WEDGE[:6],
    "wedge15": _WEDGE,
    "pyramid": _PYRAMID[:5],
    "pyramid13": _PYRAMID,
    "tetra": _TET[:4],
    "tetra10": _TET,
}
#: The order in which cells are numbered: volumes first, so that they keep our numbers plus one.
_ORDER = sorted(CELL_TYPES, key=lambda name: (-CELL_TYPES[name][1], -CELL_TYPES[name][0]))
_GROUP_KINDS = {1: "Edge", 2: "Face", 3: "Volume"}
#: Nodes or cells that are added between two calls of progress: some hundredths of a second.
_SLICE = 1 << 14

Progress = Optional[Callable[[float], Any]]


def fem_mesh(mesh: Mesh, progress: Progress = None) -> Any:
    """A Fem.FemMesh with the mesh's nodes, cells and groups; numbers are ours plus one.

    A volume mesh gets all faces of its boundary, since FEM constraints look for them and come out
    empty where some are missing. progress: called with the finished fraction every few hundredths
    of a second; False stops. Raises Cancelled.
    """
    import FreeCAD  # noqa: F401  (Fem crashes the process when it is imported before it)
    import Fem

    mesh = with_boundary(mesh)
    result = Fem.FemMesh()
    total = len(mesh.points) + sum(len(nodes) for nodes in mesh.cells.values())
    done = _add_nodes(result, mesh.points, _Steps(progress, total))
    first: Dict[str, int] = {}
    number = 1
    for name in _ORDER:
        if len(mesh.cells.get(name, ())):
            first[name] = number
            number = _add_cells(result, name, mesh.cells[name], number, done)
    for name, (kind, indices) in mesh.groups.items():
        typename = "Node" if kind == "node" else _GROUP_KINDS[CELL_TYPES[kind][1]]
        group = result.addGroup(name, typename)
        offset = 1 if kind == "node" else first.get(kind, 1)
        result.addGroupElements(group, (indices + offset).tolist())
    return result


class _Steps:
    """Tells progress what fraction of a number of steps is done."""

    def __init__(self, progress: Progress, total: int):
        self._progress, self._total, self._done = progress, max(total, 1), 0

    def add(self, count: int) -> None:
        self._done += count
        if self._progress is not None and self._progress(self._done / self._total) is False:
            raise Cancelled("making the FEM mesh: cancelled")


def _add_nodes(result: Any, points: np.ndarray, steps: _Steps) -> _Steps:
    for start in range(0, len(points), _SLICE):
        part = points[start : start + _SLICE]
        numbers = range(start + 1, start + 1 + len(part))
        # A deque of no length runs a map to its end without a loop in Python.
        deque(map(result.addNode, *part.T.tolist(), numbers), maxlen=0)
        steps.add(len(part))
    return steps


def _add_cells(result: Any, name: str, cells: np.ndarray, number: int, steps: _Steps) -> int:
    """Adds the cells, numbered from `number` on; returns the next number."""
    size, dimension = CELL_TYPES[name]
    order = list(NODE_ORDER.get(name, range(size)))
    add = {1: result.addEdge, 2: result.addFace, 3: result.addVolume}[dimension]
    # From FreeCAD 1.0 on; numbers go on from the highest that is there.
    many = {2: "addFaceList", 3: "addVolumeList"}.get(dimension, "")
    add_many = getattr(result, many, None) if many else None
    for start in range(0, len(cells), _SLICE):
        rows = cells[start : start + _SLICE, order] + 1
        if add_many is not None:
            add_many(rows.ravel().tolist(), [size] * len(rows))
        else:
            deque(map(add, rows.tolist(), range(number, number + len(rows))), maxlen=0)
        number += len(rows)
        steps.add(len(rows))
    return number


def with_boundary(mesh: Mesh) -> Mesh:
    """The mesh with every outer face of its volumes among its cells, those that exist first."""
    volumes = {name: nodes for name, nodes in mesh.cells.items() if CELL_TYPES[name][1] == 3}
    if not volumes:
        return mesh
    cells = dict(mesh.cells)
    for name, (faces, _, _) in _kernel.core().boundary(len(mesh.points), volumes).items():
        present = cells.get(name, faces[:0])
        missing = faces if not len(present) else faces[~_among(faces, present)]
        if len(missing):
            cells[name] = np.concatenate([present, missing]) if len(present) else missing
    return Mesh(mesh.points, cells, mesh.groups, model=mesh.model)


def _among(rows: np.ndarray, others: np.ndarray) -> np.ndarray:
    """bool (len(rows),): whether a row's nodes, in any order, are those of one of the others."""
    whole = np.sort(np.concatenate([rows, others]), axis=1)
    keys = np.ascontiguousarray(whole).view([("", whole.dtype)] * whole.shape[1]).ravel()
    return np.isin(keys[: len(rows)], keys[len(rows) :])
