# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of a mesh in flat triangles and quads, with its groups: for formats that know no
volumes and no mid-side nodes."""

from __future__ import annotations

from typing import Dict, List

import numpy as np

from .mesh import CELL_TYPES, Group, Mesh

#: Flat pieces of a quadratic face that use all its nodes.
_PIECES = {
    "triangle6": [("triangle", ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)))],
    "quad8": [
        ("triangle", ((0, 4, 7), (4, 1, 5), (5, 2, 6), (6, 3, 7))),
        ("quad", ((4, 5, 6, 7),)),
    ],
}


def flat_surface(mesh: Mesh) -> Mesh:
    """Triangles and quads: of a volume mesh its boundary, seen from outside; of a surface mesh its
    own cells. Groups of faces follow. Raises ValueError where there are none."""
    if any(CELL_TYPES[name][1] == 3 and len(nodes) for name, nodes in mesh.cells.items()):
        mesh = mesh.boundary()
    cells: Dict[str, List[np.ndarray]] = {}
    groups: Dict[str, Group] = {}
    count: Dict[str, int] = {}
    for name, nodes in mesh.cells.items():
        if CELL_TYPES[name][1] != 2 or not len(nodes):
            continue
        plain = [(name, (tuple(range(CELL_TYPES[name][0])),))]
        for kind, places in _PIECES.get(name, plain):
            each, first = len(places), count.get(kind, 0)
            pieces = nodes[:, np.array(places)].reshape(-1, CELL_TYPES[kind][0])
            cells.setdefault(kind, []).append(pieces)
            count[kind] = first + len(pieces)
            for group, (of, indices) in mesh.groups.items():
                if of == name:
                    inside = (each * indices[:, None] + np.arange(each)).ravel() + first
                    title = group if group not in groups else f"{group}_{kind}"
                    groups[title] = (kind, inside)
    if not cells:
        raise ValueError("mesh: it has no faces")
    return Mesh(mesh.points, {k: np.concatenate(v) for k, v in cells.items()}, groups)
