# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outer faces and free edges."""

import numpy as np
import pytest
from blocks import bent_blocks, bent_patches, cube

from freecad.NMGSWorkbench import nmgs


def flux_volume(surface: nmgs.Mesh) -> float:
    """Volume inside the triangles of the surface, positive when they are seen from outside."""
    triangles = surface.split().points[surface.split().cells["triangle"]]
    return np.linalg.det(triangles).sum() / 6


def test_closed_and_seen_from_outside():
    for mesh in (cube((2, 3, 4)).generate(), bent_blocks().generate().split()):
        surface = mesh.boundary()
        assert flux_volume(surface) == pytest.approx(
            sum(v.sum() for v in mesh.quality("volume").values()), rel=1e-2
        )
        assert not surface.boundary().cells  # no free edge
        vertices = len(surface.points)
        faces = sum(len(c) for c in surface.cells.values())
        edges = len(surface.related_nodes()[1]) // 2
        assert vertices - edges + faces == 2  # Euler: a sphere
    assert len(cube((2, 3, 4)).generate().boundary().cells["quad"]) == 2 * (6 + 8 + 12)


def test_every_volume_type_is_seen_from_outside():
    box = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
    solids = {
        "hexahedron": box,
        "wedge": box[[0, 1, 3, 4, 5, 7]],
        "pyramid": np.vstack([box[:4], [[0.5, 0.5, 1]]]),
        "tetra": box[[0, 1, 3, 4]],
    }
    for name, points in solids.items():
        mesh = nmgs.Mesh(points, {name: [range(len(points))]})
        volume = mesh.quality("volume")[name][0]
        assert volume > 0
        assert flux_volume(mesh.boundary()) == pytest.approx(volume)
        raised = mesh.to_order(2)
        surface = raised.boundary()
        assert set(surface.cells) <= {"quad8", "triangle6"}
        assert len(surface.points) == len(raised.points)
        # Straight mid-sides: each mid-side node is in the middle of its own edge.
        for cell_type, cells in surface.cells.items():
            k = 3 if cell_type == "triangle6" else 4
            for i in range(k):
                a, b = surface.points[cells[:, i]], surface.points[cells[:, (i + 1) % k]]
                assert surface.points[cells[:, k + i]] == pytest.approx((a + b) / 2)


def test_free_edges_of_a_surface():
    mesh = bent_patches((3, 4)).generate()
    edges = mesh.boundary()
    assert set(edges.cells) == {"line"}
    assert len(edges.cells["line"]) == 2 * 6 + 2 * 4
    # Each node starts one edge and ends one: closed, in the direction of the cells.
    assert sorted(edges.cells["line"][:, 0]) == sorted(edges.cells["line"][:, 1])
    raised = mesh.to_order(2).boundary()
    assert set(raised.cells) == {"line3"} and len(raised.cells["line3"]) == 20


def test_groups_that_lie_on_the_boundary():
    mesh = cube((2, 2, 2)).generate()
    surface = mesh.boundary()
    number = {tuple(p): n for n, p in enumerate(mesh.points)}
    quads = [[number[tuple(p)] for p in surface.points[row]] for row in surface.cells["quad"]]
    inside = mesh.cells["hexahedron"][0][[4, 5, 6, 7]]
    top = np.flatnonzero(mesh.points[:, 2] == 1)
    middle = np.flatnonzero((mesh.points == 0.5).all(axis=1))
    whole = nmgs.Mesh(
        mesh.points,
        {"hexahedron": mesh.cells["hexahedron"], "quad": [inside, *[q[::-1] for q in quads]]},
        {
            "wall": ("quad", [0]),
            "skin": ("quad", [1, 2, 3]),
            "top": ("node", top),
            "middle": ("node", middle),
        },
    )
    surface = whole.boundary()
    assert len(surface.groups["wall"][1]) == 0 and len(surface.groups["middle"][1]) == 0
    chosen = surface.points[surface.cells["quad"][surface.groups["skin"][1]]]
    expected = whole.points[whole.cells["quad"][[1, 2, 3]]]
    assert sorted(map(tuple, chosen.mean(axis=1))) == sorted(map(tuple, expected.mean(axis=1)))
    assert (surface.points[surface.groups["top"][1]][:, 2] == 1).all()
    assert len(surface.groups["top"][1]) == 9
