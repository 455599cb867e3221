# SPDX-License-Identifier: LGPL-2.1-or-later
"""Related nodes, against sets made in Python and Figures 4.4 and 4.6 of the thesis."""

import numpy as np
import pytest
from blocks import bent_blocks, cube
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad.NMGSWorkbench import nmgs

EDGES = {
    "triangle": [(0, 1), (1, 2), (2, 0)],
    "quad": [(0, 1), (1, 2), (2, 3), (3, 0)],
    "tetra": [(a, b) for a in range(4) for b in range(a)],
    "hexahedron": [(i, (i + 1) % 4) for i in range(4)]
    + [(4 + i, 4 + (i + 1) % 4) for i in range(4)]
    + [(i, i + 4) for i in range(4)],
    "line": [(0, 1)],
    "wedge": [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)],
}


def expected(mesh: nmgs.Mesh) -> list:
    related = [set() for _ in mesh.points]
    for name, cells in mesh.cells.items():
        for row in cells.tolist():
            for a, b in EDGES[name]:
                related[row[a]].add(row[b])
                related[row[b]].add(row[a])
    return [sorted(r) for r in related]


def rows(mesh: nmgs.Mesh) -> list:
    offsets, neighbours = mesh.related_nodes()
    assert offsets.dtype == np.int64 and neighbours.dtype == np.int32
    assert offsets[0] == 0 and offsets[-1] == len(neighbours)
    return [neighbours[a:b].tolist() for a, b in zip(offsets, offsets[1:])]


@pytest.mark.parametrize("make", [cube, bent_blocks])
def test_hexahedra_and_their_tetrahedra(make):
    mesh = make().generate()
    assert rows(mesh) == expected(mesh)
    assert rows(mesh.split()) == expected(mesh.split())


@settings(max_examples=80, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_any_cells_in_any_order(seed):
    rng = np.random.default_rng(seed)
    points = int(rng.integers(8, 40))
    cells = {}
    for name in rng.permutation(list(EDGES)):
        k = max(max(e) for e in EDGES[name]) + 1
        count = int(rng.integers(0, 20))
        cells[name] = [rng.choice(points, k, replace=False) for _ in range(count)] or np.zeros(
            (0, k), dtype=np.int32
        )
    mesh = nmgs.Mesh(np.zeros((points, 3)), cells)
    assert rows(mesh) == expected(mesh)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_almost_split_hexahedra(seed):
    """Tetrahedra in the order of a split hexahedron, but for one node somewhere."""
    rng = np.random.default_rng(seed)
    mesh = cube((3, 2, 2)).generate().split()
    cells = mesh.cells["tetra"].copy()
    for _ in range(int(rng.integers(1, 4))):
        row, column = rng.integers(len(cells)), rng.integers(4)
        others = np.setdiff1d(np.arange(len(mesh.points)), cells[row])
        cells[row, column] = rng.choice(others)
    cells = cells[int(rng.integers(0, 12)) :]
    changed = nmgs.Mesh(mesh.points, {"tetra": cells})
    assert rows(changed) == expected(changed)


def test_figure_4_4():
    """Node 1 is related with 2, 3, 4; node 3 with 1, 2, 4, 5 and 6 (1-based)."""
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0.5, 0], [2, 1.5, 0]]
    triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 2], [2, 4, 5]]
    related = rows(nmgs.Mesh(points, {"triangle": triangles}))
    assert related[0] == [1, 2, 3]
    assert related[2] == [0, 1, 3, 4, 5]


def test_one_hexahedron_as_in_the_thesis():
    """Node 1 is related with 2, 4 and 5; with diagonals from it, with 2, 3, 4, 5, 6, 8 and 9."""
    mesh = cube((1, 1, 1)).generate()
    mesh = nmgs.Mesh(mesh.points[mesh.cells["hexahedron"][0]], {"hexahedron": [range(8)]})
    assert rows(mesh)[0] == [1, 3, 4]
    assert rows(mesh.split())[0] == [1, 2, 3, 4, 5, 7, 8]


def test_mid_side_nodes_stand_between_the_ends():
    mesh = nmgs.Mesh(np.zeros((6, 3)), {"triangle6": [range(6)]})
    assert rows(mesh) == [[3, 5], [3, 4], [4, 5], [0, 1], [1, 2], [0, 2]]


def test_nodes_without_cells_have_empty_rows():
    assert rows(nmgs.Mesh(np.zeros((4, 3)), {"line": [[3, 1]]})) == [[], [3], [], [1]]
    assert rows(nmgs.Mesh(np.zeros((0, 3)), {})) == []


def test_wrong_node_is_named():
    mesh = nmgs.Mesh(np.zeros((4, 3)), {"tetra": [[0, 1, 2, 3]]})
    mesh.cells["tetra"][0, 2] = -7
    with pytest.raises(ValueError, match="tetra 0 has node -7"):
        mesh.related_nodes()
