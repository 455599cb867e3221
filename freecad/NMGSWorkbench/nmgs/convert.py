# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splitting, outer faces and raising the order of a mesh, with its groups."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from . import _kernel
from .mesh import CELL_TYPES, Group, Mesh

Progress = Optional[Callable[[float], Any]]

_QUADRATIC = {
    "line": "line3",
    "triangle": "triangle6",
    "quad": "quad8",
    "tetra": "tetra10",
    "pyramid": "pyramid13",
    "wedge": "wedge15",
    "hexahedron": "hexahedron20",
}


def _refuse(mesh: Mesh, names: "set[str]", why: str) -> None:
    for name in mesh.cells:
        if name in names and len(mesh.cells[name]):
            raise ValueError(f"cells: {len(mesh.cells[name])} cells of type {name!r}: {why}")


def _children(indices: np.ndarray, each: int, base: int) -> np.ndarray:
    return (
        (base + each * indices[:, None] + np.arange(each, dtype=np.int32)).astype(np.int32).ravel()
    )


def _flip(quads: np.ndarray, pairs: np.ndarray, chosen: np.ndarray) -> None:
    """Gives the pairs of triangles of the chosen quads the other diagonal, in place."""
    a, b, c, d = quads[chosen].T
    joined = pairs[chosen, 2] == d
    pairs[chosen, 2] = np.where(joined, c, d)
    pairs[chosen, 5] = np.where(joined, a, b)


def split(mesh: Mesh, progress: Progress = None) -> Mesh:
    """Quads to two triangles, hexahedra to twelve tetrahedra; see Mesh.split."""
    _refuse(mesh, set(_QUADRATIC.values()), "split the linear mesh, then raise its order")
    _refuse(mesh, {"wedge", "pyramid"}, "only quads and hexahedra are split")
    kernel = _kernel.core()
    points = mesh.points
    cells = {k: v for k, v in mesh.cells.items() if k not in ("quad", "hexahedron")}
    bases: Dict[str, Tuple[str, int, int]] = {}
    flipped = np.zeros((0, 4), dtype=np.int32)
    if "hexahedron" in mesh.cells:
        points, new, flipped = kernel.hexahedra_to_tetrahedra(
            points, mesh.cells["hexahedron"], progress
        )
        old = cells.get("tetra")
        bases["hexahedron"] = ("tetra", 12, 0 if old is None else len(old))
        cells["tetra"] = new if old is None else np.concatenate([old, new])
    if "quad" in mesh.cells:
        solid = any(CELL_TYPES[name][1] == 3 for name in mesh.cells)
        new = kernel.quads_to_triangles(mesh.points, mesh.cells["quad"], solid, progress)
        if len(flipped):
            quads = mesh.cells["quad"]
            _flip(quads, new.reshape(-1, 6), np.isin(_keys(quads), _keys(flipped)))
        old = cells.get("triangle")
        bases["quad"] = ("triangle", 2, 0 if old is None else len(old))
        cells["triangle"] = new if old is None else np.concatenate([old, new])
    groups: Dict[str, Group] = {}
    for name, (kind, indices) in mesh.groups.items():
        if kind in bases:
            child, each, base = bases[kind]
            groups[name] = (child, _children(indices, each, base))
        else:
            groups[name] = (kind, indices)
    return Mesh(points, cells, groups, model=mesh.model)


def _keys(nodes: np.ndarray) -> np.ndarray:
    """Rows of corner nodes as comparable values, whatever corner they start from."""
    wide = np.full((len(nodes), 4), -1, dtype=np.int32)
    wide[:, : nodes.shape[1]] = nodes
    wide.sort(axis=1)
    return np.ascontiguousarray(wide).view([("", np.int32)] * 4).ravel()


def _corners(name: str, nodes: np.ndarray) -> np.ndarray:
    return nodes[:, : 3 if name.startswith("triangle") else 4]


def boundary_with_parents(
    mesh: Mesh, progress: Progress = None
) -> Tuple[Mesh, np.ndarray, Dict[str, Tuple[List[str], np.ndarray, np.ndarray]]]:
    """The surface of Mesh.boundary, its points' numbers in the mesh, and where its cells come from:
    name -> (names of the mesh's cell types, which of them, cell number), one entry a cell."""
    raw = _kernel.core().boundary(len(mesh.points), mesh.cells, progress)
    used = np.zeros(len(mesh.points), dtype=bool)
    for nodes, _, _ in raw.values():
        used[nodes] = True
    kept = np.flatnonzero(used).astype(np.int32)
    number = np.full(len(mesh.points), -1, dtype=np.int32)
    number[kept] = np.arange(len(kept), dtype=np.int32)
    cells = {name: number[nodes] for name, (nodes, _, _) in raw.items()}
    groups: Dict[str, Group] = {}
    for group, (kind, indices) in mesh.groups.items():
        if kind == "node":
            inside = number[indices]
            groups[group] = ("node", inside[inside >= 0])
        elif kind in raw and kind in mesh.cells and CELL_TYPES[kind][1] == 2:
            wanted = _keys(_corners(kind, mesh.cells[kind][indices]))
            found = np.isin(_keys(_corners(kind, raw[kind][0])), wanted)
            groups[group] = (kind, np.flatnonzero(found).astype(np.int32))
    names = list(mesh.cells)
    parents = {name: (names, blocks, cell) for name, (_, blocks, cell) in raw.items()}
    return Mesh(mesh.points[kept], cells, groups), kept, parents


def _raised_nodes(mesh: Mesh, raised: Dict[str, Any]) -> Dict[str, Group]:
    """Node groups with the mid-side nodes that belong to them; see Mesh.to_order."""
    node_groups = {k: v for k, v in mesh.groups.items() if v[0] == "node"}
    if not node_groups:
        return {}
    points = len(mesh.points)
    ends = raised["ends"]
    free = np.zeros(len(ends), dtype=bool)
    outer = _kernel.core().boundary(points + len(ends), raised["cells"], None)
    for nodes in [v[0] for v in outer.values()] + [raised["cells"].get("line3")]:
        if nodes is not None:
            middle = nodes[nodes >= points] - points
            free[middle] = True
    groups: Dict[str, Group] = {}
    for name, (kind, indices) in node_groups.items():
        member = np.zeros(points, dtype=bool)
        member[indices] = True
        taken = member[ends].all(axis=1) & free
        for cell_type, nodes in raised["cells"].items():
            corners = CELL_TYPES[_linear(cell_type)][0]
            whole = nodes[member[nodes[:, :corners]].all(axis=1)][:, corners:]
            taken[whole.ravel() - points] = True
        new = (points + np.flatnonzero(taken)).astype(np.int32)
        groups[name] = ("node", np.concatenate([indices, new]))
    return groups


def _linear(name: str) -> str:
    return next(k for k, v in _QUADRATIC.items() if v == name)


def to_order(mesh: Mesh, order: int, progress: Progress = None) -> Mesh:
    """Quadratic cells; see Mesh.to_order."""
    if order == 1 and not any(name in mesh.cells for name in _QUADRATIC.values()):
        return mesh
    if order != 2:
        raise ValueError(f"order: expected 2, got {order!r}")
    _refuse(mesh, set(_QUADRATIC.values()), "they are quadratic already")
    blocks = mesh.model
    model = None if blocks is None else (blocks.nodes, blocks.divisions, blocks.spacing)
    raised = _kernel.core().raise_order(mesh.points, mesh.cells, model, progress)
    groups: Dict[str, Group] = _raised_nodes(mesh, raised)
    for name, (kind, indices) in mesh.groups.items():
        if kind != "node":
            groups[name] = (_QUADRATIC[kind], indices)
    result = Mesh(raised["points"], raised["cells"], groups, model=mesh.model)
    result.mid_side_ends = raised["ends"]
    return result


def _labels(mesh: Mesh, cell_type: str) -> np.ndarray:
    """A number for each cell of the type: equal where the cell is in the same groups."""
    member = [
        np.isin(np.arange(len(mesh.cells[cell_type])), indices)
        for kind, indices in mesh.groups.values()
        if kind == cell_type
    ]
    if not member:
        return np.zeros(0, dtype=np.int32)
    return np.unique(np.array(member), axis=1, return_inverse=True)[1].astype(np.int32).ravel()


def _grown(group: np.ndarray, points: int, corners: np.ndarray, first: int) -> np.ndarray:
    """A node group with those of the nodes from `first` on whose corners are all in it."""
    member = np.zeros(points, dtype=bool)
    member[group[group < points]] = True
    new = (first + np.flatnonzero(member[corners].all(axis=1))).astype(np.int32)
    return np.concatenate([group, new])


def _halved(mesh: Mesh, progress: Progress) -> Mesh:
    """All quads: a triangle gives three, a quad four, round a node at the mean of its corners."""
    raised = to_order(mesh, 2, progress)
    points = [raised.points]
    quads: List[np.ndarray] = []
    groups = {name: group for name, group in raised.groups.items() if group[0] == "node"}
    first, base = len(raised.points), 0
    for name, corners in (("triangle", 3), ("quad", 4)):
        if name not in mesh.cells:
            continue
        cells = mesh.cells[name]
        points.append(mesh.points[cells].mean(axis=1))
        quads.append(_kernel.core().corner_quads(raised.cells[_QUADRATIC[name]], first))
        for group, (kind, indices) in mesh.groups.items():
            if kind == name:
                groups[group] = ("quad", _children(indices, corners, base))
            elif kind == "node":
                groups[group] = ("node", _grown(groups[group][1], len(mesh.points), cells, first))
        first += len(cells)
        base += corners * len(cells)
    cells = {"quad": np.concatenate(quads)}
    if "line" in mesh.cells:
        a, b, m = raised.cells["line3"].T
        cells["line"] = np.stack([a, m, m, b], axis=1).reshape(-1, 2)
        for group, (kind, indices) in mesh.groups.items():
            if kind == "line":
                groups[group] = ("line", _children(indices, 2, 0))
    return Mesh(np.concatenate(points), cells, groups)


def _paired(mesh: Mesh, progress: Progress) -> Mesh:
    """Pairs of triangles as quads, behind the quads that are there; triangles without a partner
    stay."""
    quads, parents, left = _kernel.core().pair_triangles(
        mesh.points, mesh.cells["triangle"], _labels(mesh, "triangle"), progress
    )
    old = mesh.cells.get("quad", np.zeros((0, 4), dtype=np.int32))
    cells = {name: nodes for name, nodes in mesh.cells.items() if name not in ("triangle", "quad")}
    cells["quad"] = np.concatenate([old, quads])
    if len(left):
        cells["triangle"] = mesh.cells["triangle"][left]
    groups: Dict[str, Group] = {}
    for name, (kind, indices) in mesh.groups.items():
        if kind != "triangle":
            groups[name] = (kind, indices)
            continue
        inside = (len(old) + np.flatnonzero(np.isin(parents[:, 0], indices))).astype(np.int32)
        rest = np.flatnonzero(np.isin(left, indices)).astype(np.int32)
        if len(rest) and len(inside):
            groups[name], groups[name + " triangles"] = ("quad", inside), ("triangle", rest)
        else:
            groups[name] = ("triangle", rest) if len(rest) else ("quad", inside)
    return Mesh(mesh.points, cells, groups)


def to_quads(mesh: Mesh, method: str, progress: Progress = None) -> Mesh:
    """See Mesh.to_quads."""
    if method not in ("split", "match"):
        raise ValueError(f"method: expected 'split' or 'match', got {method!r}")
    _refuse(mesh, {name for name, row in CELL_TYPES.items() if row[1] == 3}, "not a surface")
    _refuse(mesh, set(_QUADRATIC.values()), "convert the linear mesh, then raise its order")
    if not len(mesh.cells.get("triangle", ())):
        return mesh
    if method == "match":
        mesh = _paired(mesh, progress)
        if "triangle" not in mesh.cells:
            return mesh
    result = _halved(mesh, progress)
    for name in list(result.groups):
        whole = name[: -len(" triangles")]
        if method == "match" and name.endswith(" triangles") and whole in result.groups:
            both = np.concatenate([result.groups[whole][1], result.groups.pop(name)[1]])
            result.groups[whole] = ("quad", np.sort(both))
    return result


def to_hexes(mesh: Mesh, progress: Progress = None) -> Mesh:
    """See Mesh.to_hexes."""
    _refuse(mesh, {"hexahedron", "wedge", "pyramid", "quad"}, "only tetrahedra become hexahedra")
    _refuse(mesh, set(_QUADRATIC.values()), "convert the linear mesh, then raise its order")
    if "tetra" not in mesh.cells:
        return mesh
    raised = to_order(mesh, 2, progress)
    tetra, count = mesh.cells["tetra"], len(mesh.points)
    triangles = mesh.cells.get("triangle", np.zeros((0, 3), dtype=np.int32))
    first = len(raised.points)
    hexahedra, faces, face_of = _kernel.core().tetrahedra_to_hexahedra(
        first, raised.cells["tetra10"], triangles, progress
    )
    points = np.concatenate(
        [raised.points, mesh.points[faces].mean(axis=1), mesh.points[tetra].mean(axis=1)]
    )
    cells = {"hexahedron": hexahedra}
    if len(triangles):
        quads = _kernel.core().corner_quads(raised.cells["triangle6"], 0)
        quads[:, 2] = first + np.repeat(face_of, 3)
        cells["quad"] = quads
    if "line" in mesh.cells:
        a, b, m = raised.cells["line3"].T
        cells["line"] = np.stack([a, m, m, b], axis=1).reshape(-1, 2)
    each = {"tetra": ("hexahedron", 4), "triangle": ("quad", 3), "line": ("line", 2)}
    groups: Dict[str, Group] = {}
    for name, (kind, indices) in mesh.groups.items():
        if kind == "node":
            nodes = _grown(raised.groups[name][1], count, faces, first)
            groups[name] = ("node", _grown(nodes, count, tetra, first + len(faces)))
        else:
            child, number = each[kind]
            groups[name] = (child, _children(indices, number, 0))
    return Mesh(points, cells, groups)
