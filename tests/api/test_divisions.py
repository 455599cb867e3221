# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from block_helpers import unit_cube, unit_square
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad.NMGSWorkbench import nmgs


def row(count):
    return nmgs.BlockModel([unit_square((i, 0, 0)) for i in range(count)], [1, 1])


def test_chains_of_a_row():
    chains = row(3).chains()
    assert len(set(chains[:, 1])) == 1
    assert len(set(chains.ravel())) == 4


def test_a_hard_count_runs_along_its_chain():
    model = row(4).with_divisions(hard={(2, "eta"): 7, (1, 0): 3})
    np.testing.assert_array_equal(model.divisions, [[1, 7], [3, 7], [1, 7], [1, 7]])
    assert model.check() == []


def test_the_original_is_left_as_it_was():
    model = row(2)
    model.with_divisions(hard={(0, 1): 5})
    np.testing.assert_array_equal(model.divisions, [[1, 1], [1, 1]])
    model.set_divisions(hard={(0, 1): 5})
    np.testing.assert_array_equal(model.divisions, [[1, 5], [1, 5]])


def test_hard_before_soft_before_size_before_present():
    model = row(3).with_divisions(
        size=0.25, hard={(0, "xi"): 2}, soft={(0, "xi"): 9, (1, "xi"): 5, (1, "eta"): 3}
    )
    np.testing.assert_array_equal(model.divisions, [[2, 3], [5, 3], [4, 3]])


def test_size_is_along_the_longest_edge():
    nodes = unit_square(size=(1, 1))
    nodes[2] = (2, 1, 0)  # the upper edge is 2 long
    nodes[[5, 6]] = (nodes[1] + nodes[2]) / 2, (nodes[2] + nodes[3]) / 2
    model = nmgs.BlockModel([nodes], [1, 1]).with_divisions(size=0.5)
    assert model.divisions[0, 0] == 4


def test_size_follows_curved_edges():
    """A quarter of a circle is longer than its chord: 1.57 instead of 1.41."""
    model = nmgs.shapes.cylinder_surface(radius=1, height=1).with_divisions(size=1.45)
    assert (model.divisions[:, 0] == 2).all()


def test_a_contradiction_names_the_blocks_and_the_chain():
    with pytest.raises(nmgs.BlockingError) as caught:
        row(4).set_divisions(hard={(0, "eta"): 3, (3, "eta"): 4})
    assert caught.value.entities == ["Block1", "Block2", "Block3", "Block4"]
    text = str(caught.value)
    assert "Block1 along eta is to have 3" in text and "Block4 along eta 4" in text
    assert "Block2 along eta" in text and "Block3 along eta" in text


def test_the_core_of_a_disc_links_what_lies_opposite():
    model = nmgs.shapes.disc()
    with pytest.raises(nmgs.BlockingError):
        # The ring patches 1 and 3 share the core's direction; 1 and 2 do not.
        model.set_divisions(hard={(1, "eta"): 3, (3, "eta"): 4})
    model.set_divisions(hard={(1, "eta"): 3, (2, "eta"): 4})
    assert model.check() == []


@settings(max_examples=30, deadline=None)
@given(st.data())
def test_any_solution_can_be_meshed(data):
    """Random blocks of a grid, in a random order, with random wishes."""
    cells = data.draw(
        st.lists(
            st.tuples(st.integers(0, 2), st.integers(0, 2), st.integers(0, 1)),
            min_size=1,
            max_size=8,
            unique=True,
        )
    )
    counts = data.draw(
        st.lists(st.integers(1, 4), min_size=3 * len(cells), max_size=3 * len(cells))
    )
    model = nmgs.BlockModel(
        [unit_cube(c) for c in cells], np.array(counts).reshape(-1, 3)
    ).with_divisions(soft={(0, 0): 5})
    assert model.check() == []
    chains = model.chains()
    for chain in np.unique(chains):
        assert len(set(model.divisions[chains == chain])) == 1


@pytest.mark.parametrize(
    "arguments, name",
    [
        (dict(size=0), "size"),
        (dict(size=float("nan")), "size"),
        (dict(hard={(0, "xi"): 0}), "hard"),
        (dict(soft={(0, "xi"): 1.5}), "soft"),
        (dict(hard={(9, "xi"): 1}), "element"),
        (dict(hard={(0, "zeta"): 1}), "direction"),
        (dict(hard={3: 1}), "element, direction"),
        (dict(size=1e-300), "size"),
    ],
)
def test_bad_arguments(arguments, name):
    with pytest.raises(ValueError, match=name):
        row(2).set_divisions(**arguments)
