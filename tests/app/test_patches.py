# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches in a document: fitted, given, kept by a file, followed by a recompute."""

import FreeCAD
import numpy as np
import pytest

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs import grading
from freecad.NMGSWorkbench.objects import make, patches

#: A flat patch of 2 x 1, corners first.
SQUARE = [
    [0, 0, 0],
    [2, 0, 0],
    [2, 1, 0],
    [0, 1, 0],
    [1, 0, 0],
    [2, 0.5, 0],
    [1, 1, 0],
    [0, 0.5, 0],
]


def nodes_of(obj):
    return np.array([tuple(node) for node in obj.Nodes])


def reopened(document, folder):
    path = str(folder / "kept.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    return FreeCAD.openDocument(path)


def test_fit_to_a_face(document, box):
    obj = patches.make(document)
    obj.Source = [(box, ("Face1",))]
    obj.Size = 5
    document.recompute()
    assert obj.isValid() and "Touched" not in obj.State
    assert obj.ElementCount == 1
    # Face1 of a box is its side x = 0, of 20 x 30.
    assert sorted(obj.Divisions) == [4, 6]
    assert np.allclose(np.ptp(nodes_of(obj), axis=0), [0, 20, 30], atol=1e-12)
    # Its four straight edges.
    assert len(obj.Shape.Edges) == 4
    assert obj.Shape.Length == pytest.approx(100)
    assert obj.Report == ["Box.Face1: mapped, at most 0 off the CAD"]


def test_faces_of_two_objects(document, box):
    other = document.addObject("Part::Box", "Other")
    other.Placement.Base = FreeCAD.Vector(100, 0, 0)
    document.recompute()
    obj = patches.make(document)
    obj.Source = [(box, ("Face1",)), (other, ("Face2",))]
    document.recompute()
    nodes = nodes_of(obj)
    assert obj.ElementCount == 2
    # Face2 of a box of 10 is its side x = 10.
    assert np.allclose(nodes[:8, 0], 0) and np.allclose(nodes[8:, 0], 110)
    assert [line.split(":")[0] for line in obj.Report] == ["Box.Face1", "Other.Face2"]


def test_a_face_of_a_part_in_a_moved_container(document, box):
    container = document.addObject("App::Part", "Container")
    container.addObject(box)
    container.Placement.Base = FreeCAD.Vector(0, 0, 1000)
    document.recompute()
    obj = patches.make(document)
    obj.Source = [(box, ("Face1",))]
    document.recompute()
    assert nodes_of(obj)[:, 2].min() == pytest.approx(1000)


def test_recompute_follows_the_part(document, box):
    obj = patches.make(document)
    obj.Source = [(box, ("Face1",))]
    document.recompute()
    box.Height = 60
    document.recompute()
    assert np.ptp(nodes_of(obj)[:, 2]) == pytest.approx(60)


def drilled_plate(document):
    plate = document.addObject("Part::Box", "Plate")
    plate.Length, plate.Width, plate.Height = 40, 30, 5
    drill = document.addObject("Part::Cylinder", "Drill")
    drill.Radius, drill.Height = 4, 20
    drill.Placement.Base = FreeCAD.Vector(12, 12, -5)
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = plate, drill
    document.recompute()
    return plate, drill, cut


def test_the_layout_stays_when_a_dimension_changes(document):
    plate, drill, cut = drilled_plate(document)
    faces = [f"Face{n + 1}" for n in range(len(cut.Shape.Faces))]
    obj = patches.make(document)
    obj.Source = [(cut, tuple(faces))]
    obj.Size = 4
    obj.KeepLayout = True
    document.recompute()
    before = obj.Proxy.model(obj)
    obj.Size = 0  # other divisions, the same layout
    drill.Radius = 6.5
    drill.Placement.Base.x = 20
    plate.Length = 55
    document.recompute()
    after = obj.Proxy.model(obj)
    assert obj.isValid()
    assert [e["first_block"] for e in after.report] == [e["first_block"] for e in before.report]
    assert np.array_equal(after.cad.corners, before.cad.corners)
    mesh = after.generate()
    assert set(mesh.cells) == {"quad"} and mesh.quality()["quad"].min() > 0.2
    p, q = mesh.points, mesh.cells["quad"]
    area = (
        0.5
        * np.linalg.norm(np.cross(p[q[:, 2]] - p[q[:, 0]], p[q[:, 3]] - p[q[:, 1]]), axis=1).sum()
    )
    assert area == pytest.approx(cut.Shape.Area, rel=0.01)


@pytest.mark.parametrize("keep", (False, True))
def test_a_change_that_is_undone_leaves_no_trace(document, keep):
    document.UndoMode = 1
    ring = document.addObject("Part::Torus", "Ring")
    document.recompute()
    obj = patches.make(document)
    obj.Source = [(ring, ("Face1",))]
    obj.KeepLayout = keep
    document.recompute()
    before = np.array([tuple(node) for node in obj.Nodes])
    for radius in (3, 4):
        document.openTransaction("Change")
        ring.Radius2 = radius
        document.recompute()
        document.commitTransaction()
    document.undo()
    document.undo()
    ring.touch()
    document.recompute()
    after = np.array([tuple(node) for node in obj.Nodes])
    assert np.allclose(before, after, rtol=0, atol=1e-9)


def test_another_topology_is_laid_out_anew(document):
    plate, drill, cut = drilled_plate(document)
    obj = patches.make(document)
    obj.KeepLayout = True
    top = max(range(len(cut.Shape.Faces)), key=lambda n: cut.Shape.Faces[n].CenterOfMass.z)
    obj.Source = [(cut, (f"Face{top + 1}",))]
    document.recompute()
    assert len(cut.Shape.Faces[top].Wires) == 2
    drill.Placement.Base.x = 0  # a notch in the side
    document.recompute()
    assert obj.isValid()
    fresh = nmgs.fit(cut.Shape, entities=[f"Face{top + 1}"])
    assert len(obj.Proxy.model(obj)) == len(fresh)


def test_counts_on_edges(document, box):
    obj = patches.make(document)
    obj.Source = [(box, ("Face1",))]
    edges = box.Shape.Faces[0].Edges
    number = next(n for n, e in enumerate(box.Shape.Edges, 1) if e.isSame(edges[0]))
    obj.EdgeCounts = [f"Box.Edge{number}: 7"]
    document.recompute()
    assert obj.isValid() and 7 in obj.Divisions
    nodes = obj.Proxy.model(obj).generate().groups[f"Edge{number}"][1]
    assert len(nodes) == 8
    obj.EdgeCounts = ["Edge: 7"]
    document.recompute()
    assert not obj.isValid()


def test_divisions_by_hand_stay(document, box):
    obj = patches.make(document)
    obj.Source = [(box, ("Face1",))]
    document.recompute()
    obj.AutoDivisions = False
    obj.Divisions = [7, 3]
    box.Height = 60
    document.recompute()
    assert obj.Divisions == [7, 3]
    assert obj.Proxy.model(obj).divisions.tolist() == [[7, 3]]


def test_given_patches_survive_a_file(document, tmp_path):
    model = nmgs.BlockModel(np.array([SQUARE], float), [4, 3], "my square")
    model.grading[0][0] = grading.geometric(ratio=1.5)
    make.blocks_from_model(document, model)
    document.recompute()
    again = reopened(document, tmp_path).getObject("Patches")
    found = again.Proxy.model(again)
    assert np.array_equal(found.nodes, model.nodes)
    assert np.array_equal(found.divisions, model.divisions)
    assert found.reference == "my square"
    assert found.grading == model.grading
    assert "Touched" not in again.State


def test_fitted_patches_survive_a_file(document, box, tmp_path):
    obj = patches.make(document)
    obj.Source = [(box, ("Face1", "Face3"))]
    document.recompute()
    before = nodes_of(obj), list(obj.Divisions)
    again = reopened(document, tmp_path).getObject("Patches")
    assert np.array_equal(nodes_of(again), before[0]) and again.Divisions == before[1]
    again.touch()
    again.Document.recompute()
    assert np.array_equal(nodes_of(again), before[0]) and again.Divisions == before[1]


@pytest.mark.parametrize(
    "change, words",
    [
        (
            lambda obj, box: setattr(obj, "Source", [(box, ("Edge1",))]),
            "expected a face or a solid",
        ),
        (lambda obj, box: setattr(obj, "Method", "magic"), "magic"),
        (lambda obj, box: setattr(obj, "Source", [(box, ("Solid1",))]), "elements of 8 nodes"),
        (
            lambda obj, box: (setattr(obj, "AutoDivisions", False), setattr(obj, "Divisions", [1])),
            "Divisions: expected 2 numbers for each of 1 elements, got 1",
        ),
    ],
)
def test_an_error_says_why_and_keeps_what_was_there(document, box, change, words):
    obj = patches.make(document)
    obj.Source = [(box, ("Face1",))]
    document.recompute()
    before = nodes_of(obj), obj.Shape.Length
    change(obj, box)
    document.recompute()
    assert not obj.isValid()
    assert words in obj.getStatusString()
    assert words in str(obj.Proxy.failure)
    assert np.array_equal(nodes_of(obj), before[0]) and obj.Shape.Length == before[1]


def test_a_ball_has_no_four_sided_face(document):
    ball = document.addObject("Part::Sphere", "Ball")
    document.recompute()
    obj = patches.make(document)
    obj.Method = "mapped"
    obj.Source = [(ball, ("Face1",))]
    document.recompute()
    assert not obj.isValid()
    assert isinstance(obj.Proxy.failure, nmgs.BlockingError)
    assert obj.Proxy.culprits(obj.Proxy.failure.entities) == [(ball, "Face1")]


def test_quadratic_edges_are_exact(document):
    # A half circle's arc is no parabola; the edge is the parabola through the three nodes.
    nodes = np.array([SQUARE], float)
    nodes[0, 4] = [1, -0.5, 0]
    obj = make.blocks_from_model(document, nmgs.BlockModel(nodes, [1, 1]))
    document.recompute()
    curved = [edge for edge in obj.Shape.Edges if edge.Length > 2.1]
    assert len(curved) == 1
    for t in np.linspace(0, 1, 11):
        x, y = 2 * t, -0.5 * 4 * t * (1 - t)
        vertex = FreeCAD.Vector(x, y, 0)
        import Part

        assert curved[0].distToShape(Part.Vertex(vertex))[0] < 1e-9
