# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divisions of fitted blocks from a wanted element size, one count a chain of opposite edges."""

from __future__ import annotations

from typing import Dict

import numpy as np

#: Ends of the edges along each direction, as node numbers with the mid-side node between.
_EDGES = {
    8: (((0, 4, 1), (3, 6, 2)), ((1, 5, 2), (0, 7, 3))),
    20: (
        ((0, 8, 1), (3, 10, 2), (4, 12, 5), (7, 14, 6)),
        ((1, 9, 2), (0, 11, 3), (5, 13, 6), (4, 15, 7)),
        ((0, 16, 4), (1, 17, 5), (2, 18, 6), (3, 19, 7)),
    ),
}


def divisions_by_size(nodes: np.ndarray, size: float) -> np.ndarray:
    """int32 (NE, 2 | 3): at least one element, none longer than size along the longest edge of its
    chain. Edges with the same three nodes belong to one chain."""
    directions = _EDGES[nodes.shape[1]]
    parent: Dict[object, object] = {}

    def root(key: object) -> object:
        parent.setdefault(key, key)
        while parent[key] != key:
            parent[key] = parent[parent[key]]
            key = parent[key]
        return key

    grid = 1e-6 * float(np.ptp(nodes.reshape(-1, 3), axis=0).max())

    def place(point: np.ndarray) -> tuple:
        return tuple(np.floor(point / grid + 0.5).astype(np.int64).tolist())

    longest = np.zeros((len(nodes), len(directions)))
    for block, points in enumerate(nodes):
        for direction, edges in enumerate(directions):
            for a, m, b in edges:
                length = np.linalg.norm(points[m] - points[a]) + np.linalg.norm(
                    points[b] - points[m]
                )
                longest[block, direction] = max(longest[block, direction], length)
                ends = sorted((place(points[a]), place(points[b])))
                parent[root((block, direction))] = root((ends[0], ends[1], place(points[m])))
    chain: Dict[object, float] = {}
    for block in range(len(nodes)):
        for direction in range(len(directions)):
            key = root((block, direction))
            chain[key] = max(chain.get(key, 0.0), longest[block, direction])
    counts = [
        [max(1, int(np.ceil(chain[root((b, d))] / size - 1e-9))) for d in range(len(directions))]
        for b in range(len(nodes))
    ]
    return np.array(counts, dtype=np.int32)
