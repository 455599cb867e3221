# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elmer's mesh: a folder with mesh.header, mesh.nodes, mesh.elements, mesh.boundary, mesh.names
(ElmerSolver manual, appendix "Format of mesh files"). Neither meshio nor FreeCAD writes it."""

from __future__ import annotations

import os
import re
from typing import Any, Dict, List, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .errors import FormatError
from .group_partition import one_number
from .mesh import CELL_TYPES, Mesh
from .text_rows import slices, write_rows
from .text_sections import Lines, reader
from . import _kernel

#: Elmer's number of a cell type, and its nodes as indices into ours (elements.def of Elmer).
TYPES: Dict[str, Tuple[int, Any]] = {
    "line": (202, None),
    "line3": (203, None),
    "triangle": (303, None),
    "triangle6": (306, None),
    "quad": (404, None),
    "quad8": (408, None),
    "tetra": (504, None),
    "tetra10": (510, None),
    "pyramid": (605, None),
    "pyramid13": (613, None),
    "wedge": (706, None),
    "wedge15": (715, None),
    "hexahedron": (808, None),
    "hexahedron20": (
        820,
        (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15),
    ),
}
_POINT = 101


def write_elmer(path: str, mesh: Mesh) -> None:
    """path: the folder; it is made where it is missing.

    Groups of the highest dimension are bodies, those of one less boundaries, with the names in
    mesh.names; cells in no group are one body. Each boundary face names the elements on both of its
    sides. Cells that are in many groups belong to the first; groups of nodes and of still lower
    dimension are boundaries of point elements and edges.
    """
    top = max((CELL_TYPES[name][1] for name in mesh.cells), default=0)
    bulk = {name: n for name, n in mesh.cells.items() if CELL_TYPES[name][1] == top}
    lower = {name: n for name, n in mesh.cells.items() if CELL_TYPES[name][1] < top}
    bodies = [n for n, (kind, _) in mesh.groups.items() if kind in bulk]
    others = [n for n, (kind, _) in mesh.groups.items() if kind not in bulk]
    body = {name: at for at, name in enumerate(bodies, 1)}
    boundary = {name: at for at, name in enumerate(others, 1)}
    os.makedirs(path, exist_ok=True)
    with replaced_file(os.path.join(path, "mesh.nodes")) as file:
        write_rows(file, "{} -1 {} {} {}\n", mesh.points, first=1)
    counts: Dict[int, int] = {}
    first: Dict[str, int] = {}
    number = 1
    with replaced_file(os.path.join(path, "mesh.elements")) as file:
        for kind, nodes in bulk.items():
            first[kind] = number
            label = one_number(mesh, kind, body)
            label[label == 0] = len(bodies) + 1
            code, order = TYPES[kind]
            _write_cells(file, "{} {} " + str(code), nodes, number, [label], order)
            counts[code] = counts.get(code, 0) + len(nodes)
            number += len(nodes)
    written = 0
    with replaced_file(os.path.join(path, "mesh.boundary")) as file:
        for kind, nodes in lower.items():
            label = one_number(mesh, kind, boundary)
            chosen = np.flatnonzero(label)
            code, order = TYPES[kind]
            parents = _parents(mesh, bulk, first, kind, nodes[chosen])
            columns = [label[chosen], parents[:, 0], parents[:, 1]]
            _write_cells(
                file, "{} {} {} {} " + str(code), nodes[chosen], written + 1, columns, order
            )
            counts[code] = counts.get(code, 0) + len(chosen)
            written += len(chosen)
        for name, (kind, indices) in mesh.groups.items():
            if kind == "node":
                head = f"{{}} {boundary[name]} 0 0 {_POINT} {{}}\n"
                write_rows(file, head, indices[:, None], first=written + 1, add=1)
                counts[_POINT] = counts.get(_POINT, 0) + len(indices)
                written += len(indices)
    with replaced_file(os.path.join(path, "mesh.names")) as file:
        file.write("! ----- names for bodies -----\n")
        file.writelines(f"$ {_plain(name)} = {at}\n" for name, at in body.items())
        file.write("! ----- names for boundaries -----\n")
        file.writelines(f"$ {_plain(name)} = {at}\n" for name, at in boundary.items())
    # Last, so that a folder with a header is whole.
    with replaced_file(os.path.join(path, "mesh.header")) as file:
        file.write(f"{len(mesh.points)} {number - 1} {written}\n{len(counts)}\n")
        file.writelines(f"{code} {count}\n" for code, count in counts.items())


def _plain(name: str) -> str:
    return re.sub(r"\W", "_", name)


def _write_cells(
    file: TextIO,
    head: str,
    nodes: np.ndarray,
    number: int,
    columns: List[np.ndarray],
    order: Any,
) -> None:
    template = head + " {}" * nodes.shape[1] + "\n"
    for part in slices(len(nodes)):
        rows = nodes[part] if order is None else nodes[part][:, list(order)]
        labels = np.column_stack([column[part] for column in columns])
        write_rows(file, template, np.hstack([labels, rows + 1]), first=number + part.start)


def _parents(
    mesh: Mesh, bulk: Dict[str, np.ndarray], first: Dict[str, int], kind: str, rows: np.ndarray
) -> np.ndarray:
    """int (M, 2): numbers of the elements with the face or edge, 0 where there is none."""
    corners = {"line": 2, "triangle": 3, "quad": 4}[re.sub(r"\d", "", kind)]
    result = np.zeros((len(rows), 2), dtype=np.int64)
    place = {tuple(key): at for at, key in enumerate(np.sort(rows[:, :corners], axis=1).tolist())}
    if not place:
        return result
    touched = np.unique(rows[:, :corners])
    top = max(CELL_TYPES[name][1] for name in bulk)
    if CELL_TYPES[kind][1] != top - 1:
        return result
    for name, nodes in bulk.items():
        near = np.flatnonzero(np.isin(nodes, touched).any(axis=1))
        single = np.arange(len(near), dtype=np.int32)
        # Each element by itself: its faces are all its boundary.
        apart = np.arange(nodes[near].size, dtype=np.int32).reshape(nodes[near].shape)
        sides = _kernel.core().boundary(apart.size, {name: apart}, None)
        flat = nodes[near].ravel()
        for faces, _, cells in sides.values():
            own = flat[faces[:, : min(corners, faces.shape[1])]]
            if own.shape[1] != corners:
                continue
            for key, cell in zip(np.sort(own, axis=1).tolist(), cells.tolist()):
                at = place.get(tuple(key))
                if at is not None:
                    side = 0 if result[at, 0] == 0 else 1
                    result[at, side] = near[single[cell]] + first[name]
    return result


@reader
def read_elmer(path: str) -> Mesh:
    """A folder's mesh, bodies and boundaries as groups. Raises FormatError, FileNotFoundError."""
    names = _read_names(os.path.join(path, "mesh.names"))
    lines = Lines(os.path.join(path, "mesh.nodes"))
    tags, points = [], []
    while lines.more():
        row = lines.next("a node").split()
        try:
            tags.append(int(row[0]))
            points.append([float(word) for word in row[2:5]])
        except (ValueError, IndexError):
            raise lines.error(f"expected a node, found {' '.join(row)!r}") from None
    number = {tag: at for at, tag in enumerate(tags)}
    cells: Dict[str, List[List[int]]] = {}
    groups: Dict[str, Dict[str, List[int]]] = {}
    known = {code: name for name, (code, _) in TYPES.items()}
    for base, labels, at_type, prefix in (
        ("mesh.elements", "bodies", 2, "Body"),
        ("mesh.boundary", "boundaries", 4, "Boundary"),
    ):
        lines = Lines(os.path.join(path, base))
        while lines.more():
            row = lines.integers("an element", at_type + 1)
            lines.at -= 1
            name = known.get(row[at_type], "")
            count = 1 if row[at_type] == _POINT else CELL_TYPES.get(name, (0, 0))[0]
            if not count:
                lines.at += 1
                raise lines.error(f"elements of type {row[at_type]} are not known here")
            nodes = lines.integers("an element's nodes", at_type + 1 + count)[at_type + 1 :]
            try:
                rows = [number[node] for node in nodes]
            except KeyError as error:
                raise lines.error(f"node {error} is not in mesh.nodes") from None
            title = names[labels].get(row[1], f"{prefix}{row[1]}")
            if not name:
                groups.setdefault(title, {}).setdefault("node", []).append(rows[0])
                continue
            order = TYPES[name][1]
            if order is not None:
                rows = [rows[k] for k in np.argsort(order)]
            groups.setdefault(title, {}).setdefault(name, []).append(len(cells.get(name, ())))
            cells.setdefault(name, []).append(rows)
    named: Dict[str, Any] = {}
    for title, parts in groups.items():
        for name, indices in parts.items():
            named[title if len(parts) == 1 else f"{title}_{name}"] = (name, np.array(indices))
    return Mesh(
        np.array(points, dtype=np.float64).reshape(-1, 3),
        {k: np.array(v) for k, v in cells.items()},
        named,
    )


def _read_names(path: str) -> Dict[str, Dict[int, str]]:
    found: Dict[str, Dict[int, str]] = {"bodies": {}, "boundaries": {}}
    if not os.path.exists(path):
        return found
    section = "bodies"
    lines = Lines(path)
    while lines.more():
        line = lines.next("a name")
        if "boundaries" in line:
            section = "boundaries"
        elif line.startswith("$"):
            name, _, number = line[1:].partition("=")
            try:
                found[section][int(number)] = name.strip()
            except ValueError:
                raise FormatError(f"{path}:{lines.at}: expected $ name = number", path, lines.at)
    return found
