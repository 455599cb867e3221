# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles to quads and tetrahedra to hexahedra."""

import collections
import itertools

import numpy as np
import pytest
from blocks import bent_blocks, bent_patches, cube
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs import convert

HEXA_FACES = np.array(
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
)


def edge_uses(mesh: nmgs.Mesh) -> collections.Counter:
    uses = collections.Counter()
    for cells in mesh.cells.values():
        for i in range(cells.shape[1]):
            ends = np.stack([cells[:, i], cells[:, (i + 1) % cells.shape[1]]], axis=1)
            uses.update(map(tuple, np.sort(ends, axis=1).tolist()))
    return uses


def assert_all_quad(mesh: nmgs.Mesh, like: nmgs.Mesh) -> None:
    assert set(mesh.cells) == {"quad"}
    assert set(edge_uses(mesh).values()) <= {1, 2}
    before = sum(v.sum() for v in like.quality("area").values())
    assert mesh.quality("area")["quad"].sum() == pytest.approx(before, rel=1e-2)
    # Euler's characteristic does not change.
    assert characteristic(mesh) == characteristic(like)


def characteristic(mesh: nmgs.Mesh) -> int:
    faces = sum(len(c) for c in mesh.cells.values())
    return len(mesh.points) - len(edge_uses(mesh)) + faces


def test_each_into_three():
    triangles = bent_patches().generate().split()
    quads = triangles.to_quads("split")
    assert len(quads.cells["quad"]) == 3 * len(triangles.cells["triangle"])
    assert_all_quad(quads, triangles)
    assert (quads.quality()["quad"] > 0).all()


def test_matching_finds_the_quads_that_were_split():
    mesh = cube((3, 4, 5)).generate().boundary()
    quads = mesh.split().to_quads("match")
    assert len(quads.cells["quad"]) == len(mesh.cells["quad"])
    # Squares: the largest sum of scaled Jacobians is 1 a quad, and no other pairing has it.
    assert quads.quality()["quad"] == pytest.approx(1)
    assert len(quads.points) == len(mesh.points)
    assert_all_quad(quads, mesh)


def delaunay(count: int, seed: int) -> nmgs.Mesh:
    vtk = pytest.importorskip("vtk", reason="needs python3-vtk9")
    rng = np.random.default_rng(seed)
    xy = np.vstack([rng.uniform(0, 1, (count, 2)), list(itertools.product((0, 1), repeat=2))])
    points = vtk.vtkPoints()
    for x, y in xy:
        points.InsertNextPoint(x, y, 0)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    filter = vtk.vtkDelaunay2D()
    filter.SetInputData(data)
    filter.Update()
    cells = filter.GetOutput()
    triangles = [
        [cells.GetCell(i).GetPointId(j) for j in range(3)] for i in range(cells.GetNumberOfCells())
    ]
    at = np.hstack([xy, np.zeros((len(xy), 1))])
    return nmgs.Mesh(at, {"triangle": triangles})


def best_pairing(mesh: nmgs.Mesh) -> tuple:
    """(pairs, sum of scaled Jacobians) of the best set of pairs, by trying all of them."""
    cells = mesh.cells["triangle"].tolist()
    pairs = []
    for a, b in itertools.combinations(range(len(cells)), 2):
        common = set(cells[a]) & set(cells[b])
        if len(common) == 2:
            i = next(k for k in range(3) if cells[a][k] not in common)
            (opposite,) = set(cells[b]) - common
            quad = [cells[a][i], cells[a][(i + 1) % 3], opposite, cells[a][(i + 2) % 3]]
            quality = nmgs.Mesh(mesh.points, {"quad": [quad]}).quality()["quad"][0]
            if quality > 1e-3:
                pairs.append((a, b, quality))

    def best(at: int, used: frozenset) -> tuple:
        if at == len(pairs):
            return (0, 0.0)
        a, b, quality = pairs[at]
        result = best(at + 1, used)
        if a not in used and b not in used:
            count, total = best(at + 1, used | {a, b})
            result = max(result, (count + 1, total + quality))
        return result

    return best(0, frozenset())


@pytest.mark.parametrize("seed", range(6))
def test_pairing_is_the_best_of_all(seed):
    mesh = delaunay(5, seed)
    count, total = best_pairing(mesh)
    result = convert._paired(mesh, None)
    quads = result.cells["quad"]
    assert len(quads) == count
    assert result.quality()["quad"].sum() == pytest.approx(total, abs=1e-4 * len(mesh.points))


@settings(max_examples=15, deadline=None)
@given(st.integers(3, 60), st.integers(0, 10**6))
def test_any_triangulation_becomes_all_quad(count, seed):
    mesh = delaunay(count, seed)
    for method in ("match", "split"):
        assert_all_quad(mesh.to_quads(method), mesh)


def test_pairs_do_not_cross_groups_or_creases():
    mesh = cube((1, 1, 1)).generate().boundary().split()
    quads = mesh.to_quads("match")
    assert len(quads.cells["quad"]) == 6 and quads.quality("warpage")["quad"].max() < 1e-12
    flat = nmgs.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], {"quad": [[0, 1, 2, 3]]}).split()
    flat.groups["one"] = ("triangle", np.array([0], dtype=np.int32))
    halved = flat.to_quads("match")
    assert len(halved.cells["quad"]) == 6
    assert halved.quality("area")["quad"][halved.groups["one"][1]].sum() == pytest.approx(0.5)


def test_leftover_keeps_groups_whole():
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]]
    mesh = nmgs.Mesh(
        points,
        {"triangle": [[0, 1, 2], [0, 2, 3], [1, 4, 2]]},
        {"all": ("triangle", [0, 1, 2]), "rim": ("node", [0, 1, 4])},
    )
    quads = mesh.to_quads("match")
    assert len(quads.cells["quad"]) == 4 + 3
    assert quads.groups["all"][0] == "quad" and len(quads.groups["all"][1]) == 7
    rim = quads.points[quads.groups["rim"][1]]
    assert sorted(rim[:, 0]) == [0, 0.5, 1, 1.5, 2] and (rim[:, 1] == 0).all()


@pytest.mark.parametrize("make", [cube, bent_blocks])
def test_tetrahedra_into_four_hexahedra(make):
    tetra = make().generate().split()
    mesh = tetra.to_hexes()
    assert set(mesh.cells) == {"hexahedron"}
    assert len(mesh.cells["hexahedron"]) == 4 * len(tetra.cells["tetra"])
    assert (mesh.quality()["hexahedron"] > 0).all()
    assert (mesh.to_order(2).quality("min_jacobian")["hexahedron20"] > 0).all()
    assert len(mesh.boundary().cells["quad"]) == 3 * len(tetra.boundary().cells["triangle"])
    faces = np.sort(mesh.cells["hexahedron"][:, HEXA_FACES].reshape(-1, 4), axis=1)
    assert set(np.unique(faces, axis=0, return_counts=True)[1]) == {1, 2}
    # The mid-sides of curved blocks bulge; a cube's do not.
    before = tetra.quality("volume")["tetra"].sum()
    exact = 1e-12 if make is cube else 2e-2
    assert mesh.quality("volume")["hexahedron"].sum() == pytest.approx(before, rel=exact)


def test_triangles_on_tetrahedra_share_their_nodes():
    tetra = cube((1, 1, 1)).generate().split()
    number = {tuple(p): n for n, p in enumerate(tetra.points)}
    surface = tetra.boundary()
    triangles = [[number[tuple(p)] for p in surface.points[t]] for t in surface.cells["triangle"]]
    top = np.flatnonzero(tetra.points[:, 2] == 1)
    mesh = nmgs.Mesh(
        tetra.points,
        {"tetra": tetra.cells["tetra"], "triangle": triangles},
        {"skin": ("triangle", np.arange(12)), "top": ("node", top), "some": ("tetra", [1])},
    )
    hexes = mesh.to_hexes()
    outer = hexes.boundary()
    assert len(outer.groups["skin"][1]) == 36 == len(outer.cells["quad"])
    assert hexes.groups["some"][1].tolist() == [4, 5, 6, 7]
    expected = np.flatnonzero(hexes.points[:, 2] == 1)
    assert sorted(hexes.groups["top"][1]) == expected.tolist()


def test_refused():
    mesh = cube((1, 1, 1)).generate()
    with pytest.raises(ValueError, match="hexahedron"):
        mesh.to_quads()
    with pytest.raises(ValueError, match="hexahedron"):
        mesh.to_hexes()
    with pytest.raises(ValueError, match="method.*'best'"):
        bent_patches().generate().split().to_quads("best")
    with pytest.raises(ValueError, match="triangle6"):
        bent_patches().generate().split().to_order(2).to_quads()
