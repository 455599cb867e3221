# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads into triangles, hexahedra into twelve tetrahedra."""

import collections
import itertools

import numpy as np
import pytest
from blocks import CORNERS_3D, bent_blocks, bent_patches, cube
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs import convert

TETRA_FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


def face_uses(tetra: np.ndarray) -> collections.Counter:
    faces = np.sort(tetra[:, TETRA_FACES].reshape(-1, 3), axis=1)
    return collections.Counter(map(tuple, faces.tolist()))


def assert_conforming(mesh: nmgs.Mesh, hexahedra: nmgs.Mesh) -> None:
    """Every inner face belongs to two tetrahedra, and the outer ones are twice the outer quads."""
    uses = face_uses(mesh.cells["tetra"])
    assert set(uses.values()) <= {1, 2}
    outer = sum(1 for n in uses.values() if n == 1)
    assert outer == 2 * len(hexahedra.boundary().cells["quad"])


def renumbered(mesh: nmgs.Mesh, seed: int) -> nmgs.Mesh:
    """The same mesh with its nodes, cells and the corners that cells start from shuffled."""
    rng = np.random.default_rng(seed)
    new = rng.permutation(len(mesh.points)).astype(np.int32)
    points = np.empty_like(mesh.points)
    points[new] = mesh.points
    cells = new[mesh.cells["hexahedron"]]
    turns = np.array([[0, 1, 2, 3, 4, 5, 6, 7], [1, 2, 3, 0, 5, 6, 7, 4], [4, 7, 6, 5, 0, 3, 2, 1]])
    cells = np.stack([c[turns[rng.integers(3)]] for c in rng.permutation(cells)])
    return nmgs.Mesh(points, {"hexahedron": cells})


@pytest.mark.parametrize("make", [cube, bent_blocks])
@pytest.mark.parametrize("seed", range(3))
def test_conforming_positive_and_of_the_same_volume(make, seed):
    mesh = renumbered(make().generate(), seed)
    tetra = mesh.split()
    assert len(tetra.cells["tetra"]) == 12 * len(mesh.cells["hexahedron"])
    assert len(tetra.points) == len(mesh.points) + len(mesh.cells["hexahedron"])
    assert (tetra.points[: len(mesh.points)] == mesh.points).all()
    assert_conforming(tetra, mesh)
    volumes = tetra.quality("volume")["tetra"]
    assert (volumes > 0).all()
    if make is cube:
        assert volumes.sum() == pytest.approx(1)
    # Flat or not, the two triangulations of a face differ by the face's bilinear bulge only.
    assert volumes.sum() == pytest.approx(mesh.quality("volume")["hexahedron"].sum(), rel=1e-2)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0.0, 0.1, 0.2, 0.25]))
def test_random_lattices(seed, amount):
    rng = np.random.default_rng(seed)
    mesh = cube((3, 3, 2)).generate()
    mesh.points += rng.uniform(-amount, amount, mesh.points.shape) * [1 / 3, 1 / 3, 1 / 2]
    mesh = renumbered(mesh, seed)
    tetra = mesh.split()
    assert_conforming(tetra, mesh)
    valid = mesh.quality()["hexahedron"] > 0.2
    assert (tetra.quality("volume")["tetra"].reshape(-1, 12)[valid] > 0).all()


def test_euler():
    mesh = cube((3, 4, 5)).generate().split()
    cells = len(mesh.cells["tetra"])
    faces = len(face_uses(mesh.cells["tetra"]))
    edges = len(mesh.related_nodes()[1]) // 2
    assert len(mesh.points) - edges + faces - cells == 1  # a ball


def test_centroid_of_a_warped_hexahedron_moves_inside():
    """A top corner pushed far down: the mean of the corners sees one face from behind."""
    rng = np.random.default_rng(5)
    found = 0
    for _ in range(3000):
        points = CORNERS_3D / 2 + rng.uniform(-0.36, 0.36, (8, 3))
        mesh = nmgs.Mesh(points, {"hexahedron": [range(8)]})
        tetra = mesh.split()
        mean = points.mean(axis=0)
        moved = tetra.points[8] != pytest.approx(mean)
        at_mean = nmgs.Mesh(np.vstack([points, mean]), tetra.cells)
        if moved:
            found += 1
            assert tetra.quality("volume")["tetra"].min() > 0
            assert at_mean.quality("volume")["tetra"].min() <= 0
    assert found > 0


def trilinear_jacobian_is_positive(mesh: nmgs.Mesh) -> np.ndarray:
    """Of each hexahedron, at 5^3 points; those near the limit may pass for valid."""
    p = mesh.points[mesh.cells["hexahedron"]]
    least = np.full(len(p), np.inf)
    for at in itertools.product(np.linspace(-1, 1, 5), repeat=3):
        f = 1 + CORNERS_3D * at
        slope = [CORNERS_3D[:, d] * np.delete(f, d, axis=1).prod(axis=1) / 8 for d in range(3)]
        least = np.minimum(least, np.linalg.det(np.einsum("dn,cnx->cdx", np.array(slope), p)))
    return least > 0.02 * np.abs(mesh.quality("volume")["hexahedron"]) / 8


@pytest.mark.parametrize("seed", range(4))
def test_strongly_warped_valid_hexahedra_get_positive_tetrahedra(seed):
    rng = np.random.default_rng(seed)
    count = 3000
    points = CORNERS_3D / 2 + rng.uniform(-0.4, 0.4, (count, 8, 3))
    mesh = nmgs.Mesh(points.reshape(-1, 3), {"hexahedron": np.arange(8 * count).reshape(-1, 8)})
    valid = trilinear_jacobian_is_positive(mesh)
    assert valid.sum() > 100
    volumes = mesh.split().quality("volume")["tetra"].reshape(-1, 12).min(axis=1)
    assert (volumes[valid] > 0).all()


@pytest.mark.parametrize("seed", range(4))
def test_warped_lattices_stay_conforming(seed):
    """With hexahedra that need the longer diagonal, and quads on all outer faces."""
    rng = np.random.default_rng(seed)
    mesh = cube((4, 4, 4)).generate()
    mesh.points += rng.uniform(-0.115, 0.115, mesh.points.shape)
    mesh = renumbered(mesh, seed)
    surface, numbers, _ = convert.boundary_with_parents(mesh)
    mesh = nmgs.Mesh(
        mesh.points,
        {"hexahedron": mesh.cells["hexahedron"], "quad": numbers[surface.cells["quad"]]},
    )
    tetra = mesh.split()
    assert_conforming(tetra, mesh)
    uses = face_uses(tetra.cells["tetra"])
    assert all(uses[tuple(t)] == 1 for t in np.sort(tetra.cells["triangle"], axis=1).tolist())
    valid = trilinear_jacobian_is_positive(mesh)
    volumes = tetra.quality("volume")["tetra"].reshape(-1, 12).min(axis=1)
    assert (volumes[valid] > 0).mean() > 0.9


def diagonals(triangles: np.ndarray) -> list:
    """The two nodes that both triangles of each quad have."""
    pairs = triangles.reshape(-1, 6).tolist()
    return [sorted(set(row[:3]) & set(row[3:])) for row in pairs]


def test_shorter_diagonal_of_quads():
    rng = np.random.default_rng(2)
    n = 200
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
    points = (square + rng.uniform(-0.3, 0.3, (n, 4, 3))).reshape(-1, 3)
    mesh = nmgs.Mesh(points, {"quad": np.arange(4 * n).reshape(n, 4)})
    triangles = mesh.split().cells["triangle"]
    first = np.linalg.norm(points[0::4] - points[2::4], axis=1)
    second = np.linalg.norm(points[1::4] - points[3::4], axis=1)
    for q, diagonal in enumerate(diagonals(triangles)):
        expected = [4 * q + 1, 4 * q + 3] if second[q] <= first[q] else [4 * q, 4 * q + 2]
        assert diagonal == expected
    # Both triangles run round as the quad does.
    assert (mesh.split().quality("area")["triangle"] > 0).all()
    assert set(map(tuple, triangles[:, :2].tolist())) <= {
        (4 * q + i, 4 * q + (i + 1) % 4) for q in range(n) for i in range(4)
    }


@pytest.mark.parametrize("offset", [0, 1e6])
@pytest.mark.parametrize("start", range(4))
def test_equal_diagonals_join_the_second_and_the_fourth_node(offset, start):
    """Also far from the origin, where rounding makes the lengths differ in the last digits."""
    square = np.array([[0.1, 0.1, 0], [0.4, 0.1, 0], [0.4, 0.4, 0], [0.1, 0.4, 0]]) + offset
    order = np.roll(np.arange(4), -start)
    triangles = nmgs.Mesh(square, {"quad": [order]}).split().cells["triangle"]
    a, b, c, d = order
    assert triangles.tolist() == [[a, b, d], [c, d, b]]


def test_quads_on_hexahedra_take_the_hexahedras_diagonals():
    mesh = renumbered(cube((2, 2, 2)).generate(), 1)
    faces = mesh.boundary()
    corners = {tuple(p): n for n, p in enumerate(mesh.points)}
    quads = np.array(
        [[corners[tuple(p)] for p in faces.points[row]] for row in faces.cells["quad"]]
    )
    top = np.flatnonzero((mesh.points[quads][:, :, 2] == 1).all(axis=1)).astype(np.int32)
    whole = nmgs.Mesh(
        mesh.points,
        {"hexahedron": mesh.cells["hexahedron"], "quad": quads},
        {
            "top": ("quad", top),
            "some": ("hexahedron", np.array([1, 3], dtype=np.int32)),
            "corner": ("node", np.array([0], dtype=np.int32)),
        },
    )
    tetra = whole.split()
    uses = face_uses(tetra.cells["tetra"])
    for triangle in np.sort(tetra.cells["triangle"], axis=1).tolist():
        assert uses[tuple(triangle)] == 1
    kind, indices = tetra.groups["top"]
    assert kind == "triangle" and len(indices) == 8
    assert (tetra.points[tetra.cells["triangle"][indices]][:, :, 2] == 1).all()
    assert tetra.groups["some"][1].tolist() == [*range(12, 24), *range(36, 48)]
    assert tetra.groups["corner"] == ("node", [0])


def test_cells_that_were_there_come_first():
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]]
    mesh = nmgs.Mesh(
        points,
        {"quad": [[0, 1, 2, 3]], "triangle": [[1, 4, 2]]},
        {"q": ("quad", [0]), "t": ("triangle", [0])},
    )
    result = mesh.split()
    assert result.cells["triangle"].tolist() == [[1, 4, 2], [0, 1, 3], [2, 3, 1]]
    assert result.groups["q"][1].tolist() == [1, 2]
    assert result.groups["t"][1].tolist() == [0]


def test_refused_cells_are_named():
    points = np.zeros((20, 3))
    for name, count in (("wedge", 6), ("pyramid", 5), ("hexahedron20", 20), ("quad8", 8)):
        with pytest.raises(ValueError, match=name):
            nmgs.Mesh(points, {name: [range(count)]}).split()


def test_nodes_changed_behind_the_meshs_back_are_an_error():
    mesh = bent_patches().generate()
    mesh.cells["quad"][3, 1] = 10**6
    with pytest.raises(ValueError, match="quad 3 has node 1000000"):
        mesh.split()


def test_cancel():
    with pytest.raises(nmgs.Cancelled):
        cube((20, 20, 20)).generate().split(progress=lambda fraction: False)
