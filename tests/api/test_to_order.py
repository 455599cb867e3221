# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mid-side nodes: the lattice of twice as many divisions has them all, on the true mapping."""

import numpy as np
import pytest
from blocks import bent_blocks, bent_patches, cube

from freecad.NMGSWorkbench import nmgs


def places(points: np.ndarray) -> set:
    return {tuple(p) for p in np.round(points, 9) + 0.0}


@pytest.mark.parametrize("make, name", [(bent_patches, "quad8"), (bent_blocks, "hexahedron20")])
def test_mid_sides_are_nodes_of_the_doubled_lattice(make, name):
    model = make()
    mesh = model.generate().to_order(2)
    fine = make(tuple(2 * n for n in model.divisions[0])).generate()
    assert set(mesh.cells) == {name}
    assert places(mesh.points) <= places(fine.points)
    # Each element has 8 or 20 of the 9 or 27 nodes that its lattice has: none lies on a straight
    # edge by accident, for the blocks are curved.
    straight = nmgs.Mesh(model.generate().points, model.generate().cells).to_order(2)
    assert not places(straight.points) <= places(fine.points)


def test_diagonals_of_split_patches_are_on_the_mapping_too():
    model = bent_patches()
    mesh = model.generate().split().to_order(2)
    fine = bent_patches((6, 8)).generate()
    assert places(mesh.points) == places(fine.points)


def test_split_blocks():
    model = bent_blocks()
    linear = model.generate()
    mesh = linear.split().to_order(2)
    fine = places(bent_blocks((6, 4, 8)).generate().points)
    count = len(linear.points)
    ends = mesh.mid_side_ends
    middles = mesh.points[-len(ends) :]
    outside = (ends < count).all(axis=1)
    assert places(middles[outside]) <= fine
    # Edges and faces of the lattice: every mid-side and face node of the fine one, not the centres.
    cells = len(linear.cells["hexahedron"])
    assert outside.sum() + count + cells == len(fine)
    assert (mesh.quality("jacobian_ratio")["tetra10"] > 0.3).all()
    volume = linear.to_order(2).quality("volume")["hexahedron20"].sum()
    assert mesh.quality("volume")["tetra10"].sum() == pytest.approx(volume, rel=2e-3)


def test_graded_model():
    model = bent_blocks((2, 2, 2))
    model.grading[0][0] = nmgs.grading.positions([0, 0.2, 1])
    model.grading[1][0] = nmgs.grading.positions([0, 0.2, 1])
    mesh = model.generate().to_order(2)
    fine = bent_blocks((4, 4, 4))
    fine.grading[0][0] = nmgs.grading.positions([0, 0.1, 0.2, 0.6, 1])
    fine.grading[1][0] = nmgs.grading.positions([0, 0.1, 0.2, 0.6, 1])
    assert places(mesh.points) <= places(fine.generate().points)


def test_order_is_that_of_first_appearance_and_ends_are_told():
    mesh = bent_blocks().generate()
    raised = mesh.to_order(2)
    cells = raised.cells["hexahedron20"]
    assert (cells[:, :8] == mesh.cells["hexahedron"]).all()
    count = len(mesh.points)
    assert (raised.points[:count] == mesh.points).all()
    seen = dict.fromkeys(cells[:, 8:].ravel().tolist())
    assert list(seen) == list(range(count, len(raised.points)))
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)]
    pairs += [(i, i + 4) for i in range(4)]
    for local, (a, b) in enumerate(pairs):
        ends = np.sort(cells[:, [a, b]], axis=1)
        assert (raised.mid_side_ends[cells[:, 8 + local] - count] == ends).all()


def test_straight_middles_without_a_model():
    points = [[0, 0, 0], [2, 0, 0], [0, 4, 0], [0, 0, 6], [2, 2, 2]]
    mesh = nmgs.Mesh(points, {"tetra": [[0, 1, 2, 3], [1, 2, 3, 4]], "triangle": [[0, 2, 1]]})
    raised = mesh.to_order(2)
    assert len(raised.points) == 5 + 9  # Euler: two tetrahedra that share a face have 9 edges
    ends = raised.mid_side_ends
    assert raised.points[5:] == pytest.approx(mesh.points[ends].mean(axis=1))
    assert raised.quality("volume")["tetra10"] == pytest.approx(mesh.quality("volume")["tetra"])
    assert raised.quality("area")["triangle6"] == pytest.approx([4])


def test_moved_mesh_follows_small_moves_and_refuses_large_ones():
    model = bent_blocks()
    mesh = model.generate()
    exact = mesh.to_order(2)
    mesh.points += [0.01, 0, 0]
    assert mesh.to_order(2).points == pytest.approx(exact.points + [0.01, 0, 0], abs=1e-12)
    mesh.points += [100, 0, 0]
    raised = mesh.to_order(2)
    ends = raised.mid_side_ends
    assert raised.points[len(mesh.points) :] == pytest.approx(mesh.points[ends].mean(axis=1))


def test_groups():
    mesh = cube((2, 2, 2)).generate()
    top = np.flatnonzero(mesh.points[:, 2] == 1)
    left_and_right = np.flatnonzero((mesh.points[:, 0] == 0) | (mesh.points[:, 0] == 1))
    mesh.groups["top"] = ("node", top.astype(np.int32))
    mesh.groups["sides"] = ("node", left_and_right.astype(np.int32))
    mesh.groups["half"] = ("hexahedron", np.arange(4, dtype=np.int32))
    raised = mesh.to_order(2)
    assert raised.groups["half"][0] == "hexahedron20"
    assert (raised.groups["half"][1] == np.arange(4)).all()
    assert set(raised.groups["top"][1]) == set(np.flatnonzero(raised.points[:, 2] == 1))
    x = raised.points[:, 0]
    assert set(raised.groups["sides"][1]) == set(np.flatnonzero((x == 0) | (x == 1)))


def test_bad_input():
    mesh = cube((1, 1, 1)).generate()
    with pytest.raises(ValueError, match="order.*3"):
        mesh.to_order(3)
    with pytest.raises(ValueError, match="hexahedron20"):
        mesh.to_order(2).to_order(2)
