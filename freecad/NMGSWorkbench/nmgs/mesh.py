# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh: the one exchange type. NumPy arrays only; what is computed lives in the kernel."""

from __future__ import annotations

from typing import TYPE_CHECKING, Dict, Mapping, Optional, Tuple

import numpy as np

if TYPE_CHECKING:
    from .block_model import BlockModel

#: Nodes of a cell and its dimension, by meshio's name of the type.
CELL_TYPES: Dict[str, Tuple[int, int]] = {
    "line": (2, 1),
    "line3": (3, 1),
    "triangle": (3, 2),
    "triangle6": (6, 2),
    "quad": (4, 2),
    "quad8": (8, 2),
    "tetra": (4, 3),
    "tetra10": (10, 3),
    "pyramid": (5, 3),
    "pyramid13": (13, 3),
    "wedge": (6, 3),
    "wedge15": (15, 3),
    "hexahedron": (8, 3),
    "hexahedron20": (20, 3),
}

Group = Tuple[str, np.ndarray]


class Mesh:
    """Points, cells by type and named groups.

    points: float64 (N, 3). cells: meshio's cell name -> int32 (M, k), 0-based, VTK's node order.
    groups: name -> (cell name | "node", int32 indices). model: the BlockModel it came from, if any.
    Raises ValueError that names the argument when shapes or indices are wrong.
    """

    def __init__(
        self,
        points: np.ndarray,
        cells: Mapping[str, np.ndarray],
        groups: Optional[Mapping[str, Group]] = None,
        model: Optional["BlockModel"] = None,
    ):
        self.points = np.ascontiguousarray(points, dtype=np.float64)
        if self.points.ndim != 2 or self.points.shape[1] != 3:
            raise ValueError(f"points: expected shape (N, 3), got {self.points.shape}")
        self.cells = {name: self._checked_cells(name, nodes) for name, nodes in cells.items()}
        self.groups: Dict[str, Group] = {}
        for name, (kind, indices) in (groups or {}).items():
            self.groups[name] = (kind, self._checked_group(name, kind, indices))
        self.model = model

    def _checked_cells(self, name: str, nodes: np.ndarray) -> np.ndarray:
        if name not in CELL_TYPES:
            raise ValueError(f"cells: no such cell type {name!r}")
        array = np.ascontiguousarray(nodes, dtype=np.int32)
        if array.ndim != 2 or array.shape[1] != CELL_TYPES[name][0]:
            raise ValueError(
                f"cells[{name!r}]: expected shape (M, {CELL_TYPES[name][0]}), got {array.shape}"
            )
        if array.size and (array.min() < 0 or array.max() >= len(self.points)):
            bad = int(np.argmax(((array < 0) | (array >= len(self.points))).any(axis=1)))
            raise ValueError(
                f"cells[{name!r}]: cell {bad} has nodes {array[bad].tolist()}, "
                f"but the mesh has {len(self.points)} points"
            )
        return array

    def _checked_group(self, name: str, kind: str, indices: np.ndarray) -> np.ndarray:
        if kind != "node" and kind not in self.cells:
            raise ValueError(f"groups[{name!r}]: the mesh has no {kind!r} cells")
        array = np.ascontiguousarray(indices, dtype=np.int32)
        count = len(self.points) if kind == "node" else len(self.cells[kind])
        if array.ndim != 1 or (array.size and (array.min() < 0 or array.max() >= count)):
            raise ValueError(f"groups[{name!r}]: indices must be 0 to {count - 1}, one-dimensional")
        return array

    def __repr__(self) -> str:
        cells = ", ".join(f"{len(nodes)} {name}" for name, nodes in self.cells.items())
        return f"<nmgs.Mesh: {len(self.points)} points, {cells or 'no cells'}>"
