# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an answer of the worker is a mesh at all: looked at before anything is made of it."""

from __future__ import annotations

from fractions import Fraction
from typing import Dict

import numpy as np

#: Arrays of node numbers, and of numbers of tetrahedra, where -1 stands for none.
OF_NODES = ("tetra", "triangles", "edges")
OF_TETRA = ("neighbours", "triangle_tetra")
#: Arrays with one row for each row of another.
ROWS = {
    "point_markers": "points",
    "point_attributes": "points",
    "tetra_attributes": "tetra",
    "neighbours": "tetra",
    "triangle_markers": "triangles",
    "triangle_tetra": "triangles",
    "edge_markers": "edges",
}
#: Tetrahedra whose volumes are computed at once.
CHUNK = 1 << 14


def fault_of(arrays: Dict[str, np.ndarray], sign: int = 1) -> str:
    """What is wrong with the arrays of an answer (names of protocol.ANSWER), in words; "" for none.

    sign: -1 where the tetrahedra were asked for inside out. A volume too near to zero for floating
    point is computed exactly, of the coordinates as they are.
    """
    points = arrays.get("points", np.empty((0, 3)))
    if not np.isfinite(points).all():
        return f"node {int(np.argmin(np.isfinite(points).all(axis=1)))} is not finite"
    for name, other in ROWS.items():
        if name in arrays and other in arrays and len(arrays[name]) != len(arrays[other]):
            return f"{len(arrays[name])} {name} for {len(arrays[other])} {other}"
    for names, count, least in (
        (OF_NODES, len(points), 0),
        (OF_TETRA, len(arrays.get("tetra", ())), -1),
    ):
        for name in names:
            values = arrays.get(name)
            if values is None or not values.size:
                continue
            if values.min() < least or values.max() >= count:
                row = int(np.argwhere((values < least) | (values >= count))[0][0])
                return f"row {row} of {name} has a number outside {least} to {count - 1}"
    return _flat(points, arrays["tetra"], sign) if "tetra" in arrays else ""


def _flat(points: np.ndarray, tetra: np.ndarray, sign: int) -> str:
    # By coordinates: rows of three are slow in NumPy, and this is done to each answer.
    columns = np.ascontiguousarray(points.T)
    for first in range(0, len(tetra), CHUNK):
        nodes = tetra[first : first + CHUNK, :4].T
        (ux, vx, wx), (uy, vy, wy), (uz, vz, wz) = (
            [column[nodes[k]] - column[nodes[0]] for k in (1, 2, 3)] for column in columns
        )
        volume = ux * (vy * wz - vz * wy) - uy * (vx * wz - vz * wx) + uz * (vx * wy - vy * wx)
        volume *= sign
        size = _longest(ux, uy, uz) * _longest(vx, vy, vz) * _longest(wx, wy, wz)
        for near in np.flatnonzero(~(volume > 1e-13 * size)).tolist():
            if not sign * _exact(points[tetra[first + near, :4]]) > 0:
                return f"tetrahedron {first + near} has the volume {volume[near] / 6:.3g}"
    return ""


def _longest(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    return np.maximum(np.maximum(np.abs(x), np.abs(y)), np.abs(z))


def _exact(corners: np.ndarray) -> Fraction:
    """Six times the volume."""
    a, b, c, d = ([Fraction(x) for x in row] for row in corners.tolist())
    u, v, w = ([x - y for x, y in zip(p, a)] for p in (b, c, d))
    return (
        u[0] * (v[1] * w[2] - v[2] * w[1])
        - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
    )
