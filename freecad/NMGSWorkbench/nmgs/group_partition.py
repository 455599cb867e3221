# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of cells as a partition: for formats in which a cell has one number, or one entity."""

from __future__ import annotations

from typing import Dict, List, Tuple

import numpy as np

from .mesh import CELL_TYPES, Mesh


def partition(mesh: Mesh, kind: str) -> Tuple[np.ndarray, List[Tuple[str, ...]]]:
    """(part of each cell of the type, names of each part's groups).

    Cells of one part are in the same groups; parts are numbered from 0 in the order of their first
    cell. int32 (M,).
    """
    names = [name for name, (of, _) in mesh.groups.items() if of == kind]
    count = len(mesh.cells[kind])
    part = np.zeros(count, dtype=np.int32)
    members: List[Tuple[str, ...]] = [()]
    for name in names:
        inside = np.zeros(count, dtype=bool)
        inside[mesh.groups[name][1]] = True
        # Each part is halved by the group where it has cells on both sides.
        key = part * 2 + inside
        found, part = np.unique(key, return_inverse=True)
        part = part.reshape(-1).astype(np.int32)
        members = [members[k // 2] + ((name,) if k % 2 else ()) for k in found.tolist()]
    if not count:
        return part, []
    _, first = np.unique(part, return_index=True)
    rank = np.empty(len(members), dtype=np.int32)
    order = np.argsort(first)
    rank[order] = np.arange(len(order), dtype=np.int32)
    return rank[part], [members[k] for k in order.tolist()]


def one_number(mesh: Mesh, kind: str, number: Dict[str, int]) -> np.ndarray:
    """A number for each cell of the type: that of the first of its groups, 0 for none."""
    part, members = partition(mesh, kind)
    table = [number[names[0]] if names else 0 for names in members]
    return np.array(table or [0], dtype=np.int32)[part]


def numbers_by_dimension(mesh: Mesh) -> Dict[str, Tuple[int, int]]:
    """name -> (dimension, number from 1 on, in each dimension by itself)."""
    counts = {0: 0, 1: 0, 2: 0, 3: 0}
    result = {}
    for name, (kind, _) in mesh.groups.items():
        dimension = 0 if kind == "node" else CELL_TYPES[kind][1]
        counts[dimension] += 1
        result[name] = (dimension, counts[dimension])
    return result
