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
#: How often the corners of tetrahedra that are inside out are moved, and by which shares of the
#: shortest edge. A tetrahedron this many times above what it has to keep is left alone.
ROUNDS = 40
STEPS = (0.4, 0.2, 0.1, 0.05, 0.02)
ENOUGH = 5.0
#: Corners opposite to each corner, seen from it: the normal points towards it.
OPPOSITE = ((1, 3, 2), (0, 2, 3), (0, 3, 1), (0, 1, 2))


def snap_to_shape(
    mesh: Mesh, shape: Any, progress: Optional[Callable[[float], Any]] = None
) -> float:
    """Moves the nodes of the groups FaceN to the nearest point of FaceN; on an edge between faces,
    to the nearest point of that edge. Mid-nodes follow, and those on the boundary go onto it too.

    Changes mesh.points. No tetrahedron turns inside out: where one would, its nodes are moved, the
    inner ones anywhere and those on faces along them, until it does not; where that does not help,
    its nodes move less and stay off the CAD. Returns the largest distance from the CAD that is
    left. Raises Cancelled.
    """
    boundary = _Boundary(mesh, shape)
    if not boundary.faces_of:
        return 0.0
    kind = "tetra" if "tetra" in mesh.cells else "tetra10"
    tetra = mesh.cells[kind]
    targets = boundary.corner_targets(mesh.points, progress)
    left = _settle(mesh.points, tetra[:, :4], targets, boundary.nearest)
    if tetra.shape[1] == 10:
        targets = boundary.middle_targets(mesh.points, progress)
        left = max(left, _bend(mesh.points, tetra, targets))
    return left


def _settle(
    points: np.ndarray, tetra: np.ndarray, targets: Dict[int, np.ndarray], nearest: Any
) -> float:
    """Corners to their targets; returns how far they stay off at most."""
    if not targets:
        return 0.0
    start = points.copy()
    floor = KEPT * _smallest_jacobian(start, tetra)
    for node, place in targets.items():
        points[node] = place
    _untangle(points, tetra, floor, targets, nearest)
    wanted = points - start
    # What has moved and is still in the way moves less.
    moved = np.flatnonzero((wanted != 0).any(axis=1))
    share = np.ones(len(points))
    near = np.flatnonzero(np.isin(tetra, moved).any(axis=1))
    for round in range(HALVINGS + len(near)):
        points[moved] = start[moved] + share[moved, None] * wanted[moved]
        bad = near[_smallest_jacobian(points, tetra[near]) < floor[near]]
        if not len(bad):
            break
        share[np.unique(tetra[bad])] *= 0.5 if round < HALVINGS else 0.0
    fixed = np.array(sorted(targets))
    return float(np.linalg.norm((1 - share[fixed, None]) * wanted[fixed], axis=1).max())


def _untangle(
    points: np.ndarray,
    tetra: np.ndarray,
    floor: np.ndarray,
    targets: Dict[int, np.ndarray],
    nearest: Any,
) -> None:
    """Moves corners of tetrahedra below their floor, each to where the least of its tetrahedra,
    measured by their floors, is largest among a few places (a pattern search)."""
    bad = np.flatnonzero(_smallest_jacobian(points, tetra) < floor)
    if not len(bad):
        return
    order = np.argsort(tetra, axis=None, kind="stable")
    ends = np.searchsorted(tetra.reshape(-1)[order], np.arange(len(points) + 1))
    unit = np.maximum(np.abs(floor), np.finfo(float).tiny)
    for _ in range(ROUNDS):
        for node in np.unique(tetra[bad]).tolist():
            cells = order[ends[node] : ends[node + 1]] // 4
            corners = points[tetra[cells]]
            here = tetra[cells] == node

            def least(place: np.ndarray) -> float:
                corners[here] = place
                volume = np.linalg.det(corners[:, 1:] - corners[:, :1])
                return float((volume / unit[cells]).min())

            best, place = least(points[node]), points[node].copy()
            if best >= ENOUGH:
                continue
            size = np.linalg.norm(corners - place, axis=2)
            size = size[size > 0].min()
            for step in STEPS:
                for direction in _directions(corners, here, place, unit[cells]):
                    tried = points[node] + step * size * direction
                    if node in targets:
                        tried = np.array(nearest(node, tried))
                    value = least(tried)
                    if value > best:
                        best, place = value, tried
            points[node] = place
        bad = np.flatnonzero(_smallest_jacobian(points, tetra) < floor)
        if not len(bad):
            return


def _directions(
    corners: np.ndarray, here: np.ndarray, place: np.ndarray, unit: np.ndarray
) -> np.ndarray:
    """Unit vectors: along the axes, and away from the opposite faces of the worst tetrahedra."""
    corners[here] = place
    volume = np.linalg.det(corners[:, 1:] - corners[:, :1]) / unit
    found = [*np.eye(3), *-np.eye(3)]
    for cell in np.argsort(volume)[:3]:
        k = int(np.flatnonzero(here[cell])[0])
        a, b, c = (corners[cell][n] for n in OPPOSITE[k])
        normal = np.cross(b - a, c - a)
        length = np.linalg.norm(normal)
        if length > 0:
            found.append(normal / length)
    return np.array(found)


def _bend(points: np.ndarray, tetra: np.ndarray, targets: Dict[int, np.ndarray]) -> float:
    """Mid-nodes: straight first, then those on the boundary to their targets as far as they can."""
    straight = points.copy()
    moving = np.zeros(len(points), bool)
    for k, (a, b) in enumerate(TETRA_EDGES):
        straight[tetra[:, 4 + k]] = 0.5 * (points[tetra[:, a]] + points[tetra[:, b]])
    wanted = np.zeros_like(points)
    for node, place in targets.items():
        wanted[node] = place - straight[node]
        moving[node] = True
    near = np.flatnonzero(moving[tetra].any(axis=1))
    floor = KEPT * _smallest_jacobian(straight, tetra[near])
    share = np.ones(len(points))
    for round in range(HALVINGS + len(near)):
        points[:] = straight + share[:, None] * wanted
        bad = near[_smallest_jacobian(points, tetra[near]) < floor]
        if not len(bad):
            break
        share[np.unique(tetra[bad][:, 4:])] *= 0.5 if round < HALVINGS else 0.0
    return float(np.linalg.norm((1 - share[:, None]) * wanted, axis=1).max())


class _Boundary:
    """The nodes of the groups FaceN and where they belong."""

    def __init__(self, mesh: Mesh, shape: Any):
        self.faces_of: Dict[int, FrozenSet[int]] = {}
        self._middles: Dict[int, Tuple[int, int]] = {}
        of: Dict[int, set] = {}
        for name, (kind, cells) in mesh.groups.items():
            if (
                kind not in ("triangle", "triangle6")
                or not name[4:].isdigit()
                or name[:4] != "Face"
            ):
                continue
            rows = mesh.cells[kind][cells]
            for node in np.unique(rows).tolist():
                of.setdefault(node, set()).add(int(name[4:]))
            for k, (a, b) in enumerate(TRIANGLE_EDGES[: rows.shape[1] - 3]):
                self._middles.update(
                    zip(rows[:, 3 + k].tolist(), zip(rows[:, a].tolist(), rows[:, b].tolist()))
                )
        self.faces_of = {node: frozenset(faces) for node, faces in sorted(of.items())}
        self._carriers = _Carriers(shape)

    def nearest(self, node: int, place: np.ndarray) -> Tuple[float, float, float]:
        """The point of the node's face or edge that is nearest to a place; a corner stays."""
        return self._carriers.nearest(self.faces_of[node], place)

    def corner_targets(
        self, points: np.ndarray, progress: Optional[Callable[[float], Any]]
    ) -> Dict[int, np.ndarray]:
        nodes = [node for node in self.faces_of if node not in self._middles]
        return self._targets(nodes, points, progress)

    def middle_targets(
        self, points: np.ndarray, progress: Optional[Callable[[float], Any]]
    ) -> Dict[int, np.ndarray]:
        nodes = [node for node in self.faces_of if node in self._middles]
        middles = points.copy()
        for node in nodes:
            a, b = self._middles[node]
            middles[node] = 0.5 * (points[a] + points[b])
        return self._targets(nodes, middles, progress)

    def _targets(
        self, nodes: List[int], points: np.ndarray, progress: Optional[Callable[[float], Any]]
    ) -> Dict[int, np.ndarray]:
        result = {}
        for done, node in enumerate(nodes):
            if progress is not None and done % 200 == 0 and progress(done / len(nodes)) is False:
                raise Cancelled("cancelled")
            result[node] = np.array(self.nearest(node, points[node]))
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
