# SPDX-License-Identifier: LGPL-2.1-or-later
"""GiD's mesh as text (.gid, .post.msh): GiD's customization manual, "Postprocess mesh format".

Neither meshio nor FreeCAD writes it. tetgen_files has the thesis's two tables of the same kind.
"""

from __future__ import annotations

import re
from typing import Any, Dict, List, Tuple

import numpy as np

from .atomic import replaced_file
from .group_partition import partition
from .mesh import CELL_TYPES, Mesh
from .text_rows import write_rows
from .text_sections import Lines, reader

#: GiD's name of a cell type, and its nodes as indices into ours. Uprights come before the top.
TYPES: Dict[str, Tuple[str, Any]] = {
    "line": ("Linear", None),
    "line3": ("Linear", None),
    "triangle": ("Triangle", None),
    "triangle6": ("Triangle", None),
    "quad": ("Quadrilateral", None),
    "quad8": ("Quadrilateral", None),
    "tetra": ("Tetrahedra", None),
    "tetra10": ("Tetrahedra", None),
    "pyramid": ("Pyramid", None),
    "pyramid13": ("Pyramid", None),
    "wedge": ("Prism", None),
    "wedge15": ("Prism", (0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11)),
    "hexahedron": ("Hexahedra", None),
    "hexahedron20": (
        "Hexahedra",
        (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15),
    ),
}
_HEAD = re.compile(
    r'^\s*MESH\s+(?:"([^"]*)"\s+)?dimension\s+(\d)\s+ElemType\s+(\w+)\s+Nnode\s+(\d+)', re.I
)


def write_gid(path: str, mesh: Mesh) -> None:
    """A MESH for the cells of each type in the same groups, named by them ("Face1", "Face1+Load"),
    and one of points for a group of nodes. Coordinates stand in the first."""
    with replaced_file(path) as file:
        first_mesh, number = True, 1
        for title, kind, rows in _pieces(mesh):
            word, order = ("Point", None) if kind == "node" else TYPES[kind]
            plain = title.replace('"', "'")
            file.write(f'MESH "{plain}" dimension 3 ElemType {word} Nnode {rows.shape[1]}\n')
            file.write("Coordinates\n")
            if first_mesh:
                write_rows(file, "{} {} {} {}\n", mesh.points, first=1)
            file.write("End Coordinates\nElements\n")
            template = "{}" + " {}" * rows.shape[1] + "\n"
            write_rows(file, template, rows, first=number, order=order, add=1)
            file.write("End Elements\n")
            number += len(rows)
            first_mesh = False


def _pieces(mesh: Mesh) -> Any:
    """(title, cell type, rows of nodes); one of no cells for a mesh without any."""
    some = False
    for kind, nodes in mesh.cells.items():
        part, members = partition(mesh, kind)
        for at, names in enumerate(members):
            some = True
            title = "+".join(names) if names else kind
            yield title, kind, nodes if len(members) == 1 else nodes[part == at]
    for name, (kind, indices) in mesh.groups.items():
        if kind == "node":
            some = True
            yield name, "node", indices[:, None]
    if not some:
        yield "Mesh", "node", np.zeros((0, 1), dtype=np.int32)


@reader
def read_gid(path: str) -> Mesh:
    """All meshes of the file as one; each named one is a group. Raises FormatError,
    FileNotFoundError."""
    lines = Lines(path)
    tags: List[np.ndarray] = []
    points: List[np.ndarray] = []
    found: List[Tuple[str, str, np.ndarray]] = []
    title, kind, count = "", "", 0
    while lines.more():
        line = lines.next("a line")
        word = line.split()[0].lower()
        head = _HEAD.match(line)
        if head:
            title, count = head.group(1) or "", int(head.group(4))
            kind = _kind(lines, head.group(3).lower(), count)
        elif word == "mesh":
            raise lines.error(f"expected MESH dimension .. ElemType .. Nnode .., found {line!r}")
        elif word in ("coordinates", "elements"):
            size = _until_end(lines, word)
            if word == "coordinates":
                columns = len(lines.peek().split()) if size else 4
                rows = lines.block(size, columns, np.float64, "coordinates")
                tags.append(rows[:, 0].astype(np.int64))
                points.append(_three(rows[:, 1:]))
            elif kind:
                # A number of a material may stand behind the nodes.
                columns = len(lines.peek().split()) if size else 1 + count
                rows = lines.block(size, max(columns, 1 + count), np.int64, "elements")
                found.append((title, kind, rows[:, 1 : 1 + count]))
            lines.next("the end")
    return _mesh(lines, tags, points, found)


def _three(rows: np.ndarray) -> np.ndarray:
    full = np.zeros((len(rows), 3))
    full[:, : min(rows.shape[1], 3)] = rows[:, :3]
    return full


def _kind(lines: Lines, word: str, count: int) -> str:
    if word == "point":
        return "node"
    for name, (known, _) in TYPES.items():
        if known.lower()[:5] == word[:5] and CELL_TYPES[name][0] == count:
            return name
    raise lines.error(f"elements {word} of {count} nodes are not known here")


def _until_end(lines: Lines, word: str) -> int:
    """How many lines the section has."""
    start, count = lines.at, 0
    while not lines.peek().strip().lower().startswith("end"):
        lines.next(f"End {word}")
        count += 1
    lines.at = start
    return count


def _mesh(lines: Lines, tags: List[Any], points: List[Any], found: List[Any]) -> Mesh:
    numbers = np.concatenate(tags) if tags else np.zeros(0, np.int64)
    order = np.argsort(numbers, kind="stable")
    ascending = numbers[order]
    cells: Dict[str, List[np.ndarray]] = {}
    groups: Dict[str, Any] = {}
    start: Dict[str, int] = {}
    for title, kind, nodes in found:
        at = np.minimum(np.searchsorted(ascending, nodes), max(len(ascending) - 1, 0))
        if nodes.size and (not len(ascending) or (ascending[at] != nodes).any()):
            raise lines.error("an element has a node that the file lacks")
        rows = order[at] if nodes.size else nodes
        if kind == "node":
            groups[title] = (kind, rows[:, 0])
            continue
        permutation = TYPES[kind][1]
        if permutation is not None:
            rows = rows[:, np.argsort(permutation)]
        first = start.get(kind, 0)
        start[kind] = first + len(rows)
        cells.setdefault(kind, []).append(rows)
        for name in title.split("+") if title and title != kind else ():
            old = groups.get(name)
            if old is not None and old[0] != kind:
                name = f"{name}_{kind}"
                old = groups.get(name)
            new = np.arange(first, first + len(rows))
            groups[name] = (kind, new if old is None else np.concatenate([old[1], new]))
    whole = np.concatenate(points) if points else np.zeros((0, 3))
    return Mesh(whole, {k: np.concatenate(v) for k, v in cells.items()}, groups)
