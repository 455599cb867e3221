# SPDX-License-Identifier: LGPL-2.1-or-later
import dataclasses

import numpy as np
import pytest
from block_helpers import unit_cube, unit_square
from hypothesis import given
from hypothesis import strategies as st

from freecad.NMGSWorkbench import nmgs

g = nmgs.grading


def sizes(grading, count, length=1.0):
    positions = dataclasses.replace(grading, length=length).positions(count)
    assert len(positions) == count + 1
    assert positions[0] == 0 and positions[-1] == 1
    result = np.diff(positions)
    assert (result > 0).all()
    return result * length


@given(st.integers(1, 50), st.floats(0.6, 1.6))
def test_geometric_by_ratio(count, ratio):
    s = sizes(g.geometric(ratio=ratio), count)
    np.testing.assert_allclose(s[1:], ratio * s[:-1], rtol=1e-9, atol=1e-14)


@given(st.integers(2, 100), st.floats(0.2, 5))
def test_geometric_by_size(count, factor):
    size = min(factor / count, 0.9)
    s = sizes(g.geometric(first=size), count)
    assert s[0] == pytest.approx(size, rel=1e-9)
    ratio = s[1:] / s[:-1]
    np.testing.assert_allclose(ratio, ratio[0], rtol=1e-4)
    np.testing.assert_allclose(sizes(g.geometric(last=size), count), s[::-1], rtol=1e-6)


@given(st.integers(3, 100), st.floats(0.1, 4), st.floats(0.1, 4))
def test_two_sided_by_sizes(count, a, b):
    first, last = a / count, b / count
    if first + last > 0.9:
        return
    s = sizes(g.two_sided(first=first, last=last), count)
    assert s[0] == pytest.approx(first, rel=1e-8)
    assert s[-1] == pytest.approx(last, rel=1e-8)


def test_two_sided_by_ratio_is_symmetric():
    s = sizes(g.two_sided(ratio=1.5), 7)
    np.testing.assert_allclose(s, s[::-1], rtol=1e-12)
    np.testing.assert_allclose(s[1:4] / s[:3], 1.5, rtol=1e-12)


@given(st.integers(3, 100), st.floats(0.1, 1.5), st.floats(0.1, 1.5))
def test_tanh_has_the_sizes(count, a, b):
    first, last = a / count, b / count
    if first + last > 0.9:
        return
    s = sizes(g.tanh(first=first, last=last), count)
    assert s[0] == pytest.approx(first, rel=1e-6)
    assert s[-1] == pytest.approx(last, rel=1e-6)


def test_tanh_from_one_end():
    s = sizes(g.tanh(first=0.01), 10)
    assert s[0] == pytest.approx(0.01, rel=1e-9)
    assert (np.diff(s) > 0).all()
    np.testing.assert_allclose(sizes(g.tanh(last=0.01), 10), s[::-1], rtol=1e-9)


def test_positions_are_scaled():
    np.testing.assert_array_equal(g.positions([2, 3, 6]).positions(2), [0, 0.25, 1])
    with pytest.raises(ValueError, match="3"):
        g.positions([0, 0.5, 1]).positions(3)


@pytest.mark.parametrize(
    "call",
    [
        lambda: g.geometric(),
        lambda: g.geometric(ratio=1, first=1),
        lambda: g.geometric(ratio=-1),
        lambda: g.geometric(ratio=float("nan")),
        lambda: g.two_sided(),
        lambda: g.tanh(),
        lambda: g.positions([1]),
        lambda: g.positions([0, 1, 1]),
        lambda: g.positions([0, float("inf")]),
        lambda: g.Grading("nonsense"),
        lambda: g.geometric(first=1).positions(3),
        lambda: sizes(g.geometric(first=2), 3),
        lambda: sizes(g.two_sided(first=0.5, last=0.6), 3),
    ],
)
def test_bad_gradings(call):
    with pytest.raises(ValueError):
        call()


def test_a_physical_first_size_is_met_in_the_mesh():
    model = nmgs.BlockModel([unit_cube(size=(10, 1, 1))], [8, 2, 2])
    model.set_grading(0, "xi", g.geometric(first=0.25))
    x = np.unique(np.round(model.generate().points[:, 0], 9))
    assert x[1] == pytest.approx(0.25, rel=1e-9)
    assert x[-1] == 10


def test_a_chain_is_graded_in_one_sense_whatever_its_numbering():
    """Two squares over each other, the upper one turned by half a turn: both are graded alike."""
    upper = unit_square((0, 1, 0))[[2, 3, 0, 1, 6, 7, 4, 5]]
    model = nmgs.BlockModel([unit_square(), upper], [4, 2])
    model.set_grading(0, "xi", g.geometric(ratio=2))
    assert model.check() == []
    mesh = model.generate()
    assert len(mesh.points) == 5 * 5
    np.testing.assert_allclose(
        np.unique(np.round(mesh.points[:, 0], 9)), np.array([0, 1, 3, 7, 15]) / 15, atol=1e-9
    )


def test_gradings_that_disagree_are_named():
    model = nmgs.BlockModel([unit_square(), unit_square((0, 1, 0))], [4, 2])
    model.set_grading(0, "xi", g.geometric(ratio=2), chain=False)
    problems = model.check()
    assert [p.kind for p in problems] == ["spacing"]
    assert set(problems[0].blocks) == {"Block1", "Block2"}
    with pytest.raises(nmgs.BlockingError):
        model.generate()


def test_a_wrong_count_is_named():
    model = nmgs.BlockModel([unit_square()], [4, 2])
    model.grading[0][1] = g.positions([0, 0.1, 0.2, 1])
    with pytest.raises(ValueError, match="element 1 along eta"):
        model.generate()


def test_a_moebius_strip_takes_symmetric_gradings_only():
    """Three patches round a strip that is turned over once."""
    nodes = []
    for k in range(3):
        patch = np.empty((8, 3))
        for n, (u, v) in enumerate(
            [(-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0)]
        ):
            t = 2 * np.pi * (k + (u + 1) / 2) / 3
            r = 1 + 0.3 * v * np.cos(t / 2)
            patch[n] = (r * np.cos(t), r * np.sin(t), 0.3 * v * np.sin(t / 2))
        nodes.append(patch)
    model = nmgs.BlockModel(nodes, [6, 4])
    with pytest.raises(nmgs.BlockingError, match="turned round"):
        model.set_grading(0, "eta", g.geometric(ratio=2))
    model.set_grading(0, "eta", g.two_sided(ratio=2))
    assert len(model.generate(force=True).points) == 18 * 5
