# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh: the one exchange type. NumPy arrays only; what is computed lives in the kernel."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, Mapping, Optional, Tuple

import numpy as np

from . import _kernel

if TYPE_CHECKING:
    from .block_model import BlockModel
    from .report import Report

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
        #: Of a mesh made by to_order: int32 (E, 2), the end nodes of each mid-side node's edge;
        #: the mid-side nodes are the last E points. None for other meshes.
        self.mid_side_ends: Optional[np.ndarray] = None
        #: Of a mesh on CAD: int32 (K,), nodes inside faces that left the CAD because cells would be
        #: inside out otherwise.
        self.off_cad: np.ndarray = np.empty(0, np.int32)

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

    def split(self, progress: Optional[Callable[[float], Any]] = None) -> "Mesh":
        """Triangles and tetrahedra: each quad gives 2 triangles, each hexahedron 12 tetrahedra.

        Quads and faces are split by the shorter diagonal. Of equal ones, a surface's quad joins its
        nodes 2 and 4 (the thesis's TP 1); a face of hexahedra, and a quad in a mesh that has volume
        cells, takes the one at its lowest node number, so that all that share the face agree.
        Points keep their numbers; one node at the centroid of each hexahedron is appended, in the
        order of the hexahedra. Cell 2 q and 2 q + 1 come from quad q, 12 h to 12 h + 11 from
        hexahedron h, behind triangles and tetrahedra that were there. Groups follow their cells.
        Raises ValueError for quadratic cells (raise the order afterwards), wedges and pyramids.
        """
        from . import convert  # only here: convert.py imports this module

        return convert.split(self, progress)

    def related_nodes(
        self, progress: Optional[Callable[[float], Any]] = None
    ) -> Tuple[np.ndarray, np.ndarray]:
        """(offsets, neighbours): the nodes that an edge of an element joins to node n, ascending,
        are neighbours[offsets[n]:offsets[n + 1]]. int64 (N + 1,), int32.

        Those of a triangulated surface, as N2R has them, are mesh.split().related_nodes().
        """
        return _kernel.core().related_nodes(len(self.points), self.cells, progress)

    def boundary(self, progress: Optional[Callable[[float], Any]] = None) -> "Mesh":
        """Outer faces of the volume cells, seen from outside; of a surface mesh its free edges.

        Only the points in use, in their order. Groups of nodes and of surface cells keep what lies
        on the boundary. Interior walls between volume cells are not part of it.
        """
        from . import convert  # only here: convert.py imports this module

        return convert.boundary_with_parents(self, progress)[0]

    def to_order(self, order: int = 2, progress: Optional[Callable[[float], Any]] = None) -> "Mesh":
        """Quadratic cells (quad8, hexahedron20, triangle6, tetra10, ...) with a node on each edge.

        Points keep their numbers; mid-side nodes follow in the order in which the cells first name
        their edges. Of a mesh that model.generate() made, or that and split, they lie on the true
        mapping of the blocks (and move with nodes that were snapped); else on straight edges.
        Groups of cells stay as they are. A group of nodes gains the mid-side node of
        an edge with both ends in the group when the edge is on the boundary or a line cell, or a
        cell with that edge has all its corners in the group.
        Raises ValueError for order other than 2, and for cells that are quadratic already.
        """
        from . import convert  # only here: convert.py imports this module

        return convert.to_order(self, order, progress)

    def to_quads(
        self, method: str = "match", progress: Optional[Callable[[float], Any]] = None
    ) -> "Mesh":
        """A surface of quads only.

        method "split": each triangle gives three quads and each quad four, round a node at the
        mean of its corners. "match": pairs of triangles become quads; the pairs are as many as can
        be, and of the best scaled Jacobians over the whole mesh (a maximum-weight matching). Not
        paired: over an edge of three triangles or a crease of 60 degrees, and triangles of
        different groups. If a triangle is left over, all cells are split as above, so that the
        surface is of quads only and conforming. Groups follow.
        Raises ValueError for another method, volume cells and quadratic cells.
        """
        from . import convert  # only here: convert.py imports this module

        return convert.to_quads(self, method, progress)

    def to_hexes(self, progress: Optional[Callable[[float], Any]] = None) -> "Mesh":
        """Each tetrahedron as four hexahedra, each triangle as three quads: conforming, positive.

        New nodes: in the middle of each edge, of each face, and of each tetrahedron, in this order
        behind the old ones. Cells 4 t to 4 t + 3 come from tetrahedron t. Groups follow; a group of
        nodes gains face and inner nodes when all their corners are in it, mid-side nodes as in
        to_order. Raises ValueError for other volume cells, quads and quadratic cells.
        """
        from . import convert  # only here: convert.py imports this module

        return convert.to_hexes(self, progress)

    def quality(
        self, metric: str = "scaled_jacobian", progress: Optional[Callable[[float], Any]] = None
    ) -> Dict[str, np.ndarray]:
        """Cell name -> float64 (M,), for the cell types for which the metric is defined.

        metric: scaled_jacobian, shape, aspect_ratio, edge_ratio, skew, warpage, min_angle,
        max_angle (of volume cells between faces), radius_edge_ratio, length, area, volume,
        min_jacobian, jacobian_ratio (of quadratic cells). Definitions are Verdict's; docs and the
        kernel's headers say the rest. Angles in degrees. Raises ValueError for other names.

        triangle6, quad8, tetra10 and hexahedron20: scaled_jacobian, min_jacobian, jacobian_ratio,
        area and volume are of the curved cell, the first three bounds that hold in all of it; the
        others are of the straight cell with its corners. wedge15 and pyramid13: all metrics are of
        the straight cell, as Verdict has them; a mid-node out of place does not show.
        """
        return _kernel.core().quality(self.points, self.cells, metric, progress)

    def report(
        self,
        bins: int = 10,
        worst: int = 10,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> "Report":
        """Counts, bounds, size, and of each metric worst, mean, histogram (bins) and the `worst`
        cells with their place. print(mesh.report()) shows it."""
        from .report import report

        return report(self, bins, worst, progress)

    def __repr__(self) -> str:
        cells = ", ".join(f"{len(nodes)} {name}" for name, nodes in self.cells.items())
        return f"<nmgs.Mesh: {len(self.points)} points, {cells or 'no cells'}>"
