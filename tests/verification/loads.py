# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundary faces by place, and the nodal forces that do the same work as a traction on them."""

import numpy as np

#: Gauss points of a square, three a side: exact for quad8's shape functions on a flat face.
_G = np.array([-np.sqrt(0.6), 0.0, np.sqrt(0.6)])
_W = np.array([5, 8, 5]) / 9
#: Seven points of a triangle (Radon), exact to the fifth degree: (r, s), weight.
_A, _B = (6 - np.sqrt(15)) / 21, (6 + np.sqrt(15)) / 21
_TRIANGLE = [((1 / 3, 1 / 3), 9 / 80)]
for _c, _w in ((_A, (155 - np.sqrt(15)) / 2400), (_B, (155 + np.sqrt(15)) / 2400)):
    _TRIANGLE += [((_c, _c), _w), ((1 - 2 * _c, _c), _w), ((_c, 1 - 2 * _c), _w)]


def faces_where(mesh, inside):
    """{cell name: rows of mesh nodes} of the boundary faces with all corners where inside(points)
    is true."""
    true = inside(mesh.points)
    from freecad.NMGSWorkbench.nmgs import _kernel

    result = {}
    volumes = {
        name: nodes
        for name, nodes in mesh.cells.items()
        if name.startswith(("hexa", "tetra", "wedge", "pyramid"))
    }
    for name, (nodes, _, _) in _kernel.core().boundary(len(mesh.points), volumes).items():
        corners = 3 if name.startswith("triangle") else 4
        chosen = nodes[true[nodes[:, :corners]].all(axis=1)]
        if len(chosen):
            result[name] = chosen
    return result


def nodes_of(faces):
    """Nodes of such faces, ascending."""
    return np.unique(np.concatenate([rows.ravel() for rows in faces.values()]))


def _quad8(r, s):
    """Shape functions and their derivatives by r, s (serendipity, as in every textbook)."""
    x, y = np.array([-1, 1, 1, -1]), np.array([-1, -1, 1, 1])
    n = np.empty(8)
    d = np.empty((2, 8))
    n[:4] = (1 + r * x) * (1 + s * y) * (r * x + s * y - 1) / 4
    d[0, :4] = x * (1 + s * y) * (2 * r * x + s * y) / 4
    d[1, :4] = y * (1 + r * x) * (r * x + 2 * s * y) / 4
    for k, (a, b) in enumerate(((0, -1), (1, 0), (0, 1), (-1, 0)), 4):
        if a == 0:
            n[k] = (1 - r * r) * (1 + s * b) / 2
            d[:, k] = -r * (1 + s * b), (1 - r * r) * b / 2
        else:
            n[k] = (1 - s * s) * (1 + r * a) / 2
            d[:, k] = (1 - s * s) * a / 2, -s * (1 + r * a)
    return n, d


def _triangle6(r, s):
    t = 1 - r - s
    n = np.array(
        [t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * t * r, 4 * r * s, 4 * s * t]
    )
    by_r = [1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s]
    by_s = [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]
    return n, np.array([by_r, by_s])


_RULES = {
    "quad8": [(_quad8(r, s), a * b) for r, a in zip(_G, _W) for s, b in zip(_G, _W)],
    "triangle6": [(_triangle6(*at), weight) for at, weight in _TRIANGLE],
}


def forces(mesh, faces, traction):
    """(N, 3). traction(places, normals), both (M, 3), gives force by area; normals outward."""
    result = np.zeros((len(mesh.points), 3))
    for name, rows in faces.items():
        corners = mesh.points[rows]
        for (shape, derivative), weight in _RULES[name]:
            places = np.einsum("k,mkd->md", shape, corners)
            by_r, by_s = np.einsum("ik,mkd->imd", derivative, corners)
            area = np.cross(by_r, by_s)
            size = np.linalg.norm(area, axis=1)
            force = traction(places, area / size[:, None]) * (size * weight)[:, None]
            for k in range(rows.shape[1]):
                np.add.at(result, rows[:, k], shape[k] * force)
    return result
