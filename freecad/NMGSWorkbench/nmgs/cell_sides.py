# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of volume cells as rows of nodes, with the cells on both sides."""

from __future__ import annotations

from typing import Dict, NamedTuple, Tuple

import numpy as np

from .mesh import Mesh

#: Corners of the faces of linear cells, seen from outside.
SIDES: Dict[str, Tuple[Tuple[int, ...], ...]] = {
    "tetra": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
    "pyramid": ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    "wedge": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    # The low and high end of xi, of eta, of zeta.
    "hexahedron": (
        (0, 4, 7, 3),
        (1, 2, 6, 5),
        (0, 1, 5, 4),
        (3, 7, 6, 2),
        (0, 3, 2, 1),
        (4, 5, 6, 7),
    ),
}


class Sides(NamedTuple):
    """nodes: int32 (F, 4), the last -1 for triangles, seen from the owner. owner, neighbour:
    numbers of cells over all types, owner the smaller; neighbour -1 at the boundary."""

    nodes: np.ndarray
    owner: np.ndarray
    neighbour: np.ndarray


def sides(mesh: Mesh) -> Sides:
    """Each face of the volume cells once. Raises ValueError where three cells share a face."""
    faces, cells = [], []
    start = 0
    for name, nodes in mesh.cells.items():
        for corners in SIDES.get(name, ()):
            rows = np.full((len(nodes), 4), -1, dtype=np.int32)
            rows[:, : len(corners)] = nodes[:, corners]
            faces.append(rows)
            cells.append(np.arange(start, start + len(nodes), dtype=np.int64))
        if name in SIDES:
            start += len(nodes)
    whole = np.concatenate(faces) if faces else np.zeros((0, 4), np.int32)
    of = np.concatenate(cells) if cells else np.zeros(0, np.int64)
    keys = np.sort(whole, axis=1)
    order = np.lexsort((of, keys[:, 3], keys[:, 2], keys[:, 1], keys[:, 0]))
    keys = keys[order]
    same = (keys[1:] == keys[:-1]).all(axis=1)
    if (same[1:] & same[:-1]).any():
        at = int(np.flatnonzero(same[1:] & same[:-1])[0])
        raise ValueError(f"mesh: more than two cells share the face of nodes {keys[at].tolist()}")
    first = np.flatnonzero(~np.concatenate([[False], same])) if len(keys) else order
    has_pair = np.concatenate([same, [False]])[first] if len(keys) else np.zeros(0, bool)
    neighbour = np.full(len(first), -1, dtype=np.int64)
    neighbour[has_pair] = of[order[first[has_pair] + 1]]
    return Sides(whole[order[first]], of[order[first]], neighbour)
