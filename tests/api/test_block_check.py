# SPDX-License-Identifier: LGPL-2.1-or-later
"""What model.check() finds, and that generate refuses it unless forced."""

import numpy as np
import pytest
from block_helpers import HEXA20, QUAD8, face_counts, rotations, unit_cube, unit_square

from freecad.NMGSWorkbench import nmgs


def blocks(*nodes, divisions=(4, 4, 4)):
    nodes = np.array(nodes)
    return nmgs.BlockModel(nodes, divisions[: 2 if nodes.shape[1] == 8 else 3])


def only_problem(model, kind, *names):
    problems = model.check()
    assert [p.kind for p in problems] == [kind], [p.text for p in problems]
    assert set(problems[0].blocks) == set(names)
    for name in names:
        assert name in problems[0].text
    assert np.isfinite(problems[0].place).all()
    with pytest.raises(nmgs.BlockingError) as caught:
        model.generate()
    assert set(caught.value.entities) == set(names)
    assert caught.value.reasons[0] == problems[0].text
    assert len(model.generate(force=True).points) > 0
    return problems[0]


def test_good_neighbours():
    assert blocks(unit_cube(), unit_cube((1, 0, 0)), unit_cube((1, 1, 0))).check() == []


def patch_jacobian(nodes, x, y):
    """Of a flat patch, by central differences of the shape functions of Zienkiewicz's book."""
    u, v = QUAD8.T

    def at(a, b):
        n = np.empty(8)
        n[:4] = 0.25 * (1 + a * u[:4]) * (1 + b * v[:4]) * (a * u[:4] + b * v[:4] - 1)
        n[4], n[6] = 0.5 * (1 - a * a) * (1 - b), 0.5 * (1 - a * a) * (1 + b)
        n[5], n[7] = 0.5 * (1 + a) * (1 - b * b), 0.5 * (1 - a) * (1 - b * b)
        return n @ nodes

    h = 1e-5
    along_x = (at(x + h, y) - at(x - h, y)) / (2 * h)
    along_y = (at(x, y + h) - at(x, y - h)) / (2 * h)
    return np.cross(along_x, along_y)[2]


def folded_only_between_the_nodes(seed):
    """A patch whose Jacobian is positive at its eight nodes and negative somewhere between."""
    rng = np.random.default_rng(seed)
    grid = [(a, b) for a in np.linspace(-1, 1, 9) for b in np.linspace(-1, 1, 9)]
    while True:
        nodes = np.zeros((8, 3))
        nodes[:, :2] = QUAD8 + rng.uniform(-0.6, 0.6, (8, 2))
        if min(patch_jacobian(nodes, *p) for p in QUAD8) > 0.05:
            if min(patch_jacobian(nodes, *p) for p in grid) < -0.01:
                return nodes


@pytest.mark.parametrize("seed", range(3))
def test_a_fold_is_found_between_the_nodes(seed):
    nodes = folded_only_between_the_nodes(seed)
    problem = only_problem(blocks(nodes), "folded", "Block1")
    # The place is on the patch, where the Jacobian is not positive to speak of.
    low, high = nodes.min(axis=0) - 1, nodes.max(axis=0) + 1
    assert (np.array(problem.place) >= low).all() and (np.array(problem.place) <= high).all()


@pytest.mark.parametrize("seed", range(3))
def test_a_fold_of_a_block_is_found_between_the_nodes(seed):
    patch = folded_only_between_the_nodes(seed)
    nodes = np.concatenate([patch[:4], patch[:4], patch[4:], patch[4:], patch[:4]])
    nodes[:, 2] = HEXA20[:, 2]
    only_problem(blocks(nodes), "folded", "Block1")


@pytest.mark.parametrize("seed", range(20))
def test_valid_patches_are_not_called_folded(seed):
    rng = np.random.default_rng(seed)
    nodes = np.zeros((8, 3))
    nodes[:, :2] = QUAD8 + rng.uniform(-0.25, 0.25, (8, 2))
    grid = np.linspace(-1, 1, 21)
    least = min(patch_jacobian(nodes, a, b) for a in grid for b in grid)
    assert abs(least) > 1e-3  # else the grid cannot tell
    assert ([p.kind for p in blocks(nodes).check()] == ["folded"]) == (least < 0)


def test_a_folded_block():
    nodes = unit_cube()
    nodes[6] = (0.1, 0.1, 0.1)
    only_problem(blocks(nodes), "folded", "Block1")


def test_a_strongly_curved_block_is_no_fold():
    nodes = unit_cube()
    nodes[8, 1] += 0.2
    nodes[10, 1] += 0.2
    assert blocks(nodes).check() == []


def test_a_collapsed_block():
    nodes = unit_cube()
    nodes[[3, 11, 15, 7, 19]] = nodes[[0, 0, 4, 4, 16]]
    nodes[[10, 14]] = (nodes[[2, 6]] + nodes[[3, 7]]) / 2
    assert [p.kind for p in blocks(nodes).check()] == ["collapsed"]


def test_a_collapsed_patch():
    nodes = unit_square()
    nodes[[3, 7]] = nodes[0]
    nodes[6] = (nodes[2] + nodes[3]) / 2
    assert [p.kind for p in blocks(nodes).check()] == ["collapsed"]


def test_a_mirrored_block():
    mirrored = unit_cube((1, 0, 0))[
        [1, 0, 3, 2, 5, 4, 7, 6, 8, 11, 10, 9, 12, 15, 14, 13] + [17, 16, 19, 18]
    ]
    only_problem(blocks(unit_cube(), mirrored), "mirrored", "Block2")


def test_a_patch_turned_over():
    turned = unit_square((1, 0, 0))[[1, 0, 3, 2, 4, 7, 6, 5]]
    problem = only_problem(blocks(unit_square(), turned), "mirrored", "Block1", "Block2")
    np.testing.assert_allclose(problem.place, (1, 0.5, 0))


def test_different_divisions():
    model = blocks(unit_cube(), unit_cube((1, 0, 0)))
    model.divisions[1] = (4, 5, 4)
    problems = model.check()
    assert {p.kind for p in problems} == {"divisions"}
    assert all(set(p.blocks) == {"Block1", "Block2"} for p in problems)
    assert "4" in problems[0].text and "5" in problems[0].text
    with pytest.raises(nmgs.BlockingError):
        model.generate()


@pytest.mark.parametrize("gap", [1e-3, 0.03])
def test_a_gap(gap):
    model = blocks(unit_cube(), unit_cube((1 + gap, 0, 0)))
    problems = model.check()
    assert {p.kind for p in problems} == {"gap"}
    assert all(set(p.blocks) == {"Block1", "Block2"} for p in problems)
    # Within the tolerance asked for there is none, and the nodes are shared.
    assert model.check(tolerance=2 * gap) == []
    assert len(model.generate(tolerance=2 * gap).points) == 9 * 5 * 5


def test_a_wide_gap_is_meant():
    assert blocks(unit_cube(), unit_cube((1.2, 0, 0))).check() == []


def test_a_gap_where_no_corners_are_near():
    big = unit_cube((0, 0, -1), (3, 3, 1))
    small = unit_cube((1.1, 1.1, 0.02), (1, 1, 1))
    only_problem(blocks(big, small, divisions=(6, 6, 6)), "gap", "Block1", "Block2")


def test_overlapping_blocks():
    only_problem(blocks(unit_cube(), unit_cube((0.5, 0.3, 0.2))), "overlap", "Block1", "Block2")


def test_the_same_block_twice():
    problems = blocks(unit_cube(), unit_cube()).check()
    assert {p.kind for p in problems} == {"overlap"}


def test_three_blocks_on_one_face():
    problems = blocks(unit_cube(), unit_cube((1, 0, 0)), unit_cube((1, 0, 0), (2, 1, 1))).check()
    assert "overlap" in {p.kind for p in problems}


def test_overlapping_patches():
    only_problem(blocks(unit_square(), unit_square((0.5, 0.3, 0))), "overlap", "Block1", "Block2")
    assert blocks(unit_square(), unit_square((0.5, 0.3, 0.3))).check() == []


# One face that covers four others.
def part_matching(divisions, wide_divisions):
    nodes = [unit_cube((x, y, 0)) for y in (0, 1) for x in (0, 1)]
    nodes.append(unit_cube((0, 0, -1), (2, 2, 1)))
    return nmgs.BlockModel(np.array(nodes), [divisions] * 4 + [wide_divisions])


@pytest.mark.parametrize("turn", range(0, 24, 5))
def test_part_matching_faces_share_coincident_nodes(turn):
    order, axes = rotations()[turn]
    model = part_matching((3, 3, 2), (6, 6, 2))
    model.nodes[4] = model.nodes[4][order]
    wide = np.array([6, 6, 2])
    # The turned block's own direction d runs along the axis that its numbering sends it to.
    turned = HEXA20[order]
    for d in range(3):
        corner = [i for i in range(8) if HEXA20[i, d] > 0]
        axis = int(np.argmax(np.abs(turned[corner].mean(axis=0))))
        model.divisions[4, d] = wide[axis]
    assert model.check() == []
    mesh = model.generate()
    assert len(mesh.points) == 7 * 7 * 5
    faces, counts = face_counts(mesh.cells["hexahedron"])
    assert counts.max() == 2
    # 6 x 6 x 4 elements have this many outer faces.
    assert (counts == 1).sum() == 2 * 36 + 4 * 24


def test_part_matching_faces_that_do_not_fit_are_named():
    problems = part_matching((3, 3, 2), (5, 6, 2)).check()
    assert {p.kind for p in problems} == {"divisions"}
    assert {frozenset(p.blocks) for p in problems} == {
        frozenset((f"Block{b}", "Block5")) for b in (1, 2, 3, 4)
    }


def test_part_matching_edges_of_patches():
    nodes = [unit_square(), unit_square((1, 0, 0)), unit_square((0, -1, 0), (2, 1))]
    model = nmgs.BlockModel(np.array(nodes), [(3, 2), (3, 2), (6, 2)])
    assert model.check() == []
    assert len(model.generate().points) == 7 * 5
    model.divisions[2] = (5, 2)
    problems = model.check()
    assert {p.kind for p in problems} == {"divisions"}
    assert {frozenset(p.blocks) for p in problems} == {
        frozenset(("Block1", "Block3")),
        frozenset(("Block2", "Block3")),
    }


def test_crossed_bars():
    """Faces that overlap in part with no corner of one on the other; the nodes coincide there."""
    nodes = [unit_cube((0, 1, 0), (3, 1, 1)), unit_cube((1, 0, 1), (1, 3, 1))]
    model = nmgs.BlockModel(np.array(nodes), [(6, 2, 2), (2, 6, 2)])
    assert model.check() == []
    mesh = model.generate()
    assert len(mesh.points) == 2 * 7 * 3 * 3 - 9
    model.divisions[1] = (3, 6, 2)
    assert {p.kind for p in model.check()} == {"divisions"}


def upright(origin, length, height=1):
    """A patch on the line along x from the origin, standing on the plane z = const."""
    nodes = unit_square((0, 0, 0), (length, height))
    return nodes[:, [0, 2, 1]] + np.asarray(origin, float)


@pytest.mark.parametrize("divisions", [4, 5])
def test_a_rib_on_a_skin(divisions):
    """An edge inside a patch is joined to nothing, whether the nodes fall together or not."""
    model = nmgs.BlockModel(
        np.array([unit_square((0, 0, 0), (4, 2)), upright((0, 1, 0), 4)]), [(4, 2), (divisions, 2)]
    )
    problem = only_problem(model, "divisions", "Block1", "Block2")
    assert "inside" in problem.text
    assert problem.place[1:] == pytest.approx((1, 0))
    # Between two patches it is joined, as an edge of both.
    model = nmgs.BlockModel(
        np.array(
            [unit_square((0, 0, 0), (4, 1)), unit_square((0, 1, 0), (4, 1)), upright((0, 1, 0), 4)]
        ),
        [(4, 2)] * 3,
    )
    assert model.check() == []


def test_patches_that_overlap_in_a_narrow_strip():
    only_problem(blocks(unit_square(), unit_square((0.91, 0.3, 0))), "overlap", "Block1", "Block2")


def test_blocks_that_overlap_at_a_corner_only():
    only_problem(blocks(unit_cube(), unit_cube((0.93, 0.93, 0.2))), "overlap", "Block1", "Block2")


@pytest.mark.parametrize("divisions, fits", [((4, 4, 4), True), ((4, 3, 4), False)])
def test_a_block_that_stands_on_its_edge(divisions, fits):
    """On the middle of another's face: one edge of it lies there, and no face."""
    prism = unit_cube((0, 0, 0), (1, 1, 1))
    prism = np.column_stack(
        [2 + prism[:, 0] - prism[:, 2], prism[:, 1], 1 + prism[:, 0] + prism[:, 2]]
    )
    model = blocks(unit_cube((0, 0, 0), (4, 1, 1)), prism)
    model.divisions[:] = [(4, 4, 4), divisions]
    if fits:
        assert model.check() == []
    else:
        only_problem(model, "divisions", "Block1", "Block2")


def test_a_narrow_wedge_between_blocks_is_no_gap():
    """Two blocks that share an edge at a small angle."""
    upper = unit_cube((0, 0, 0))
    lower = unit_cube((0, 0, -1))
    lower[:, 2] -= 0.3 * lower[:, 0] * (1 + lower[:, 2]) ** 0
    assert blocks(upper, lower).check() == []


def test_bad_tolerance():
    for value in (-1, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="tolerance"):
            blocks(unit_cube()).check(tolerance=value)
