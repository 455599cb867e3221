# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wavefront's .obj: faces, with a `g` line for each group. meshio reads and writes no groups."""

from __future__ import annotations

from typing import Any, Dict, List

import numpy as np

from .atomic import replaced_file
from .facets import flat_surface
from .group_partition import partition
from .mesh import Mesh
from .text_rows import write_rows
from .text_sections import Lines, reader


def write_obj(path: str, mesh: Mesh) -> None:
    """Triangles and quads; of a volume mesh its boundary, of quadratic faces flat pieces. A face in
    many groups has all their names in its `g` line. Raises ValueError for a mesh without faces."""
    surface = flat_surface(mesh)
    with replaced_file(path) as file:
        file.write("# NMGS Workbench\n")
        write_rows(file, "v {} {} {}\n", surface.points)
        for kind, nodes in surface.cells.items():
            part, members = partition(surface, kind)
            for number, names in enumerate(members):
                words = " ".join("_".join(name.split()) for name in names) or "default"
                file.write(f"g {words}\n")
                template = "f" + " {}" * nodes.shape[1] + "\n"
                write_rows(file, template, nodes[part == number], add=1)


@reader
def read_obj(path: str) -> Mesh:
    """Faces of three and four nodes; others are cut into triangles from their first node. Groups by
    `g` (and `o`, where there is no `g`). Raises FormatError, FileNotFoundError."""
    lines = Lines(path)
    points: List[List[float]] = []
    cells: Dict[str, List[List[int]]] = {}
    groups: Dict[str, Dict[str, List[int]]] = {}
    names: List[str] = []
    while lines.more():
        words = lines.next("a line").split()
        if words[0] == "v":
            try:
                points.append([float(word) for word in words[1:4]])
                if len(points[-1]) != 3:
                    raise ValueError
            except ValueError:
                raise lines.error("expected three coordinates") from None
        elif words[0] in ("g", "o"):
            names = [word for word in words[1:] if word not in ("default", "off")]
        elif words[0] == "f":
            nodes = [_node(lines, word, len(points)) for word in words[1:]]
            if len(nodes) < 3:
                raise lines.error(f"a face of {len(nodes)} nodes")
            fan = [[nodes[0], nodes[k], nodes[k + 1]] for k in range(1, len(nodes) - 1)]
            for face in [nodes] if len(nodes) == 4 else fan:
                rows = cells.setdefault("quad" if len(face) == 4 else "triangle", [])
                for name in names:
                    kind = "quad" if len(face) == 4 else "triangle"
                    groups.setdefault(name, {}).setdefault(kind, []).append(len(rows))
                rows.append(face)
    named: Dict[str, Any] = {}
    for name, parts in groups.items():
        for kind, indices in parts.items():
            named[name if len(parts) == 1 else f"{name}_{kind}"] = (kind, np.array(indices))
    places = np.array(points, dtype=np.float64).reshape(-1, 3)
    return Mesh(places, {kind: np.array(rows) for kind, rows in cells.items()}, named)


def _node(lines: Lines, word: str, count: int) -> int:
    try:
        number = int(word.split("/")[0])
    except ValueError:
        raise lines.error(f"expected a node, found {word!r}") from None
    # Numbers below zero count from the end.
    at = number - 1 if number > 0 else count + number
    if number == 0 or not 0 <= at < count:
        raise lines.error(f"node {number} of {count}")
    return at
