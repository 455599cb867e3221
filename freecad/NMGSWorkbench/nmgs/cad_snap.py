# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts the boundary nodes of a tetrahedral mesh onto the CAD faces and edges they belong to."""

from __future__ import annotations

from typing import Any, Callable, Dict, FrozenSet, List, Optional, Tuple

import numpy as np

from .errors import Cancelled
from .mesh import Mesh

#: Edges of a tetrahedron and of a triangle in the order of VTK's mid-nodes.
TETRA_EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
TRIANGLE_EDGES = ((0, 1), (1, 2), (0, 2))
#: Share of its smallest Jacobian that a tetrahedron keeps at least.
KEPT = 0.01
#: How often the moves of a tetrahedron that would turn inside out are halved, before they are 0.
HALVINGS = 6


def snap_to_shape(
    mesh: Mesh, shape: Any, progress: Optional[Callable[[float], Any]] = None
) -> float:
    """Moves the nodes of the groups FaceN to the nearest point of FaceN; on an edge between faces,
    to the nearest point of that edge. Mid-nodes follow, and those on the boundary go onto it too.

    Changes mesh.points. No tetrahedron turns inside out: where one would, its nodes move less.
    Returns the largest distance from the CAD that is left. Raises Cancelled.
    """
    targets = _targets(mesh, shape, progress)
    if not targets:
        return 0.0
    start = mesh.points.copy()
    nodes = np.array(sorted(targets), np.int64)
    wanted = np.zeros_like(start)
    wanted[nodes] = np.array([targets[n] for n in nodes.tolist()]) - start[nodes]
    share = np.ones(len(start))
    kind = "tetra" if "tetra" in mesh.cells else "tetra10"
    tetra = mesh.cells[kind]
    moving = np.zeros(len(start), bool)
    moving[nodes] = True
    near = np.flatnonzero(moving[tetra].any(axis=1))
    before = _smallest_jacobian(start, tetra[near])
    for round in range(HALVINGS + len(near)):
        mesh.points[:] = start + share[:, None] * wanted
        _straighten(mesh.points, tetra[near], moving)
        bad = near[_smallest_jacobian(mesh.points, tetra[near]) < KEPT * before]
        if not len(bad):
            break
        share[np.unique(tetra[bad])] *= 0.5 if round < HALVINGS else 0.0
    return float(np.linalg.norm(((1 - share)[:, None] * wanted)[nodes], axis=1).max())


def _straighten(points: np.ndarray, tetra: np.ndarray, moving: np.ndarray) -> None:
    """Mid-nodes that have no target of their own go to the middle of their edge."""
    if tetra.shape[1] != 10:
        return
    for k, (a, b) in enumerate(TETRA_EDGES):
        free = ~moving[tetra[:, 4 + k]]
        rows = tetra[free]
        points[rows[:, 4 + k]] = 0.5 * (points[rows[:, a]] + points[rows[:, b]])


def _targets(
    mesh: Mesh, shape: Any, progress: Optional[Callable[[float], Any]]
) -> Dict[int, Tuple[float, float, float]]:
    """The place on the CAD for each node of the boundary that is not there yet."""
    faces_of: Dict[int, set] = {}
    middles: Dict[int, Tuple[int, int]] = {}
    for name, (kind, cells) in mesh.groups.items():
        if kind not in ("triangle", "triangle6") or not name[4:].isdigit() or name[:4] != "Face":
            continue
        number = int(name[4:])
        rows = mesh.cells[kind][cells]
        for node in np.unique(rows).tolist():
            faces_of.setdefault(node, set()).add(number)
        for k, (a, b) in enumerate(TRIANGLE_EDGES[: rows.shape[1] - 3]):
            middles.update(
                zip(rows[:, 3 + k].tolist(), zip(rows[:, a].tolist(), rows[:, b].tolist()))
            )
    carriers = _Carriers(shape)
    result: Dict[int, Tuple[float, float, float]] = {}
    # Corners first: a mid-node starts from the middle of where its corners go.
    order = sorted(faces_of, key=lambda node: (node in middles, node))
    for done, node in enumerate(order):
        if progress is not None and done % 200 == 0 and progress(done / len(order)) is False:
            raise Cancelled("cancelled")
        place = mesh.points[node]
        if node in middles:
            a, b = middles[node]
            place = 0.5 * (np.array(result.get(a, mesh.points[a])) + result.get(b, mesh.points[b]))
        result[node] = carriers.nearest(frozenset(faces_of[node]), place)
    return result


class _Carriers:
    """Nearest points of a shape's faces and of the edges between them."""

    def __init__(self, shape: Any):
        from FreeCAD import Vector  # here only: FreeCAD is there when a shape is

        self._vector = Vector
        self._faces = shape.Faces
        self._curves: Dict[FrozenSet[int], List[Any]] = {}
        self._edges: List[Tuple[FrozenSet[int], Any]] = []
        numbers: Dict[int, List[Tuple[Any, set]]] = {}
        for number, face in enumerate(self._faces, 1):
            for edge in face.Edges:
                same = numbers.setdefault(edge.hashCode(), [])
                for other, faces in same:
                    if other.isSame(edge):
                        faces.add(number)
                        break
                else:
                    same.append((edge, {number}))
        for same in numbers.values():
            self._edges += [(frozenset(faces), edge) for edge, faces in same]

    def nearest(self, faces: FrozenSet[int], place: np.ndarray) -> Tuple[float, float, float]:
        """On the one face, or on an edge that all the faces have; a corner stays."""
        point = self._vector(*place)
        if len(faces) == 1:
            (number,) = faces
            return tuple(self._faces[number - 1].Surface.projectPoint(point))
        if faces not in self._curves:
            self._curves[faces] = [e for of, e in self._edges if faces <= of and not e.Degenerated]
        best = None
        for edge in self._curves[faces]:
            on_curve = self._on_edge(edge, point)
            distance = on_curve.distanceToPoint(point)
            if best is None or distance < best[0]:
                best = (distance, on_curve)
        return tuple(best[1]) if best is not None else tuple(place)

    @staticmethod
    def _on_edge(edge: Any, point: Any) -> Any:
        curve = edge.Curve
        first, last = sorted(edge.ParameterRange)
        parameter = curve.parameter(point)
        if curve.isPeriodic():
            period = curve.period()
            parameter += period * np.ceil((first - 1e-9 - parameter) / period)
        if first - 1e-9 <= parameter <= last + 1e-9:
            return curve.value(parameter)
        ends = (curve.value(first), curve.value(last))
        return min(ends, key=point.distanceToPoint)


def _smallest_jacobian(points: np.ndarray, tetra: np.ndarray) -> np.ndarray:
    """Lower bound of the Jacobian over each tetrahedron: exact for four nodes; for ten, the least
    coefficient of the cubic in Bernstein's form (Johnen, Remacle, Geuzaine, JCP 2013)."""
    if not len(tetra):
        return np.empty(0)
    p = points[tetra]
    if tetra.shape[1] == 4:
        return np.linalg.det(p[:, 1:] - p[:, :1])
    values = np.stack([np.linalg.det(_gradient(at).T @ p) for at in _LATTICE], axis=1)
    return (values @ _TO_BERNSTEIN.T).min(axis=1)


def _gradient(at: np.ndarray) -> np.ndarray:
    """(10, 3): derivatives of the shape functions by the last three barycentric coordinates."""
    full = np.zeros((10, 4))
    for k in range(4):
        full[k, k] = 4 * at[k] - 1
    for k, (a, b) in enumerate(TETRA_EDGES):
        full[4 + k, a] = 4 * at[b]
        full[4 + k, b] = 4 * at[a]
    return full[:, 1:] - full[:, :1]


def _cubic() -> Tuple[np.ndarray, np.ndarray]:
    """The 20 points of the cubic lattice, and values there to Bernstein's coefficients."""
    from math import factorial

    exponents = [
        (3 - b - c - d, b, c, d) for b in range(4) for c in range(4 - b) for d in range(4 - b - c)
    ]
    points = np.array(exponents, float) / 3
    basis = np.array(
        [
            [
                6 / np.prod([factorial(k) for k in e]) * np.prod(at ** np.array(e, float))
                for e in exponents
            ]
            for at in points
        ]
    )
    return points, np.linalg.inv(basis)


_LATTICE, _TO_BERNSTEIN = _cubic()
