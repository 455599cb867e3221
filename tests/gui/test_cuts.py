# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids are cut by picked faces and planes or where it is proposed, and the pieces are tried."""

import FreeCAD
import FreeCADGui
import Part
import pytest
from conftest import message_boxes, open_panel, pick, press, process_events, run, screenshot
from conftest import wait_until, widget
from PySide import QtCore, QtGui

CHECKED = QtCore.Qt.Checked


@pytest.fixture
def bracket(document):
    """An L with a bore through its foot."""
    shape = Part.makeBox(60, 40, 10).fuse(Part.makeBox(10, 40, 50)).removeSplitter()
    shape = shape.cut(Part.makeCylinder(8, 30, FreeCAD.Vector(38, 20, -5)))
    obj = document.addObject("Part::Feature", "Bracket")
    obj.Shape = shape
    document.recompute()
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.activeDocument().activeView().fitAll()
    return obj


def rows(table):
    return [table.item(n, 0).text() for n in range(table.rowCount())]


def test_a_proposed_cut_is_seen_checked_and_made(document, bracket):
    steps = document.UndoCount
    pick(bracket)
    run("NMGS_CutSolids")
    table = widget(QtGui.QTableWidget, "cuts")
    assert table.rowCount() > 3 and document.Objects == [bracket]
    table.setCurrentCell(0, 0)
    table.item(0, 0).setCheckState(CHECKED)
    wait_until(lambda: "2 pieces" in widget(QtGui.QLabel, "summary").text())
    assert table.item(0, 0).checkState() == CHECKED
    process_events(200)
    screenshot("panel_cuts")
    press("OK")
    assert not FreeCADGui.Control.activeDialog()
    (made,) = [obj for obj in document.Objects if obj != bracket]
    assert made.PieceCount == len(made.Shape.Solids) == 2
    assert made.Shape.Volume == pytest.approx(bracket.Shape.Volume)
    # The pieces share what is between them.
    assert len(made.Shape.Faces) < sum(len(s.Faces) for s in made.Shape.Solids)
    assert made.Visibility and not bracket.Visibility
    assert document.UndoCount == steps + 1
    document.undo()
    assert document.Objects == [bracket]


def test_cancel_leaves_no_trace(document, bracket):
    steps = document.UndoCount
    pick(bracket)
    run("NMGS_CutSolids")
    widget(QtGui.QTableWidget, "cuts").item(0, 0).setCheckState(CHECKED)
    process_events(300)
    press("Cancel")
    assert document.Objects == [bracket] and bracket.Visibility
    assert document.UndoCount == steps


def test_the_face_of_another_object_cuts_and_is_followed(document, bracket):
    plane = document.addObject("Part::Plane", "Plane")
    plane.Placement.Base = FreeCAD.Vector(-5, -5, 30)
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(bracket)
    FreeCADGui.Selection.addSelection(plane)
    run("NMGS_CutSolids")
    cut = document.getObject("CutSolids")
    assert sorted(s.Volume for s in cut.Shape.Solids)[0] == pytest.approx(10 * 40 * 20)
    plane.Placement.Base = FreeCAD.Vector(-5, -5, 40)
    document.recompute()
    assert sorted(s.Volume for s in cut.Shape.Solids)[0] == pytest.approx(10 * 40 * 10)
    # The pieces are solids to pick.
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(cut)
    run("NMGS_FitBlocks")
    (blocks,) = [obj for obj in document.Objects if obj.Name.startswith("Blocks")]
    assert {entry["entity"] for entry in blocks.Proxy.entries(blocks)} == {"Solid1", "Solid2"}


def test_a_picked_face_of_the_solid_itself_goes_through_it(document, bracket):
    (top,) = [
        f"Face{n + 1}"
        for n, face in enumerate(bracket.Shape.Faces)
        if abs(face.CenterOfMass.z - 10) < 1e-6 and face.normalAt(0, 0).z > 0.9
    ]
    pick(bracket, top)
    run("NMGS_CutSolids")
    cut = document.getObject("CutSolids")
    assert cut.PieceCount == 2
    assert max(s.BoundBox.ZMin for s in cut.Shape.Solids) == pytest.approx(10)


def test_a_face_that_divides_nothing_is_told(document, bracket):
    outside = document.addObject("Part::Plane", "Plane")
    outside.Placement.Base = FreeCAD.Vector(0, 0, 99)
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(bracket)
    FreeCADGui.Selection.addSelection(outside)
    steps = document.UndoCount
    run("NMGS_CutSolids")
    (box,) = message_boxes()
    assert "divided" in box.text() + box.informativeText()
    assert document.UndoCount == steps and document.getObject("CutSolids") is None


def test_blocks_try_the_pieces(document, bracket):
    pick(bracket)
    run("NMGS_FitBlocks")
    blocks = document.getObject("Blocks")
    steps = document.UndoCount
    open_panel(blocks)
    widget(QtGui.QPushButton, "cut").click()
    process_events(300)
    table = widget(QtGui.QTableWidget, "cuts")
    table.item(0, 0).setCheckState(CHECKED)
    wait_until(lambda: "2 pieces" in widget(QtGui.QLabel, "summary").text())
    # Once more: a cut of what the first one left.
    assert table.rowCount() > 1
    after = rows(table)
    table.item(1, 0).setCheckState(CHECKED)
    wait_until(lambda: rows(table) != after)
    press("OK")
    cut = document.getObject("CutSolids")
    assert len(cut.Cuts) == 2 and cut.PieceCount > 2
    assert [obj for obj, _ in blocks.Source] == [cut]
    entries = blocks.Proxy.entries(blocks)
    assert len(entries) == cut.PieceCount
    assert all(entry["method"] for entry in entries)
    # One step for the options, which were taken as they were, one for the cut.
    assert document.UndoCount <= steps + 2
    # Opened again, the cuts are there and can be taken back.
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(blocks)
    run("NMGS_CutSolids")
    table = widget(QtGui.QTableWidget, "cuts")
    assert [table.item(n, 0).checkState() == CHECKED for n in range(3)] == [True, True, False]
    press("Cancel")
    document.undo()
    assert document.getObject("CutSolids") is None
    assert [obj for obj, _ in blocks.Source] == [bracket]


def test_picked_faces_are_added(document, bracket):
    pick(bracket)
    run("NMGS_CutSolids")
    FreeCADGui.Selection.clearSelection()
    widget(QtGui.QPushButton, "add").click()
    assert widget(QtGui.QLabel, "problem").isVisible()
    (round_,) = [
        f"Face{n + 1}"
        for n, face in enumerate(bracket.Shape.Faces)
        if isinstance(face.Surface, Part.Plane) and abs(face.CenterOfMass.x - 10) < 1e-6
    ]
    FreeCADGui.Selection.addSelection(document.Name, bracket.Name, round_)
    widget(QtGui.QPushButton, "add").click()
    table = widget(QtGui.QTableWidget, "cuts")
    assert rows(table)[0] == f"Bracket.{round_}" and table.item(0, 0).checkState() == CHECKED
    press("OK")
    cut = document.getObject("CutSolids")
    assert cut.PieceCount == 2 and not cut.Cuts
    assert [(obj.Name, names) for obj, names in cut.Tools] == [("Bracket", (round_,))]
