# SPDX-License-Identifier: LGPL-2.1-or-later
"""I-DEAS universal files (.unv): datasets 2411 (nodes), 2412 (elements), 2467 (groups).

Our own: meshio does not know the format, and FreeCAD's writer drops pyramids without a word.
"""

from __future__ import annotations

from typing import Any, Dict, List, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .mesh import CELL_TYPES, Mesh
from .text_rows import slices, write_rows
from .text_sections import Lines, reader

#: Descriptor of a cell type, and its nodes as indices into ours. Quadratic elements go round the
#: perimeter: corner, mid-side, corner, ...; solids from the bottom ring over the uprights up.
TYPES: Dict[str, Tuple[int, Tuple[int, ...]]] = {
    "line": (11, (0, 1)),
    "line3": (24, (0, 2, 1)),
    "triangle": (91, (0, 1, 2)),
    "triangle6": (92, (0, 3, 1, 4, 2, 5)),
    "quad": (94, (0, 1, 2, 3)),
    "quad8": (95, (0, 4, 1, 5, 2, 6, 3, 7)),
    "tetra": (111, (0, 1, 2, 3)),
    "tetra10": (118, (0, 4, 1, 5, 2, 6, 7, 8, 9, 3)),
    "wedge": (112, (0, 1, 2, 3, 4, 5)),
    "wedge15": (113, (0, 6, 1, 7, 2, 8, 12, 13, 14, 3, 9, 4, 10, 5, 11)),
    "hexahedron": (115, (0, 1, 2, 3, 4, 5, 6, 7)),
    "hexahedron20": (
        116,
        (0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15),
    ),
}
#: Other descriptors that readers meet: plane stress, plane strain, membranes, rods, pipes.
_ALIASES = {
    21: "line",
    22: "line3",
    23: "line3",
    41: "triangle",
    51: "triangle",
    61: "triangle",
    74: "triangle",
    81: "triangle",
    42: "triangle6",
    52: "triangle6",
    62: "triangle6",
    72: "triangle6",
    82: "triangle6",
    44: "quad",
    54: "quad",
    64: "quad",
    71: "quad",
    84: "quad",
    45: "quad8",
    55: "quad8",
    65: "quad8",
    75: "quad8",
    85: "quad8",
}
_BEAMS = (11, 21, 22, 23, 24)
_GROUP_SETS = ("2467", "2477", "2452", "2435", "2432", "2430", "2429")


def write_unv(path: str, mesh: Mesh) -> None:
    """All cells, all groups. Raises ValueError for pyramids, which have no number there."""
    unknown = [name for name in mesh.cells if name not in TYPES and len(mesh.cells[name])]
    if unknown:
        raise ValueError(f"mesh: {', '.join(unknown)} cells cannot be written as .unv")
    with replaced_file(path) as file:
        file.write(f"{-1:6d}\n{2411:6d}\n")
        write_rows(
            file,
            f"{{:10d}}{1:10d}{1:10d}{11:10d}\n{{:25.16E}}{{:25.16E}}{{:25.16E}}\n",
            mesh.points,
            first=1,
        )
        file.write(f"{-1:6d}\n{-1:6d}\n{2412:6d}\n")
        first: Dict[str, int] = {}
        number = 1
        for name, nodes in mesh.cells.items():
            first[name] = number
            _write_elements(file, name, nodes, number)
            number += len(nodes)
        file.write(f"{-1:6d}\n")
        if mesh.groups:
            file.write(f"{-1:6d}\n{2467:6d}\n")
            for at, (name, (kind, indices)) in enumerate(mesh.groups.items(), 1):
                file.write(f"{at:10d}" + f"{0:10d}" * 6 + f"{len(indices):10d}\n")
                file.write(" ".join(name.split())[:80] + "\n")
                # 7: nodes, 8: elements; two members a line.
                code = 7 if kind == "node" else 8
                _write_members(file, code, indices + (1 if kind == "node" else first[kind]))
            file.write(f"{-1:6d}\n")


def _write_elements(file: TextIO, name: str, nodes: np.ndarray, number: int) -> None:
    descriptor, order = TYPES[name]
    count = len(order)
    head = f"{{:10d}}{descriptor:10d}{1:10d}{1:10d}{7:10d}{count:10d}\n"
    if descriptor in _BEAMS:
        head += f"{0:10d}{1:10d}{1:10d}\n"
    template = head
    for start in range(0, count, 8):
        template += "{:10d}" * min(8, count - start) + "\n"
    write_rows(file, template, nodes, first=number, order=order, add=1)


def _write_members(file: TextIO, code: int, numbers: np.ndarray) -> None:
    for part in slices((len(numbers) + 1) // 2):
        values = numbers[2 * part.start : 2 * part.stop].tolist()
        for at in range(0, len(values), 2):
            file.write(
                "".join(f"{code:10d}{n:10d}{0:10d}{0:10d}" for n in values[at : at + 2]) + "\n"
            )


class _Found:
    def __init__(self) -> None:
        self.tags: List[int] = []
        self.points: List[List[float]] = []
        self.cells: Dict[str, List[List[int]]] = {}
        self.numbers: Dict[str, List[int]] = {}
        self.groups: List[Tuple[str, Dict[int, List[int]]]] = []


@reader
def read_unv(path: str) -> Mesh:
    """Cells and permanent groups. Datasets of other kinds are passed over. Raises FormatError,
    FileNotFoundError."""
    lines = Lines(path)
    found = _Found()
    while lines.more():
        if lines.next("a dataset").strip() != "-1":
            raise lines.error("expected -1 before a dataset")
        kind = lines.next("the number of a dataset").strip()
        if kind in ("2411", "781"):
            _read_nodes(lines, found)
        elif kind == "2412":
            _read_elements(lines, found)
        elif kind in _GROUP_SETS:
            _read_groups(lines, found, 4 if kind in ("2435", "2452", "2467", "2477") else 2)
        while lines.next("the end of the dataset").strip() != "-1":
            pass
    return _mesh(lines, found)


def _ended(lines: Lines) -> bool:
    return lines.peek().strip() == "-1"


def _read_nodes(lines: Lines, found: _Found) -> None:
    while not _ended(lines):
        found.tags.append(lines.integers("a node", 1)[0])
        row = lines.next("a node's place").upper().replace("D", "E").split()
        try:
            found.points.append([float(word) for word in row])
            if len(row) != 3:
                raise ValueError
        except ValueError:
            raise lines.error(f"expected three coordinates, found {' '.join(row)!r}") from None


def _read_elements(lines: Lines, found: _Found) -> None:
    names = {descriptor: name for name, (descriptor, _) in TYPES.items()}
    names.update(_ALIASES)
    while not _ended(lines):
        number, descriptor, _, _, _, count = lines.integers("an element", 6)
        if descriptor in _BEAMS:
            lines.next("a beam's section")
        nodes: List[int] = []
        while len(nodes) < count:
            nodes += lines.integers("an element's nodes", min(8, count - len(nodes)))
        name = names.get(descriptor)
        if name is None or CELL_TYPES[name][0] != count:
            raise lines.error(
                f"elements of {count} nodes with descriptor {descriptor} are not known"
            )
        ours = [0] * count
        for place, node in zip(TYPES[name][1], nodes):
            ours[place] = node
        found.cells.setdefault(name, []).append(ours)
        found.numbers.setdefault(name, []).append(number)


def _read_groups(lines: Lines, found: _Found, wide: int) -> None:
    while not _ended(lines):
        head = lines.integers("a group", 8)
        name = lines.next("a group's name").strip()
        members: Dict[int, List[int]] = {}
        count = 0
        while count < head[7]:
            row = lines.next("a group's members").split()
            for at in range(0, len(row) - 1, wide):
                members.setdefault(int(row[at]), []).append(int(row[at + 1]))
                count += 1
        found.groups.append((name, members))


def _mesh(lines: Lines, found: _Found) -> Mesh:
    order = np.argsort(found.tags, kind="stable")
    tags = np.array(found.tags, dtype=np.int64)[order]

    def rows_of(numbers: Any) -> np.ndarray:
        values = np.array(numbers, dtype=np.int64)
        at = np.minimum(np.searchsorted(tags, values), max(len(tags) - 1, 0))
        if values.size and (not len(tags) or (tags[at] != values).any()):
            raise lines.error("a node is named that the file lacks")
        return order[at]

    points = np.array(found.points, dtype=np.float64).reshape(-1, 3)
    cells = {name: rows_of(rows) for name, rows in found.cells.items()}
    place = {
        number: (name, at)
        for name, numbers in found.numbers.items()
        for at, number in enumerate(numbers)
    }
    groups: Dict[str, Any] = {}
    for name, members in found.groups:
        parts: Dict[str, List[int]] = {}
        for number in members.get(8, ()):
            if number not in place:
                raise lines.error(f"group {name} has element {number}, which the file lacks")
            parts.setdefault(place[number][0], []).append(place[number][1])
        if members.get(7):
            parts["node"] = rows_of(members[7]).tolist()
        for kind, indices in parts.items():
            groups[name if len(parts) == 1 else f"{name}_{kind}"] = (kind, np.array(indices))
    return Mesh(points, cells, groups)
