# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constraints on picked faces find their nodes by the mesh's groups; FEM's own search is the
oracle where it finds them, and area where it does not."""

import FreeCAD
import Part
import pytest
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem import analysis as fem_analysis
from freecad.NMGSWorkbench.fem.fem_mesh import fem_mesh
from freecad.NMGSWorkbench.fem.picked import MeshByGroups, sets_by_groups


@pytest.fixture
def quarter(document):
    """A quarter of a tube: flat and curved faces."""
    corners = [Vector(2, 0, 0), Vector(3, 0, 0), Vector(3, 0, 3), Vector(2, 0, 3), Vector(2, 0, 0)]
    face = Part.Face(Part.makePolygon(corners))
    part = document.addObject("Part::Feature", "Quarter")
    part.Shape = face.revolve(Vector(), Vector(0, 0, 1), 90)
    return part


def names_of(part):
    return (
        [f"Face{n}" for n in range(1, len(part.Shape.Faces) + 1)]
        + [f"Edge{n}" for n in range(1, len(part.Shape.Edges) + 1)]
        + [f"Vertex{n}" for n in range(1, len(part.Shape.Vertexes) + 1)]
    )


@pytest.mark.parametrize("order", (1, 2))
def test_the_same_nodes_as_by_search(quarter, order):
    fem = fem_mesh(nmgs.fit(quarter, size=0.5).generate(order=order))
    grouped = MeshByGroups(fem, [(quarter, names_of(quarter))])
    for kind, method in (("Face", "getNodesByFace"), ("Edge", "getNodesByEdge")):
        for number, shape in enumerate(getattr(quarter.Shape, kind + "s"), 1):
            found = getattr(grouped, method)(shape)
            assert f"{kind}{number}" in grouped.found
            assert found == sorted(getattr(fem, method)(shape))
    for face in quarter.Shape.Faces:
        assert list(grouped.getFacesByFace(face)) == sorted(fem.getFacesByFace(face))


def test_a_group_of_another_part_is_not_believed(document, quarter):
    fem = fem_mesh(nmgs.fit(quarter, size=0.5).generate())
    other = document.addObject("Part::Box", "Other")
    other.Placement.Base = Vector(50, 0, 0)
    document.recompute()
    grouped = MeshByGroups(fem, [(other, ("Face1",)), (quarter, ("Face1",))])
    assert list(grouped.getNodesByFace(other.Shape.Face1)) == [] and grouped.found == []
    assert grouped.getNodesByFace(quarter.Shape.Face1) and grouped.found == ["Face1"]


def test_half_a_face_is_not_believed(quarter):
    mesh = nmgs.fit(quarter, size=0.5).generate()
    kind, cells = mesh.groups["Face1"]
    mesh.groups["Face1"] = (kind, cells[: len(cells) // 2])
    fem = fem_mesh(mesh)
    grouped = MeshByGroups(fem, [(quarter, ("Face1",))])
    face = quarter.Shape.Face1
    assert sorted(grouped.getNodesByFace(face)) == sorted(fem.getNodesByFace(face))
    assert grouped.found == []


def test_loads_find_nodes_that_are_off_the_face(document, quarter, tmp_path):
    """Nodes moved off a curved face by what a search does not forgive; the load is all there."""
    mesh = nmgs.fit(quarter, size=0.5).generate(order=2)
    mesh.points[:, :2] *= 1.0005
    outer, inner = [
        next(
            f"Face{n}"
            for n, f in enumerate(quarter.Shape.Faces, 1)
            if isinstance(f.Surface, Part.Cylinder) and f.Surface.Radius == pytest.approx(radius)
        )
        for radius in (3, 2)
    ]
    obj = nmgs.to_fem(mesh, document)
    assert not obj.FemMesh.getNodesByFace(quarter.Shape.getElement(outer))
    flat = next(
        f"Face{n}"
        for n, f in enumerate(quarter.Shape.Faces, 1)
        if isinstance(f.Surface, Part.Plane) and abs(f.CenterOfMass.z) < 1e-9
    )
    upright = next(
        f"Edge{n}"
        for n, e in enumerate(quarter.Shape.Edges, 1)
        if isinstance(e.Curve, Part.Line) and abs(e.tangentAt(e.FirstParameter).z) > 0.9
    )
    analysis = fem_analysis.static_analysis(
        quarter, obj, [flat], [outer], 1000.0, direction=(quarter, [upright])
    )
    fem_analysis.solve(analysis, str(tmp_path))
    (path,) = tmp_path.glob("*.inp")
    loads, reading = [], False
    for line in path.read_text().splitlines():
        if line.startswith("*"):
            reading = line.startswith("*CLOAD") or (reading and line.startswith("**"))
        elif reading and line.strip():
            node, direction, value = line.split(",")
            loads.append((int(node), int(direction), float(value)))
    kind, cells = mesh.groups[outer]
    assert {n for n, _, _ in loads} <= set((mesh.cells[kind][cells] + 1).ravel().tolist())
    assert abs(sum(v for _, d, v in loads if d == 3)) == pytest.approx(1000, rel=0.01)
    assert inner != outer


def test_fem_has_its_own_getter_back():
    from femmesh import meshsetsgetter

    plain = meshsetsgetter.MeshSetsGetter
    with pytest.raises(KeyError), sets_by_groups():
        assert meshsetsgetter.MeshSetsGetter is not plain
        raise KeyError
    assert meshsetsgetter.MeshSetsGetter is plain
    assert FreeCAD.Version()
