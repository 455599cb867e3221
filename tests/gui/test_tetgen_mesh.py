# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen mesh by the toolbar: of a solid, a PLC, points, and of what TetGen refuses."""

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from conftest import content, message_boxes, pick, process_events, run, screenshot
from tetgen_bounds import volume_bound

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.objects import plc, tetgen_mesh
from freecad.NMGSWorkbench.taskpanels import culprits
from freecad.NMGSWorkbench.taskpanels.tetgen_mesh import TetGenMeshPanel

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
SIDES = np.array(
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
)


def volume(obj):
    return obj.Proxy.mesh(obj).report().volume


def test_solid(document, box):
    pick(box, "Solid1")
    run("NMGS_TetGenMesh")
    made = document.getObject("TetGenMesh")
    assert made is not None, [b.text() for b in message_boxes()]
    assert volume(made) == pytest.approx(6000)
    assert made.FemMesh.TetraCount == made.ElementCount
    # Edges of about a twentieth of the diagonal: no tetrahedron is larger than such a regular one.
    largest = made.Proxy.mesh(made).quality("volume")["tetra"].max()
    assert largest <= volume_bound(1.01 * (1400**0.5 / 20) ** 3 / (6 * 2**0.5))
    assert not box.Visibility
    screenshot("tetgen")
    before = content(made)
    document.undo()
    assert document.getObject("TetGenMesh") is None and box.Visibility
    document.redo()
    assert content(document.getObject("TetGenMesh")) == before


def test_plc(document):
    pick(plc.make(document, nmgs.PLC(CUBE, SIDES)))
    run("NMGS_TetGenMesh")
    assert volume(document.getObject("TetGenMesh")) == pytest.approx(1)


def test_points(document):
    pick(plc.make(document, nmgs.PLC(np.vstack([CUBE, [[0.4, 0.5, 0.6]]]), ())))
    run("NMGS_TetGenMesh")
    made = document.getObject("TetGenMesh")
    assert volume(made) == pytest.approx(1) and made.NodeCount == 9


def test_blocks(document, box):
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    run("NMGS_TetGenMesh")
    assert volume(document.getObject("TetGenMesh")) == pytest.approx(6000)


def test_hexahedra(document, box):
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    document.getObject("Blocks").Size = 5
    document.recompute()
    run("NMGS_GenerateMesh")
    run("NMGS_TetGenMesh")
    assert volume(document.getObject("TetGenMesh")) == pytest.approx(6000)


def test_what_tetgen_refuses_is_a_message(document):
    """Two triangles through each other: TetGen 1.5 ends its process on such."""
    rng = np.random.default_rng(7)
    points = rng.random((90, 3))
    made = plc.make(document, nmgs.PLC(points, np.arange(90).reshape(30, 3)))
    pick(made)
    run("NMGS_TetGenMesh")
    assert document.getObject("TetGenMesh") is None
    (box,) = message_boxes()
    assert box.text().startswith("TetGen mesh")
    assert "fault of the NMGS workbench" not in box.text()
    assert FreeCADGui.Selection.getSelection()
    # The facets are drawn until something else is picked.
    assert culprits.drawn()
    screenshot("culprits")
    pick(made)
    assert not culprits.drawn()


def test_faces_that_cross_are_selected(document):
    """Two boxes that go through each other."""
    boxes = [Part.makeBox(2, 2, 2), Part.makeBox(2, 2, 2, FreeCAD.Vector(1, 1, 1))]
    part = document.addObject("Part::Feature", "Crossing")
    part.Shape = Part.makeCompound(boxes)
    document.recompute()
    mesh = tetgen_mesh.make(document)
    mesh.Source = [(part, ("",))]
    mesh.ViewObject.Document.setEdit(mesh.Name)
    process_events()
    panel = TetGenMeshPanel(mesh)
    assert not panel.apply()
    (picked,) = FreeCADGui.Selection.getSelectionEx()
    assert picked.Object is part
    assert all(name.startswith("Face") for name in picked.SubElementNames)
    assert len(picked.SubElementNames) >= 2
    assert not culprits.drawn()
