# SPDX-License-Identifier: LGPL-2.1-or-later
"""Metrics against VTK's mesh quality filter (which calls Verdict) on random valid cells."""

import itertools

import numpy as np
import pytest

from freecad.NMGSWorkbench import nmgs

vtk = pytest.importorskip("vtk", reason="needs python3-vtk9")
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402

REFERENCE = {
    "triangle": (vtk.VTK_TRIANGLE, [[0, 0, 0], [1, 0, 0], [0.5, 0.8, 0]]),
    "quad": (vtk.VTK_QUAD, [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]),
    "tetra": (vtk.VTK_TETRA, [[0, 0, 0], [1, 0, 0], [0.4, 0.9, 0], [0.4, 0.3, 0.8]]),
    "hexahedron": (
        vtk.VTK_HEXAHEDRON,
        [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))],
    ),
}
VTK_NAMES = {"triangle": "Triangle", "quad": "Quad", "tetra": "Tet", "hexahedron": "Hex"}
#: Cell type, metric, VTK's name of it. VTK 9.1 has the rest nowhere, or wrong: its TetMinAngle and
#: HexEdgeRatio leave out some edges, so these two are compared with plain NumPy below.
PAIRS = [
    ("triangle", "area", "Area"),
    ("triangle", "scaled_jacobian", "ScaledJacobian"),
    ("triangle", "shape", "Shape"),
    ("triangle", "aspect_ratio", "AspectRatio"),
    ("triangle", "edge_ratio", "EdgeRatio"),
    ("triangle", "min_angle", "MinAngle"),
    ("triangle", "max_angle", "MaxAngle"),
    ("quad", "area", "Area"),
    ("quad", "scaled_jacobian", "ScaledJacobian"),
    ("quad", "shape", "Shape"),
    ("quad", "aspect_ratio", "AspectRatio"),
    ("quad", "edge_ratio", "EdgeRatio"),
    ("quad", "skew", "Skew"),
    ("quad", "warpage", "Warpage"),
    ("quad", "min_angle", "MinAngle"),
    ("quad", "max_angle", "MaxAngle"),
    ("tetra", "volume", "Volume"),
    ("tetra", "scaled_jacobian", "ScaledJacobian"),
    ("tetra", "shape", "Shape"),
    ("tetra", "aspect_ratio", "AspectRatio"),
    ("tetra", "edge_ratio", "EdgeRatio"),
    ("hexahedron", "scaled_jacobian", "ScaledJacobian"),
    ("hexahedron", "shape", "Shape"),
    ("hexahedron", "aspect_ratio", "MaxEdgeRatios"),
    ("hexahedron", "skew", "Skew"),
]


def random_cells(name: str, count: int = 300, plane: bool = False) -> nmgs.Mesh:
    rng = np.random.default_rng(7)
    corners = np.array(REFERENCE[name][1], dtype=float)
    stretch = rng.uniform(0.3, 3.0, (count, 1, 3))
    points = corners * stretch + rng.uniform(-0.18, 0.18, (count, len(corners), 3))
    if plane:
        points[..., 2] = 0
    turn = np.linalg.qr(rng.normal(size=(count, 3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))[:, None, None]
    points = points @ turn
    mesh = nmgs.Mesh(
        points.reshape(-1, 3), {name: np.arange(count * len(corners)).reshape(count, -1)}
    )
    valid = mesh.quality("scaled_jacobian")[name] > 0
    assert valid.sum() > count // 2
    return nmgs.Mesh(mesh.points, {name: mesh.cells[name][valid]})


def vtk_quality(mesh: nmgs.Mesh, name: str, measure: str) -> np.ndarray:
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(mesh.points, deep=True))
    grid.SetPoints(points)
    for row in mesh.cells[name]:
        grid.InsertNextCell(REFERENCE[name][0], len(row), [int(n) for n in row])
    quality = vtk.vtkMeshQuality()
    quality.SetInputData(grid)
    setter = f"Set{VTK_NAMES[name]}QualityMeasureTo{measure}"
    if not hasattr(quality, setter):
        setter = setter.rstrip("s")  # VTK 9.2 took the plural off some names
    getattr(quality, setter)()
    quality.Update()
    return vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))


@pytest.mark.parametrize("name, metric, measure", PAIRS)
def test_agrees_with_vtk(name, metric, measure):
    # Of quads that are not plane VTK 9.6 has another aspect ratio than VTK 9.1 and 9.3.
    mesh = random_cells(name, plane=(name, metric) == ("quad", "aspect_ratio"))
    ours = mesh.quality(metric)[name]
    theirs = vtk_quality(mesh, name, measure)
    if measure == "Warpage":
        theirs = 1 - theirs  # VTK 9.1 leaves out the "1 -" of Verdict's definition
    assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-9)


def dihedral_angles(p: np.ndarray) -> list:
    angles = []
    for a, b in itertools.combinations(range(4), 2):
        c, d = (i for i in range(4) if i not in (a, b))
        e = (p[b] - p[a]) / np.linalg.norm(p[b] - p[a])
        u, v = ((q - p[a]) - e * ((q - p[a]) @ e) for q in (p[c], p[d]))
        angles.append(np.degrees(np.arccos(u @ v / np.linalg.norm(u) / np.linalg.norm(v))))
    return angles


def test_dihedral_angles_of_tetrahedra():
    mesh = random_cells("tetra")
    expected = [dihedral_angles(p) for p in mesh.points[mesh.cells["tetra"]]]
    assert mesh.quality("min_angle")["tetra"] == pytest.approx(np.min(expected, axis=1), abs=1e-6)
    assert mesh.quality("max_angle")["tetra"] == pytest.approx(np.max(expected, axis=1), abs=1e-6)


def test_edge_ratio_of_hexahedra():
    mesh = random_cells("hexahedron")
    p = mesh.points[mesh.cells["hexahedron"]]
    pairs = [(i, (i + 1) % 4) for i in range(4)]
    pairs += [(4 + a, 4 + b) for a, b in pairs] + [(i, i + 4) for i in range(4)]
    lengths = np.stack([np.linalg.norm(p[:, a] - p[:, b], axis=1) for a, b in pairs])
    expected = lengths.max(axis=0) / lengths.min(axis=0)
    assert mesh.quality("edge_ratio")["hexahedron"] == pytest.approx(expected, rel=1e-12)


def test_volume_of_hexahedra_is_the_trilinear_maps():
    """The Jacobian is quadratic in each direction, so 2^3 Gauss points integrate it exactly."""
    mesh = random_cells("hexahedron")
    p = mesh.points[mesh.cells["hexahedron"]]
    signs = 2 * np.array(REFERENCE["hexahedron"][1], dtype=float) - 1
    volume = np.zeros(len(p))
    for g in itertools.product((-(3**-0.5), 3**-0.5), repeat=3):
        factors = 1 + signs * g
        gradient = np.stack(
            [signs[:, d] * np.delete(factors, d, axis=1).prod(axis=1) / 8 for d in range(3)]
        )
        volume += np.linalg.det(np.einsum("dn,cnx->cdx", gradient, p))
    assert mesh.quality("volume")["hexahedron"] == pytest.approx(volume, rel=1e-12)


def test_radius_edge_ratio_of_regular_cells():
    triangle = nmgs.Mesh([[0, 0, 0], [2, 0, 0], [1, 3**0.5, 0]], {"triangle": [[0, 1, 2]]})
    assert triangle.quality("radius_edge_ratio")["triangle"] == pytest.approx(3**-0.5)
    tetra = nmgs.Mesh([[1, 1, 1], [-1, 1, -1], [1, -1, -1], [-1, -1, 1]], {"tetra": [[0, 1, 2, 3]]})
    # Circumradius sqrt(3), edges sqrt(8).
    assert tetra.quality("radius_edge_ratio")["tetra"] == pytest.approx((3 / 8) ** 0.5)


def test_ideal_wedge_and_pyramid():
    h = 3**0.5 / 2
    base = [[0, 0, 0], [1, 0, 0], [0.5, h, 0]]
    points = base + [[x, y, 2] for x, y, _ in base]
    wedge = nmgs.Mesh(points, {"wedge": [[0, 1, 2, 3, 4, 5]]})
    assert wedge.quality()["wedge"] == pytest.approx(1)
    assert wedge.quality("volume")["wedge"] == pytest.approx(h)
    assert wedge.quality("min_angle")["wedge"] == pytest.approx(60)
    assert wedge.quality("max_angle")["wedge"] == pytest.approx(90)
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0.5**0.5]]
    pyramid = nmgs.Mesh(points, {"pyramid": [[0, 1, 2, 3, 4]]})
    assert pyramid.quality()["pyramid"] == pytest.approx(1)
    assert pyramid.quality("volume")["pyramid"] == pytest.approx(0.5**0.5 / 3)
    # Faces of a regular octahedron meet at arccos(-1/3), half of it at the base.
    whole = np.degrees(np.arccos(-1 / 3))
    assert pyramid.quality("min_angle")["pyramid"] == pytest.approx(whole / 2)
    assert pyramid.quality("max_angle")["pyramid"] == pytest.approx(whole)


def test_flat_and_inverted_cells_are_seen():
    flat = nmgs.Mesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], {"triangle": [[0, 1, 2]]})
    assert flat.quality()["triangle"] == [0]
    assert flat.quality("aspect_ratio")["triangle"] == [np.inf]
    hexahedron = np.array(REFERENCE["hexahedron"][1], dtype=float) * [1, 1, -1]
    inverted = nmgs.Mesh(hexahedron, {"hexahedron": [range(8)]})
    assert inverted.quality()["hexahedron"] == [-1]
    assert inverted.quality("shape")["hexahedron"] == [0]
    assert inverted.quality("volume")["hexahedron"] == [-1]


def test_only_types_that_have_the_metric():
    points = np.array(REFERENCE["hexahedron"][1], dtype=float)
    mesh = nmgs.Mesh(points, {"hexahedron": [range(8)], "quad": [[0, 1, 2, 3]], "line": [[0, 6]]})
    assert set(mesh.quality("volume")) == {"hexahedron"}
    assert set(mesh.quality("area")) == {"quad"}
    assert mesh.quality("length")["line"] == pytest.approx([3**0.5])
    assert set(mesh.quality("skew")) == {"hexahedron", "quad"}


def test_unknown_metric_is_named():
    with pytest.raises(ValueError, match="beauty.*scaled_jacobian"):
        nmgs.Mesh(np.zeros((3, 3)), {"triangle": [[0, 1, 2]]}).quality("beauty")
