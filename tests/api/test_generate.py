# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generated meshes against polynomials, closed forms, Euler's formula, and the count of faces."""

import numpy as np
import pytest
from block_helpers import (
    HEXA20,
    QUAD8,
    euler_of_solid,
    euler_of_surface,
    face_counts,
    hexahedron_volumes,
    rotations,
    unit_cube,
    unit_square,
)
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad.NMGSWorkbench import nmgs
from nmgs_kernel import core


def uniform_lattice(counts):
    """Natural coordinates of a block's nodes, xi fastest."""
    axes = [np.linspace(-1, 1, n + 1) for n in counts]
    grids = np.meshgrid(*axes[::-1], indexing="ij")
    return np.stack([g.ravel() for g in grids[::-1]], axis=1)


@settings(max_examples=40, deadline=None)
@given(st.data())
def test_polynomials_of_the_serendipity_space_are_reproduced(data):
    """xi^a eta^b zeta^c of superlinear degree 2 at most are mapped exactly."""
    dimension = data.draw(st.sampled_from([2, 3]))
    natural = QUAD8 if dimension == 2 else HEXA20
    powers = [p for p in np.ndindex(*(3,) * dimension) if sum(a for a in p if a > 1) <= 2]
    coefficients = np.array(
        data.draw(st.lists(st.floats(-1, 1), min_size=3 * len(powers), max_size=3 * len(powers)))
    ).reshape(len(powers), 3)

    def polynomial(at):
        terms = [np.prod(at ** np.array(p), axis=1) for p in powers]
        flat = np.zeros((len(at), 3))
        flat[:, :dimension] = at
        # No two nodes at one place, which would be one.
        return flat + 0.1 * np.stack(terms, axis=1) @ coefficients

    counts = data.draw(st.lists(st.integers(1, 5), min_size=dimension, max_size=dimension))
    model = nmgs.BlockModel([polynomial(natural)], [counts])
    mesh = model.generate(force=True)
    np.testing.assert_allclose(mesh.points, polynomial(uniform_lattice(counts)), atol=1e-12)


@settings(max_examples=40, deadline=None)
@given(st.data())
def test_random_blocks_orders_and_numberings(data):
    """Blocks of a 2 x 2 x 2 grid with curved inner faces, in any order and numbering: one node a
    place, every inner face shared by two hexahedra, the volume as it must be."""
    cells = data.draw(
        st.lists(st.tuples(*[st.integers(0, 1)] * 3), min_size=1, max_size=8, unique=True)
    )
    grid = data.draw(st.lists(st.integers(1, 3), min_size=6, max_size=6))
    turns = data.draw(st.lists(st.integers(0, 23), min_size=len(cells), max_size=len(cells)))
    every = rotations()

    def bend(p):
        x, y, z = p.T
        bump = 0.1 * np.sin(np.pi * x) * np.sin(np.pi * y) * np.sin(np.pi * z)
        return p + bump[:, None] * [1, -0.5, 0.3]

    nodes, divisions = [], []
    for cell, turn in zip(cells, turns):
        order, _ = every[turn]
        nodes.append(bend(unit_cube(cell))[order])
        along = [grid[2 * d + cell[d]] for d in range(3)]
        turned = HEXA20[order]
        # Natural direction d of the renumbered block runs along this axis of the cell.
        ends = [turned[HEXA20[:, d] > 0.5].mean(axis=0) for d in range(3)]
        divisions.append([along[int(np.argmax(np.abs(e)))] for e in ends])
    model = nmgs.BlockModel(np.array(nodes), divisions)
    assert model.check() == []
    mesh = model.generate()
    hexahedra = mesh.cells["hexahedron"]

    places = {
        tuple(np.round(p, 9))
        for cell in cells
        for p in bend_lattice(cell, [grid[2 * d + cell[d]] for d in range(3)], bend)
    }
    assert len(mesh.points) == len(places)
    assert {tuple(p) for p in np.round(mesh.points, 9) + 0.0} == {
        tuple(np.array(p) + 0.0) for p in places
    }
    assert face_counts(hexahedra)[1].max() <= 2
    np.testing.assert_array_equal(np.unique(hexahedra), np.arange(len(mesh.points)))
    if len(cells) == 8:
        assert euler_of_solid(hexahedra) == 1
    assert hexahedron_volumes(mesh.points, hexahedra).min() > 0


def bend_lattice(cell, counts, bend):
    """Places of a cell's lattice by the block's own nodes, with another code: the shape functions
    are fitted by least squares to the serendipity monomials."""
    powers = [p for p in np.ndindex(3, 3, 3) if sum(a for a in p if a > 1) <= 2]

    def monomials(at):
        return np.stack([np.prod(at ** np.array(p), axis=1) for p in powers], axis=1)

    nodes = bend(unit_cube(cell))
    coefficients = np.linalg.solve(monomials(HEXA20), nodes)
    return monomials(uniform_lattice(counts)) @ coefficients


@pytest.mark.parametrize("dimension", [2, 3])
def test_one_block_has_the_lattices_counts(dimension):
    nodes = unit_square() if dimension == 2 else unit_cube()
    mesh = nmgs.BlockModel([nodes], [3, 4, 5][:dimension]).generate()
    assert len(mesh.points) == (4 * 5 if dimension == 2 else 4 * 5 * 6)
    assert len(mesh.cells["quad" if dimension == 2 else "hexahedron"]) == (
        12 if dimension == 2 else 60
    )
    if dimension == 2:
        assert euler_of_surface(mesh.cells["quad"]) == 1
    else:
        assert euler_of_solid(mesh.cells["hexahedron"]) == 1


def test_same_bytes_for_any_number_of_threads():
    for model in (
        nmgs.shapes.ball(divisions=7),
        nmgs.shapes.torus_surface(divisions=9),
        nmgs.BlockModel(
            [unit_cube(), unit_cube((1, 0, 0)), unit_cube((0, 0, -1), (2, 1, 1))],
            [(20, 20, 20), (20, 20, 20), (40, 20, 5)],
        ),
    ):
        results = []
        for threads in (1, 2, 5):
            core.set_threads(threads)
            mesh = model.generate()
            results.append([mesh.points.tobytes()] + [c.tobytes() for c in mesh.cells.values()])
        core.set_threads(0)
        assert results[0] == results[1] == results[2]


def test_cancel_and_errors_of_the_callback():
    model = nmgs.shapes.cube(divisions=60)
    with pytest.raises(nmgs.Cancelled):
        model.generate(progress=lambda fraction: False)
    with pytest.raises(ZeroDivisionError):
        model.generate(progress=lambda fraction: 1 / 0)
    seen = []
    model.generate(progress=seen.append)
    assert seen and all(0 <= f <= 1 for f in seen) and seen == sorted(seen)


@pytest.mark.parametrize(
    "divisions",
    [
        (10**4, 10**4, 10**4),
        (2**31 - 1,) * 3,
        (2**31 - 1, 1, 1),
        (1, 2**31 - 1, 2**31 - 1),
    ],
)
def test_what_cannot_fit_is_refused_with_its_size(divisions):
    model = nmgs.BlockModel([unit_cube()], [divisions])
    with pytest.raises(ValueError, match="divisions: .*(bytes|cells|nodes)"):
        model.generate()


@pytest.mark.parametrize(
    "nodes, divisions, message",
    [
        (np.zeros((1, 9, 3)), [1, 1], "nodes"),
        (np.zeros((1, 8, 2)), [1, 1], "nodes"),
        (np.zeros((0, 8, 3)), np.zeros((0, 2)), "nodes"),
        (np.full((1, 8, 3), np.nan), [1, 1], "node 1 of element 1"),
        (np.full((1, 8, 3), np.inf), [1, 1], "node 1 of element 1"),
        ([unit_square()], [0, 1], "element 1 has 0"),
        ([unit_square()], [1, -1], "element 1 has -1"),
        ([unit_square()], [1.5, 1], "1.5"),
        ([unit_square()], [np.nan, 1], "divisions"),
        ([unit_square()], [1, 1, 1], "divisions"),
        ([unit_square()], [2**40, 1], "divisions"),
        ([unit_square()], ["a", "b"], "divisions"),
    ],
)
def test_bad_models(nodes, divisions, message):
    with pytest.raises(ValueError, match=message):
        nmgs.BlockModel(nodes, divisions)


def test_bad_reference():
    with pytest.raises(ValueError, match="reference"):
        nmgs.BlockModel([unit_square()], [1, 1], "two\nlines")
    with pytest.raises(TypeError, match="reference"):
        nmgs.BlockModel([unit_square()], [1, 1], 3)


def test_nodes_changed_afterwards_are_checked_again():
    model = nmgs.BlockModel([unit_square()], [1, 1])
    model.nodes[0, 3, 1] = np.nan
    with pytest.raises(ValueError, match="node 4 of element 1"):
        model.generate()


def test_bad_order():
    with pytest.raises(ValueError, match="order"):
        nmgs.shapes.cube().generate(order=3)
