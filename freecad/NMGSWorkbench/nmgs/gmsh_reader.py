# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh's .msh as text, versions 2.2 and 4.1."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Tuple

import numpy as np

from .errors import FormatError
from .gmsh_types import POINT, TYPES
from .mesh import CELL_TYPES, Mesh
from .text_sections import Lines

_NAMES = {number: name for name, (number, _) in TYPES.items()}


def text_version(path: str) -> str:
    """The version of a text file, or "" for a binary one. Raises FormatError, FileNotFoundError."""
    with open(path, "rb") as file:
        head = file.read(200).split()
    if len(head) < 4 or head[0] != b"$MeshFormat":
        raise FormatError(f"{path}: expected $MeshFormat at the beginning", path, 1)
    version = head[1].decode("ascii", "replace")
    return ("4.1" if version in ("4.1", "4.10") else version[:3]) if head[2] == b"0" else ""


class _Found:
    """What the sections say, collected."""

    def __init__(self) -> None:
        self.names: Dict[Tuple[int, int], str] = {}
        #: Physical numbers of an entity (dimension, tag), version 4.1.
        self.physical: Dict[Tuple[int, int], List[int]] = {}
        self.tags = np.zeros(0, np.int64)
        self.points = np.zeros((0, 3))
        #: (Gmsh's type, physical number of each or numbers of all, nodes)
        self.blocks: List[Tuple[int, Any, np.ndarray]] = []


def read_text(path: str) -> Mesh:
    """All cells; cells that the file has twice are here twice. Raises FormatError."""
    lines = Lines(path)
    found = _Found()
    new = text_version(path) == "4.1"
    readers: Dict[str, Callable[[Lines, _Found], None]] = {
        "$PhysicalNames": _names,
        "$Entities": _entities,
        "$Nodes": _nodes41 if new else _nodes22,
        "$Elements": _elements41 if new else _elements22,
    }
    while lines.more():
        head = lines.next("a section").strip()
        if head in readers:
            readers[head](lines, found)
        end = head.replace("$", "$End", 1)
        while head and lines.next(end).strip() != end:
            pass
    return _mesh(lines, found)


def _names(lines: Lines, found: _Found) -> None:
    for _ in range(lines.integers("the number of names", 1)[0]):
        dimension, number, name = lines.next("a physical name").split(None, 2)
        found.names[int(dimension), int(number)] = name.strip().strip('"')


def _entities(lines: Lines, found: _Found) -> None:
    for dimension, count in enumerate(lines.integers("four numbers of entities", 4)):
        for _ in range(count):
            words = lines.next("an entity").split()
            at = 4 if dimension == 0 else 7
            many = int(words[at])
            found.physical[dimension, int(words[0])] = [
                abs(int(w)) for w in words[at + 1 : at + 1 + many]
            ]


def _nodes22(lines: Lines, found: _Found) -> None:
    count = lines.integers("the number of nodes", 1)[0]
    rows = lines.block(count, 4, np.float64, "nodes")
    found.tags, found.points = rows[:, 0].astype(np.int64), rows[:, 1:]


def _nodes41(lines: Lines, found: _Found) -> None:
    blocks, _, _, _ = lines.integers("four numbers of nodes", 4)
    tags, points = [found.tags], [found.points]
    for _ in range(blocks):
        dimension, _, parametric, count = lines.integers("a block of nodes", 4)
        tags.append(lines.block(count, 1, np.int64, "numbers of nodes")[:, 0])
        wide = 3 + (dimension if parametric else 0)
        points.append(lines.block(count, wide, np.float64, "places of nodes")[:, :3])
    found.tags, found.points = np.concatenate(tags), np.concatenate(points)


def _elements22(lines: Lines, found: _Found) -> None:
    for row in lines.ragged(lines.integers("the number of elements", 1)[0], "elements"):
        # A number, a type, how many tags, the tags (the first is the physical group), the nodes.
        number, tags = int(row[0, 1]), int(row[0, 2])
        found.blocks.append((number, row[:, 3] if tags else None, row[:, 3 + tags :]))


def _elements41(lines: Lines, found: _Found) -> None:
    blocks, _, _, _ = lines.integers("four numbers of elements", 4)
    for _ in range(blocks):
        dimension, tag, number, count = lines.integers("a block of elements", 4)
        nodes = 1 if number == POINT else CELL_TYPES[_known(lines, number)][0]
        rows = lines.block(count, 1 + nodes, np.int64, "elements")
        found.blocks.append((number, found.physical.get((dimension, tag), []), rows[:, 1:]))


def _known(lines: Lines, number: int) -> str:
    if number not in _NAMES:
        raise lines.error(f"elements of Gmsh's type {number} are not known here")
    return _NAMES[number]


def _mesh(lines: Lines, found: _Found) -> Mesh:
    order = np.argsort(found.tags, kind="stable")
    tags = found.tags[order]
    cells: Dict[str, List[np.ndarray]] = {}
    groups: Dict[str, Dict[str, List[np.ndarray]]] = {}
    start: Dict[str, int] = {}
    for number, physical, nodes in found.blocks:
        at = np.searchsorted(tags, nodes)
        if nodes.size and (at.max() >= len(tags) or (tags[at] != nodes).any()):
            raise lines.error("an element has a node that the file lacks")
        rows = order[at]
        kind = "node" if number == POINT else _known(lines, number)
        dimension = 0 if number == POINT else CELL_TYPES[kind][1]
        if number == POINT:
            where = rows[:, 0]
        else:
            permutation = TYPES[kind][1]
            if rows.shape[1] != CELL_TYPES[kind][0]:
                raise lines.error(f"a {kind} has {rows.shape[1]} nodes")
            if permutation is not None:
                rows = rows[:, np.argsort(permutation)]
            where = start.get(kind, 0) + np.arange(len(rows))
            start[kind] = start.get(kind, 0) + len(rows)
            cells.setdefault(kind, []).append(rows)
        for group, members in _physical(physical, where):
            name = found.names.get((dimension, group), f"Physical{group}")
            groups.setdefault(name, {}).setdefault(kind, []).append(members)
    named = {}
    for name, kinds in groups.items():
        for kind, parts in kinds.items():
            title = name if len(kinds) == 1 else f"{name}_{kind}"
            named[title] = (kind, np.unique(np.concatenate(parts)))
    return Mesh(found.points, {k: np.concatenate(v) for k, v in cells.items()}, named)


def _physical(physical: Any, where: np.ndarray) -> List[Tuple[int, np.ndarray]]:
    if physical is None:
        return []
    if isinstance(physical, list):
        return [(number, where) for number in physical]
    return [
        (number, where[physical == number]) for number in np.unique(physical).tolist() if number
    ]
