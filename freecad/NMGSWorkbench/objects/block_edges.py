# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges and nodes of 8-node patches and 20-node blocks as a shape.

A quadratic edge through three nodes is exactly a Bezier curve of degree 2 whose middle pole is
2 m - (a + b) / 2 (L. Piegl, W. Tiller, The NURBS Book, 1997, section 1.3).
"""

from __future__ import annotations

import FreeCAD
import numpy as np
import Part

_LOOP = ((0, 4, 1), (1, 5, 2), (2, 6, 3), (3, 7, 0))
#: Nodes a, middle, b of each edge (thesis, figures of the 8-node patch and the 20-node block).
PATCH_EDGES = np.array(_LOOP)
BLOCK_EDGES = np.array(
    ((0, 8, 1), (1, 9, 2), (2, 10, 3), (3, 11, 0))
    + ((4, 12, 5), (5, 13, 6), (6, 14, 7), (7, 15, 4))
    + ((0, 16, 4), (1, 17, 5), (2, 18, 6), (3, 19, 7))
)


#: Direction of each edge, and whether it runs with it (1) or against it (-1).
_SENSES = ((0, 1), (1, 1), (0, -1), (1, -1))
PATCH_DIRECTIONS = np.array(_SENSES)
BLOCK_DIRECTIONS = np.array((*_SENSES, *_SENSES, (2, 1), (2, 1), (2, 1), (2, 1)))


def unique_edges(nodes: np.ndarray) -> np.ndarray:
    """int (E, 2): element and local edge of each edge, one for edges that elements share, the
    lowest element's. Edges collapsed to a point are left out. Row n is Edge n + 1 of edges_shape.

    nodes: float64 (NE, 8 | 20, 3).
    """
    table = PATCH_EDGES if nodes.shape[1] == 8 else BLOCK_EDGES
    curves = nodes[:, table].reshape(-1, 3, 3)
    size = float(np.ptp(nodes.reshape(-1, 3), axis=0).max()) or 1.0
    keys = np.round(curves / (1e-7 * size)).astype(np.int64)
    seen, rows = set(), []
    for number, key in enumerate(keys):
        if (key[0] == key[2]).all() and (key[0] == key[1]).all():
            continue
        name = (*sorted((tuple(key[0]), tuple(key[2]))), tuple(key[1]))
        if name not in seen:
            seen.add(name)
            rows.append(divmod(number, len(table)))
    return np.array(rows, dtype=np.int64).reshape(-1, 2)


def curve(nodes: np.ndarray, element: int, edge: int, at: np.ndarray) -> np.ndarray:
    """(K, 3): points of a local edge at 0 to 1 along its block's direction, in its sense."""
    patch = nodes.shape[1] == 8
    a, middle, b = nodes[element, (PATCH_EDGES if patch else BLOCK_EDGES)[edge]]
    if (PATCH_DIRECTIONS if patch else BLOCK_DIRECTIONS)[edge, 1] < 0:
        a, b = b, a
    t = np.asarray(at, dtype=np.float64)[:, None]
    return (1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * middle + t * (2 * t - 1) * b


def edges_shape(nodes: np.ndarray) -> Part.Shape:
    """Compound of the curved edges of unique_edges and their mid-side nodes.

    nodes: float64 (NE, 8 | 20, 3).
    """
    table = PATCH_EDGES if nodes.shape[1] == 8 else BLOCK_EDGES
    size = float(np.ptp(nodes.reshape(-1, 3), axis=0).max()) or 1.0
    shapes = []
    for element, edge in unique_edges(nodes):
        a, middle, b = nodes[element, table[edge]]
        shapes.append(_edge(a, middle, b, size))
        shapes.append(Part.Vertex(*middle))
    return Part.makeCompound(shapes)


def _edge(a: np.ndarray, middle: np.ndarray, b: np.ndarray, size: float) -> Part.Shape:
    if np.abs(2.0 * middle - a - b).max() <= 1e-9 * size:
        return Part.makeLine(FreeCAD.Vector(*a), FreeCAD.Vector(*b))
    curve = Part.BezierCurve()
    curve.setPoles([FreeCAD.Vector(*pole) for pole in (a, 2.0 * middle - 0.5 * (a + b), b)])
    return curve.toShape()
