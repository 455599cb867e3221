# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit cube (or square) in distorted elements of each type, and in all types of volume cells.

Nodes inside are moved by a fixed pattern, those on a face within it, those on an edge along it.
"""

import numpy as np

from freecad.NMGSWorkbench import nmgs

LINEAR = ("hexahedron", "wedge", "pyramid", "tetra", "quad", "triangle")
QUADRATIC = ("hexahedron20", "wedge15", "pyramid13", "tetra10", "quad8", "triangle6")
KINDS = LINEAR + QUADRATIC


def unit(kind, divisions=2, amount=0.12):
    """A mesh of cells of one kind."""
    if kind in QUADRATIC:
        return unit(LINEAR[QUADRATIC.index(kind)], divisions, amount).to_order(2)
    if kind in ("quad", "triangle"):
        corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        middle = [[0.5, 0, 0], [1, 0.5, 0], [0.5, 1, 0], [0, 0.5, 0]]
        mesh = nmgs.BlockModel([corners + middle], [divisions, divisions]).generate()
    else:
        mesh = nmgs.shapes.cube(1.0, divisions=divisions).generate()
        mesh.points -= mesh.points.min(axis=0)
    points = moved(mesh.points, amount / divisions)
    name = next(iter(mesh.cells))
    cells = mesh.cells[name]
    if kind == "wedge":
        cells = np.concatenate([cells[:, [0, 1, 3, 4, 5, 7]], cells[:, [1, 2, 3, 5, 6, 7]]])
    elif kind == "pyramid":
        points, cells = six_pyramids(points, cells)
    elif kind in ("tetra", "triangle"):
        return bare(nmgs.Mesh(points, {name: cells}).split())
    return nmgs.Mesh(points, {kind: cells})


def bare(mesh):
    return nmgs.Mesh(mesh.points, mesh.cells)


def moved(points, amount):
    """Points with every coordinate that is neither 0 nor 1 moved by up to the amount."""
    numbers = np.arange(points.size).reshape(points.shape)
    return points + np.where((points > 1e-9) & (points < 1 - 1e-9), amount * np.sin(7 * numbers), 0)


def six_pyramids(points, cells):
    """Each hexahedron as six pyramids with the tip in its middle."""
    faces = ([0, 1, 2, 3], [4, 7, 6, 5], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0])
    tips = len(points) + np.arange(len(cells))[:, None]
    pyramids = [np.concatenate([cells[:, face], tips], axis=1) for face in faces]
    return np.concatenate([points, points[cells].mean(axis=1)]), np.concatenate(pyramids)


def mixed(order=1):
    """Two hexahedra, two wedges, seven pyramids and ten tetrahedra that fit together, in the box
    from (0, 0, 0) to (5, 1, 1), with surface cells and groups of all kinds."""
    lattice = nmgs.shapes.box(5, 1, 1, divisions=[5, 1, 1]).generate()
    points = lattice.points - lattice.points.min(axis=0)
    hexahedra = lattice.cells["hexahedron"]
    hexahedra = hexahedra[np.argsort(points[hexahedra].mean(axis=1)[:, 0])]
    wedges = hexahedra[2:3]
    wedges = np.concatenate([wedges[:, [0, 1, 3, 4, 5, 7]], wedges[:, [1, 2, 3, 5, 6, 7]]])
    points, pyramids = six_pyramids(points, hexahedra[3:4])
    # The last hexahedron: a pyramid on the face it shares, the other faces as two tetrahedra each.
    last, tip = hexahedra[4], len(points)
    points = np.concatenate([points, points[last].mean(axis=0)[None]])
    shared = [3, 7, 4, 0] if points[last[0], 0] < 4.5 else [1, 5, 6, 2]
    pyramids = np.concatenate([pyramids, [[*last[shared], tip]]])
    tets = []
    for face in (
        [0, 1, 2, 3],
        [4, 7, 6, 5],
        [0, 4, 5, 1],
        [1, 5, 6, 2],
        [2, 6, 7, 3],
        [3, 7, 4, 0],
    ):
        if set(face) != set(shared):
            a, b, c, d = last[face]
            tets += [[a, b, c, tip], [a, c, d, tip]]
    ends = points[hexahedra[0]][:, 0] < 1e-9
    face = hexahedra[0][[0, 4, 7, 3]] if ends[0] else hexahedra[0][[0, 1, 5, 4]]
    assert (points[face][:, 0] < 1e-9).all()
    mesh = nmgs.Mesh(
        points,
        {
            "hexahedron": hexahedra[:2],
            "wedge": wedges,
            "pyramid": pyramids,
            "tetra": tets,
            "quad": [face],
            "line": [face[:2], face[1:3]],
        },
        {
            "Solid1": ("hexahedron", np.arange(2)),
            "Solid2": ("tetra", np.arange(10)),
            "Face1": ("quad", np.array([0])),
            "Edge1": ("line", np.array([1])),
            "Vertex1": ("node", np.array([face[0]])),
        },
    )
    return mesh if order == 1 else mesh.to_order(2)


#: Volume of `mixed`.
MIXED_VOLUME = 5.0
