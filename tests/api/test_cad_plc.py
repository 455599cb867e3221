# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen on real solids; volumes against OpenCASCADE's, topology against Euler's formula."""

import FreeCAD  # noqa: F401
import numpy as np
import Part
import pytest
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.cad_plc import plc_of_shape

BALL = Part.makeSphere(1, Vector(2, 2, 2))

#: shape, Euler characteristic of its boundary
SHAPES = {
    "box": (lambda: Part.makeBox(1, 2, 3), 2),
    "cylinder": (lambda: Part.makeCylinder(1, 2), 2),
    "cone with a pole": (lambda: Part.makeCone(1, 0, 2), 2),
    "ball": (lambda: Part.makeSphere(1), 2),
    "torus": (lambda: Part.makeTorus(3, 1), 0),
    "plate with a hole": (
        lambda: Part.makeBox(4, 4, 1).cut(Part.makeCylinder(1, 9, Vector(2, 2, -4))),
        0,
    ),
    "cavity": (lambda: Part.makeBox(4, 4, 4).cut(BALL), 4),
    "moved": (lambda: Part.makeBox(1, 2, 3, Vector(50, 1, 1), Vector(1, 1, 1)), 2),
}


@pytest.mark.parametrize("name", SHAPES)
def test_facets_are_closed_and_tetrahedra_fill_them(name):
    make, euler = SHAPES[name]
    shape = make()
    plc = plc_of_shape(shape, 0.002 * shape.BoundBox.DiagonalLength)
    triangles = np.array([plc.facet(f)[0] for f in range(len(plc))])
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    # Each edge is run once in each direction: closed, and all normals look the same way.
    assert len(np.unique(edges, axis=0)) == len(edges)
    assert {tuple(e) for e in edges} == {(b, a) for a, b in edges}
    assert len(plc.points) - len(edges) // 2 + len(triangles) == euler
    a, b, c = (plc.points[triangles[:, n]] for n in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    assert volume == pytest.approx(shape.Volume, rel=0.02)
    # Without -M TetGen makes facets that meet at more than 179.9 degrees one plane.
    mesh = nmgs.tetrahedralize(plc, "pM")
    assert (mesh.quality("volume")["tetra"] > 0).all()
    assert mesh.quality("volume")["tetra"].sum() == pytest.approx(volume, rel=1e-9)


def test_faces_and_solids_are_groups_and_inner_faces_stay():
    both = Part.makeBox(4, 4, 4).generalFuse([BALL])[0]
    mesh = nmgs.tetrahedralize(both, "pq")
    volumes = mesh.quality("volume")["tetra"]
    for number, solid in enumerate(both.Solids, 1):
        kind, cells = mesh.groups[f"Solid{number}"]
        assert kind == "tetra"
        assert volumes[cells].sum() == pytest.approx(solid.Volume, rel=0.02)
    assert len(mesh.groups["Solid1"][1]) + len(mesh.groups["Solid2"][1]) == len(volumes)
    for number, face in enumerate(both.Faces, 1):
        kind, cells = mesh.groups[f"Face{number}"]
        assert kind == "triangle"
        assert mesh.quality("area")["triangle"][cells].sum() == pytest.approx(face.Area, rel=0.03)


def test_a_face_of_two_solids_that_only_touch_has_both_names():
    """A compound of two boxes: the faces between them are two, one on the other."""
    shape = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, Vector(1, 0, 0))])
    mesh = nmgs.tetrahedralize(shape, "pq")
    between = []
    for number, face in enumerate(shape.Faces, 1):
        cells = mesh.groups[f"Face{number}"][1]
        assert mesh.quality("area")["triangle"][cells].sum() == pytest.approx(face.Area)
        if abs(face.CenterOfMass.x - 1) < 1e-9:
            between.append(cells.tolist())
    assert len(between) == 2 and between[0] == between[1]
    assert mesh.quality("volume")["tetra"].sum() == pytest.approx(2)


def test_a_void_between_solids_stays_empty():
    """Two halves of a box with a cavity: neither half has a cavity of its own."""
    whole = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 2, Vector(1, 1, 1)))
    halves = [whole.common(Part.makeBox(4, 4, 2, Vector(0, 0, z))).Solids[0] for z in (0, 2)]
    for shape in (Part.makeCompound(halves), halves[0].generalFuse([halves[1]])[0]):
        mesh = nmgs.tetrahedralize(shape, "pq")
        assert mesh.quality("volume")["tetra"].sum() == pytest.approx(64 - 8)
        assert not [name for name in mesh.groups if name.startswith("Region")]
        assert len(mesh.groups["Solid1"][1]) + len(mesh.groups["Solid2"][1]) == len(
            mesh.cells["tetra"]
        )


def test_finer_deviation_comes_nearer():
    shape = Part.makeCylinder(1, 2)
    errors = []
    for deviation in (0.01, 0.0025, 0.0006):
        mesh = nmgs.tetrahedralize(shape, "p", deviation=deviation)
        errors.append(1 - mesh.quality("volume")["tetra"].sum() / shape.Volume)
    assert 0 < errors[2] < errors[1] < errors[0]


def test_unusable_shapes():
    with pytest.raises(nmgs.TetGenError, match="open edge"):
        nmgs.tetrahedralize(Part.makePlane(1, 1), "p")
    with pytest.raises(ValueError, match="deviation"):
        plc_of_shape(Part.makeBox(1, 1, 1), -1)
