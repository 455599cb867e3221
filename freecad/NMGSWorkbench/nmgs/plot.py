# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a mesh is drawn: polygons and lines of its outer faces, by the thesis's plot options.

No window and no drawing here; the 3D view and the picture export draw what these functions give.
"""

from __future__ import annotations

import dataclasses
from typing import Dict, List, Optional, Sequence, Tuple

import numpy as np

from . import _kernel
from .cell_sides import SIDES
from .mesh import CELL_TYPES, Mesh

#: Mid-side node of the edge between two corners, VTK's numbering of quadratic cells.
_MID_SIDES: Dict[str, Tuple[Tuple[int, int], ...]] = {
    "hexahedron": (
        ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4))
        + ((0, 4), (1, 5), (2, 6), (3, 7))
    ),
    "tetra": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
    "wedge": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)),
    "pyramid": ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)),
    "quad": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "triangle": ((0, 1), (1, 2), (2, 0)),
}
#: Quadratic cells and the linear ones on their corners.
LINEAR = {
    "line3": "line",
    "triangle6": "triangle",
    "quad8": "quad",
    "tetra10": "tetra",
    "pyramid13": "pyramid",
    "wedge15": "wedge",
    "hexahedron20": "hexahedron",
}
#: A quadratic face, corners and mid-side nodes, as flat pieces.
_PIECES = {
    8: ((0, 4, 7), (4, 1, 5), (5, 2, 6), (6, 3, 7), (4, 5, 6, 7)),
    6: ((0, 3, 5), (3, 1, 4), (4, 2, 5), (3, 4, 5)),
    4: ((0, 1, 2, 3),),
    3: ((0, 1, 2),),
}
#: Round a face: nodes of its outline.
_OUTLINE = {
    8: (0, 4, 1, 5, 2, 6, 3, 7),
    6: (0, 3, 1, 4, 2, 5),
    4: (0, 1, 2, 3),
    3: (0, 1, 2),
}


@dataclasses.dataclass(frozen=True)
class PlotOptions:
    """simplices: triangles for quads, tetrahedra for hexahedra. directions: whether faces across
    xi, eta, zeta of the blocks are drawn (of surfaces: lines along xi, eta). cut: (point, normal)
    of a plane; cells with their middle on the normal's side are left out. shrink: 0 to 0.9, how
    much each cell is drawn smaller than it is."""

    simplices: bool = False
    directions: Tuple[bool, bool, bool] = (True, True, True)
    cut: Optional[Tuple[Sequence[float], Sequence[float]]] = None
    shrink: float = 0.0

    def __post_init__(self) -> None:
        if not 0.0 <= self.shrink <= 0.9:
            raise ValueError(f"shrink: expected 0 to 0.9, got {self.shrink!r}")
        if len(self.directions) != 3:
            raise ValueError(f"directions: expected three, got {self.directions!r}")


@dataclasses.dataclass
class Plot:
    """points: float32 (P, 3). polygons: (K, 3) and (L, 4) int32 arrays of indices into points, with
    the cell of each polygon: `cells[i]` are rows (type number in `types`, cell). lines: int32
    (E, 2). Cells are those of the drawn mesh: `mesh`, which is split where the options say so."""

    mesh: Mesh
    types: List[str]
    points: np.ndarray
    polygons: List[np.ndarray]
    cells: List[np.ndarray]
    lines: np.ndarray

    def cell_values(self, metric: str) -> List[np.ndarray]:
        """The metric of the cell behind each polygon, NaN where it is not defined."""
        by_type = self.mesh.quality(metric)
        result = []
        for owners in self.cells:
            values = np.full(len(owners), np.nan)
            for number, name in enumerate(self.types):
                mine = owners[:, 0] == number
                if name in by_type and mine.any():
                    values[mine] = by_type[name][owners[mine, 1]]
            result.append(values)
        return result


def dimension_of(mesh: Mesh) -> int:
    """The highest dimension of its cells; 0 for none."""
    return max((CELL_TYPES[name][1] for name, nodes in mesh.cells.items() if len(nodes)), default=0)


def plot(
    mesh: Mesh,
    options: PlotOptions = PlotOptions(),
    only: Optional[Dict[str, np.ndarray]] = None,
) -> Plot:
    """What is seen of a mesh. only: {cell type: indices}, these cells alone. Raises ValueError."""
    if options.simplices:
        mesh = _split(mesh)
    top = dimension_of(mesh)
    types = [n for n, nodes in mesh.cells.items() if CELL_TYPES[n][1] == top and len(nodes)]
    chosen = {name: np.arange(len(mesh.cells[name])) for name in types}
    if only is not None:
        chosen = {name: np.asarray(only.get(name, ()), dtype=np.int64) for name in types}
    if options.cut is not None:
        chosen = {name: _kept(mesh, name, ids, options.cut) for name, ids in chosen.items()}
    if top == 3:
        faces = _outer_faces(mesh, types, chosen, options.directions)
        if options.shrink:
            faces = _all_faces(mesh, types, faces)
    else:
        faces = [
            (mesh.cells[name][ids], np.column_stack([np.full(len(ids), number), ids]))
            for number, name in enumerate(types)
            for ids in (chosen[name],)
        ]
    return _drawn(mesh, types, faces, options, top)


def linear(mesh: Mesh) -> Mesh:
    """The linear mesh on the corners of quadratic cells; its points are those in use. Groups of
    nodes keep the corners among them. Meshes of linear cells are given back as they are."""
    if not any(name in LINEAR for name in mesh.cells):
        return mesh
    cells: Dict[str, np.ndarray] = {}
    for name, nodes in mesh.cells.items():
        to = LINEAR.get(name, name)
        if to in cells:
            raise ValueError(f"mesh: {to} cells of both orders cannot be told apart by one name")
        cells[to] = nodes[:, : CELL_TYPES[to][0]]
    used = np.zeros(len(mesh.points), dtype=bool)
    for nodes in cells.values():
        used[nodes.ravel()] = True
    number = np.cumsum(used) - 1
    groups = {}
    for name, (kind, members) in mesh.groups.items():
        if kind == "node":
            groups[name] = (kind, number[members[used[members]]])
        else:
            groups[name] = (LINEAR.get(kind, kind), members)
    cells = {name: number[nodes] for name, nodes in cells.items()}
    return Mesh(mesh.points[used], cells, groups, model=mesh.model)


def _split(mesh: Mesh) -> Mesh:
    """Simplices on the corners: what is drawn of quadratic cells is their linear part."""
    cells = {
        LINEAR.get(name, name): nodes[:, : CELL_TYPES[LINEAR.get(name, name)][0]]
        for name, nodes in mesh.cells.items()
    }
    if not {"quad", "hexahedron"} & set(cells):
        return Mesh(mesh.points, cells)
    top = max(CELL_TYPES[name][1] for name in cells)
    cells = {name: nodes for name, nodes in cells.items() if CELL_TYPES[name][1] == top}
    return Mesh(mesh.points, cells).split()


def _kept(mesh: Mesh, name: str, ids: np.ndarray, cut: Tuple) -> np.ndarray:
    point, normal = (np.asarray(v, dtype=np.float64) for v in cut)
    if not np.linalg.norm(normal) > 0:
        raise ValueError(f"cut: expected a normal with a length, got {cut[1]!r}")
    # By the corners: mid-side nodes are not evenly spread round a cell.
    corners = CELL_TYPES[LINEAR.get(name, name)][0]
    height = (mesh.points - point) @ normal
    return ids[height[mesh.cells[name][ids, :corners]].mean(axis=1) <= 0]


def _outer_faces(mesh: Mesh, types: List[str], chosen: Dict, directions: Sequence[bool]) -> List:
    parts = {name: mesh.cells[name][chosen[name]] for name in types}
    names = list(parts)
    result = []
    for faces, blocks, cells in (
        _kernel.core().boundary(len(mesh.points), parts).values() if parts else ()
    ):
        owners = np.empty((len(faces), 2), dtype=np.int64)
        owners[:, 0] = blocks
        for number, name in enumerate(names):
            mine = blocks == number
            owners[mine, 1] = chosen[name][cells[mine]]
        if not all(directions):
            shown = _directions(mesh, types, faces, owners)
            keep = (shown < 0) | np.asarray(directions, dtype=bool)[shown]
            faces, owners = faces[keep], owners[keep]
        result.append((faces, owners))
    return result


def _directions(mesh: Mesh, types: List[str], faces: np.ndarray, owners: np.ndarray) -> np.ndarray:
    """0, 1, 2 for faces across xi, eta, zeta of their hexahedron; -1 for those of other cells."""
    result = np.full(len(faces), -1)
    corners = np.sort(faces[:, : 4 if faces.shape[1] in (4, 8) else 3], axis=1)
    for number, name in enumerate(types):
        if LINEAR.get(name, name) != "hexahedron":
            continue
        mine = np.flatnonzero(owners[:, 0] == number)
        nodes = mesh.cells[name][owners[mine, 1]]
        for local, face in enumerate(SIDES["hexahedron"]):
            same = (np.sort(nodes[:, face], axis=1) == corners[mine]).all(axis=1)
            result[mine[same]] = local // 2
    return result


def _all_faces(mesh: Mesh, types: List[str], faces: List) -> List:
    """Every face of the cells that have one of the faces."""
    result: List = []
    owners = np.unique(np.concatenate([own for _, own in faces]), axis=0) if faces else []
    for number, name in enumerate(types):
        linear = LINEAR.get(name, name)
        mine = owners[owners[:, 0] == number] if len(owners) else np.zeros((0, 2), dtype=int)
        nodes = mesh.cells[name][mine[:, 1]]
        for face in SIDES[linear]:
            result.append((nodes[:, _with_mid_sides(linear, face, name != linear)], mine))
    return result


def _with_mid_sides(linear: str, face: Sequence[int], quadratic: bool) -> List[int]:
    if not quadratic:
        return list(face)
    first = CELL_TYPES[linear][0]
    at = {frozenset(edge): first + n for n, edge in enumerate(_MID_SIDES[linear])}
    return [*face, *(at[frozenset((a, b))] for a, b in zip(face, (*face[1:], face[0])))]


def _drawn(mesh: Mesh, types: List[str], faces: List, options: PlotOptions, top: int) -> Plot:
    points = mesh.points
    if options.shrink:
        points, faces = _shrunk(mesh, types, faces, options.shrink)
    polygons: Dict[int, List] = {3: [], 4: []}
    owners_of: Dict[int, List] = {3: [], 4: []}
    lines: List[np.ndarray] = []
    for nodes, owners in faces:
        width = nodes.shape[1]
        if top == 1:
            lines.append(nodes[:, :2])
            continue
        # A surface seen along one direction alone is its lines along that direction.
        along = options.directions if top == 2 and width in (4, 8) else (True,) * 3
        if all(along[:2]):
            for piece in _PIECES[width]:
                polygons[len(piece)].append(nodes[:, piece])
                owners_of[len(piece)].append(owners)
        outline = _OUTLINE[width]
        sides = 3 if width in (3, 6) else 4
        step = len(outline) // sides
        for n, a in enumerate(outline):
            if along[(n // step) % 2] or sides == 3:
                lines.append(nodes[:, (a, outline[(n + 1) % len(outline)])])
    empty2 = np.zeros((0, 2), dtype=np.int64)
    drawn = [
        np.concatenate(polygons[k]) if polygons[k] else np.zeros((0, k), dtype=np.int64)
        for k in (3, 4)
    ]
    cells = [np.concatenate(owners_of[k]) if owners_of[k] else empty2 for k in (3, 4)]
    edges = _unique_lines(np.concatenate(lines), len(points)) if lines else empty2
    return _compact(mesh, types, points, drawn, cells, edges)


def _shrunk(mesh: Mesh, types: List[str], faces: List, shrink: float) -> Tuple[np.ndarray, List]:
    """Points of their own for each face, moved towards their cell's middle."""
    points: List[np.ndarray] = []
    result = []
    before = 0
    for nodes, owners in faces:
        middle = np.empty((len(nodes), 3))
        for number, name in enumerate(types):
            mine = owners[:, 0] == number
            corners = CELL_TYPES[LINEAR.get(name, name)][0]
            cells = mesh.cells[name][owners[mine, 1], :corners]
            middle[mine] = mesh.points[cells].mean(axis=1)
        places = mesh.points[nodes]
        places = places + shrink * (middle[:, None, :] - places)
        points.append(places.reshape(-1, 3))
        result.append((before + np.arange(nodes.size).reshape(nodes.shape), owners))
        before += nodes.size
    return np.concatenate(points) if points else np.zeros((0, 3)), result


def _unique_lines(lines: np.ndarray, count: int) -> np.ndarray:
    low, high = lines.min(axis=1).astype(np.int64), lines.max(axis=1).astype(np.int64)
    keys = np.unique(low * count + high)
    return np.column_stack([keys // count, keys % count])


def _compact(
    mesh: Mesh,
    types: List[str],
    points: np.ndarray,
    polygons: List[np.ndarray],
    cells: List[np.ndarray],
    lines: np.ndarray,
) -> Plot:
    used = np.zeros(len(points), dtype=bool)
    for nodes in (*polygons, lines):
        used[nodes.ravel()] = True
    number = np.cumsum(used) - 1
    return Plot(
        mesh=mesh,
        types=types,
        points=points[used].astype(np.float32),
        polygons=[number[nodes].astype(np.int32) for nodes in polygons],
        cells=cells,
        lines=number[lines].astype(np.int32),
    )
