# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main job by the toolbar: pick as a click does, run the commands, find the results."""

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from conftest import (
    content,
    message_boxes,
    pick,
    process_events,
    run,
    screenshot,
    tree_labels,
    wait_until,
)
from PySide import QtGui


def names(document):
    return [obj.Name for obj in document.Objects]


def test_face_to_patches_to_quads(document, box):
    pick(box, "Face1")
    run("NMGS_FitPatches")
    made = document.getObject("Patches")
    assert made.ElementCount == 1 and len(made.Nodes) == 8
    # Face1 of a box is its side x = 0.
    nodes = np.array([tuple(node) for node in made.Nodes])
    assert np.allclose(np.ptp(nodes, axis=0), [0, 20, 30]) and np.allclose(nodes[:, 0], 0)
    assert "Patches" in tree_labels()
    # The result is picked: the next command goes on with it.
    assert FreeCADGui.Selection.getSelection() == [made]
    screenshot("patches")
    run("NMGS_GenerateMesh")
    mesh = document.getObject("StructuredMesh")
    assert mesh.ElementCount == made.Divisions[0] * made.Divisions[1]
    assert mesh.FemMesh.QuadrangleCount == mesh.ElementCount
    assert "StructuredMesh" in tree_labels()
    screenshot("patches_mesh")


def test_solid_to_blocks_to_hexahedra_saved_and_reopened(document, box, tmp_path):
    box.Placement = FreeCAD.Placement(
        FreeCAD.Vector(1 / 3, 0.1, -7), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40)
    )
    document.recompute()
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    made = document.getObject("Blocks")
    assert made.ElementCount == 1 and len(made.Nodes) == 20
    assert len(made.Shape.Edges) == 12
    screenshot("blocks")
    run("NMGS_GenerateMesh")
    mesh = document.getObject("StructuredMesh")
    assert mesh.ElementCount == np.prod(made.Divisions) == mesh.FemMesh.HexaCount
    assert mesh.ViewObject.Visibility and not box.Visibility
    assert {"Box", "Blocks", "StructuredMesh"} <= set(tree_labels())
    screenshot("hexahedra")
    before = content(mesh)

    path = str(tmp_path / "kept.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    process_events()
    assert "StructuredMesh" not in tree_labels()
    again = FreeCAD.openDocument(path)
    wait_until(lambda: {"Box", "Blocks", "StructuredMesh"} <= set(tree_labels()))
    mesh = again.getObject("StructuredMesh")
    assert content(mesh) == before
    assert mesh.ViewObject.Proxy is not None and mesh.ViewObject.Visibility
    mesh.Blocks.touch()
    again.recompute()
    nodes, elements, groups = content(mesh)
    assert (elements, groups) == before[1:]
    # FreeCAD writes the part's placement with 16 digits, so its shape comes back a last bit off.
    assert list(nodes) == list(before[0])
    assert np.allclose(list(nodes.values()), list(before[0].values()), rtol=0, atol=1e-12)


@pytest.mark.parametrize("how", ["whole object", "face"])
def test_a_solid_picked_otherwise(document, box, how):
    pick(box, "Face3" if how == "face" else "")
    run("NMGS_FitBlocks")
    assert document.getObject("Blocks").Source == [(box, ("Solid1",))]


def test_all_faces_of_an_object(document, box):
    pick(box)
    run("NMGS_FitPatches")
    assert document.getObject("Patches").ElementCount == 6


def test_undo_takes_back_each_command(document, box):
    steps = [names(document)]
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    steps.append(names(document))
    run("NMGS_GenerateMesh")
    steps.append(names(document))
    assert document.UndoNames[:2] == ["Generate mesh", "Fit blocks to solids"]
    mesh = content(document.getObject("StructuredMesh"))
    assert not box.Visibility

    document.undo()
    assert names(document) == steps[1]
    document.undo()
    assert names(document) == steps[0] and box.Visibility
    document.redo()
    document.redo()
    assert names(document) == steps[2]
    assert content(document.getObject("StructuredMesh")) == mesh
    wait_until(lambda: "StructuredMesh" in tree_labels())


def test_what_cannot_be_done_is_grey(document, box):
    def active():
        return {
            name
            for name in FreeCADGui.listCommands()
            if name.startswith("NMGS_") and FreeCADGui.Command.get(name).isActive()
        }

    always = {"NMGS_ShapeLibrary", "NMGS_NodeTable", "NMGS_Examples", "NMGS_Help", "NMGS_About"}
    always |= {"NMGS_Picture"}
    FreeCADGui.Selection.clearSelection()
    assert active() == always
    pick(box, "Edge1")
    assert active() == always
    pick(box, "Face1")
    assert active() - always == {
        "NMGS_FitPatches",
        "NMGS_FitBlocks",
        "NMGS_CutSolids",
        "NMGS_TetGenMesh",
    }
    run("NMGS_FitPatches")
    # Patches alone have no CAD faces of their own.
    of_any = {"NMGS_TetGenMesh", "NMGS_PlotOptions", "NMGS_Export"}
    assert active() - always == of_any | {"NMGS_GenerateMesh", "NMGS_Divisions"}
    run("NMGS_GenerateMesh")
    assert active() - always == of_any | {"NMGS_MeshReport"}
    sheet = document.addObject("Part::Plane", "Sheet")
    document.recompute()
    pick(sheet)
    assert active() - always == {"NMGS_FitPatches"}


def bow_tie(document):
    """A prism over a polygon that crosses itself: a solid that is not valid."""
    corners = [(0, 0, 0), (10, 10, 0), (10, 0, 0), (0, 10, 0), (0, 0, 0)]
    made = document.addObject("Part::Feature", "BowTie")
    made.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 10))
    assert len(made.Shape.Solids) == 1 and not made.Shape.isValid()
    return made


def test_an_error_is_words_and_the_culprit_is_picked(document):
    part = bow_tie(document)
    pick(part, "Solid1")
    run("NMGS_FitBlocks")
    (box,) = message_boxes()
    assert "Solid1" in box.text() and "Traceback" not in box.text()
    assert "fault of the NMGS workbench" not in box.text()
    assert names(document) == ["BowTie"]
    assert document.UndoCount == 0 or document.UndoNames[0] != "Fit blocks to solids"
    (picked,) = FreeCADGui.Selection.getSelectionEx()
    assert picked.Object == part and picked.SubElementNames == ("Solid1",)
    screenshot("error")


def test_context_menu(document, box):
    pick(box)
    FreeCADGui.activeWorkbench().ContextMenu("View")
    from freecad.NMGSWorkbench.commands import names_for_context_menu

    assert names_for_context_menu() == [
        "NMGS_FitPatches",
        "NMGS_FitBlocks",
        "NMGS_CutSolids",
        "NMGS_TetGenMesh",
    ]


def test_toolbar_and_menu():
    from freecad.NMGSWorkbench.commands import COMMANDS

    toolbars = FreeCADGui.activeWorkbench().getToolbarItems()
    names = [name for name in toolbars["NMGS"] if name != "Separator"]
    assert names == [name for name in COMMANDS if name not in ("NMGS_Help", "NMGS_About")]
    menus = FreeCADGui.getMainWindow().menuBar().findChildren(QtGui.QMenu)
    (menu,) = [menu for menu in menus if menu.title().replace("&", "") == "NMGS"]
    actions = [action for action in menu.actions() if not action.isSeparator()]
    assert [action.text().replace("&", "") for action in actions] == [
        command.menu_text for command in COMMANDS.values()
    ]
    keys = [command.accel for command in COMMANDS.values() if command.accel]
    assert len(set(keys)) == len(keys) > 10
    for action in actions:
        assert not action.icon().isNull() and len(action.toolTip()) > 20
        assert len(action.statusTip()) > 20 and len(action.whatsThis()) > 20


def test_blocks_stay_under_their_mesh(document, box):
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    run("NMGS_GenerateMesh")
    mesh = document.getObject("StructuredMesh")
    assert mesh.ViewObject.claimChildren() == [document.getObject("Blocks")]
    for obj in (mesh, document.getObject("Blocks")):
        assert not obj.ViewObject.Icon.isNull()
