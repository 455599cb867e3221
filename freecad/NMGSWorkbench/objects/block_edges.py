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


def edges_shape(nodes: np.ndarray) -> Part.Shape:
    """Compound of the curved edges and their mid-side nodes, one for edges that elements share.

    nodes: float64 (NE, 8 | 20, 3). Edges collapsed to a point are left out.
    """
    table = PATCH_EDGES if nodes.shape[1] == 8 else BLOCK_EDGES
    curves = nodes[:, table].reshape(-1, 3, 3)
    size = float(np.ptp(nodes.reshape(-1, 3), axis=0).max()) or 1.0
    keys = np.round(curves / (1e-7 * size)).astype(np.int64)
    seen, shapes = set(), []
    for (a, middle, b), key in zip(curves, keys):
        if (key[0] == key[2]).all() and (key[0] == key[1]).all():
            continue
        ends = sorted((tuple(key[0]), tuple(key[2])))
        name = (*ends, tuple(key[1]))
        if name not in seen:
            seen.add(name)
            shapes.append(_edge(a, middle, b, size))
            shapes.append(Part.Vertex(*middle))
    return Part.makeCompound(shapes)


def _edge(a: np.ndarray, middle: np.ndarray, b: np.ndarray, size: float) -> Part.Shape:
    if np.abs(2.0 * middle - a - b).max() <= 1e-9 * size:
        return Part.makeLine(FreeCAD.Vector(*a), FreeCAD.Vector(*b))
    curve = Part.BezierCurve()
    curve.setPoles([FreeCAD.Vector(*pole) for pole in (a, 2.0 * middle - 0.5 * (a + b), b)])
    return curve.toShape()
