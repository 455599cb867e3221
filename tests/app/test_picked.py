# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constraints on picked faces find their nodes by the mesh's groups; FEM's own search is the
oracle where it finds them, and area where it does not."""

import Part
import pytest
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem import analysis as fem_analysis
from freecad.NMGSWorkbench.fem.fem_mesh import fem_mesh
from freecad.NMGSWorkbench.fem.picked import MeshByGroups


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


def test_pressures_find_the_same_sides_as_by_search(quarter):
    for mesh in (
        nmgs.fit(quarter, size=0.5).generate(order=2),
        nmgs.fit(quarter, size=1.0).generate().split(),
        nmgs.fit(quarter, size=1.0).generate().split().to_order(2),
    ):
        fem = fem_mesh(mesh)
        grouped = MeshByGroups(fem, [(quarter, names_of(quarter))])
        for face in quarter.Shape.Faces:
            found = grouped.getccxVolumesByFace(face)
            if mesh.cells.get("hexahedron20") is not None:
                kind, cells = mesh.groups[f"Face{1 + _at(quarter, face)}"]
                assert len(found) == len(cells)
            searched = fem.getccxVolumesByFace(face)
            # The search finds some twice, and on curved faces misses straight sides.
            assert set(searched) <= set(found) and len(set(found)) == len(found)
        assert grouped.found


def _at(part, face):
    return [n for n, other in enumerate(part.Shape.Faces) if other.isSame(face)][0]


def test_fems_own_writer_asks_the_groups(document, quarter, tmp_path):
    """What FEM's own panel runs, on a mesh whose nodes a search does not find."""
    from femtools import ccxtools

    mesh = nmgs.fit(quarter, size=0.5).generate(order=2)
    mesh.points[:, :2] *= 1.0005
    obj = nmgs.to_fem(mesh, document)
    curved = [
        f"Face{n}"
        for n, f in enumerate(quarter.Shape.Faces, 1)
        if isinstance(f.Surface, Part.Cylinder)
    ]
    flat = next(n for n, f in enumerate(quarter.Shape.Faces, 1) if f"Face{n}" not in curved)
    analysis = fem_analysis.static_analysis(quarter, obj, [f"Face{flat}"], curved[:1], pressure=2.0)
    tools = ccxtools.FemToolsCcx(analysis, test_mode=True)
    tools.update_objects()
    tools.setup_working_dir(str(tmp_path))
    assert not tools.check_prerequisites()
    tools.write_inp_file()
    (path,) = tmp_path.glob("*.inp")
    lines = path.read_text().splitlines()
    start = next(n for n, line in enumerate(lines) if line.startswith("*DLOAD"))
    loads = []
    for line in lines[start + 1 :]:
        if line.startswith("*") and not line.startswith("**"):
            break
        if line.strip() and not line.startswith("**"):
            loads.append(line.split(","))
    kind, cells = mesh.groups[curved[0]]
    assert len(loads) == len(cells)
    assert all(side.strip().startswith("P") and float(value) == 2 for _, side, value in loads)


def test_a_part_in_a_container_is_found_where_it_is_drawn(document):
    box = document.addObject("Part::Box", "Box")
    container = document.addObject("App::Part", "Container")
    container.addObject(box)
    container.Placement.Base = Vector(100, 0, 0)
    document.recompute()
    placed = box.Shape.copy()
    placed.Placement = container.Placement
    fem = fem_mesh(nmgs.fit(placed, size=5).generate())
    grouped = MeshByGroups(fem, [(box, ("Face1",))])
    # As FreeCAD 1.0 hands it over.
    assert grouped.getNodesByFace(placed.Face1) and grouped.found == ["Face1"]
