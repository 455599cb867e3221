# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels: OK is one undo step, Cancel leaves no trace, a wrong value is said and keeps it open."""

import FreeCADGui
import pytest
from conftest import content, message_boxes, open_panel, pick, press, run, screenshot, widget
from PySide import QtCore, QtGui

from freecad.NMGSWorkbench import nmgs


@pytest.fixture
def meshed(document, box):
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    run("NMGS_GenerateMesh")
    return document.getObject("StructuredMesh")


def test_divisions_by_ok_is_one_undo_step(document, meshed):
    blocks = document.getObject("Blocks")
    before, steps = blocks.Divisions, document.UndoCount
    mesh = content(meshed)
    open_panel(blocks)
    screenshot("panel_blocks")
    widget(QtGui.QCheckBox, "auto_divisions").setChecked(False)
    table = widget(QtGui.QTableWidget, "divisions")
    assert table.isEnabled() and table.rowCount() == 1
    for column, count in enumerate((2, 3, 4)):
        table.item(0, column).setText(str(count))
    press("OK")
    assert not FreeCADGui.Control.activeDialog()
    assert blocks.Divisions == [2, 3, 4]
    # The mesh followed.
    assert meshed.ElementCount == 24
    assert document.UndoCount == steps + 1
    document.undo()
    assert blocks.Divisions == before
    assert content(meshed) == mesh


def test_apply_then_cancel_leaves_no_trace(document, meshed):
    steps = document.UndoCount
    mesh = content(meshed)
    open_panel(meshed)
    widget(QtGui.QComboBox, "order").setCurrentIndex(1)
    press("Apply")
    assert meshed.Elements[0].startswith("hexahedron20")
    screenshot("panel_structured_mesh")
    press("Cancel")
    assert not FreeCADGui.Control.activeDialog()
    assert content(meshed) == mesh and meshed.Order == 1
    assert meshed.Elements[0].startswith("hexahedron:")
    assert document.UndoCount == steps
    assert "Touched" not in meshed.State


def test_cancel_at_once(document, meshed):
    steps = document.UndoCount
    open_panel(meshed)
    press("Cancel")
    assert document.UndoCount == steps and "Touched" not in meshed.State


def test_a_wrong_value_is_said_and_the_panel_stays(document, meshed):
    blocks = document.getObject("Blocks")
    before = list(blocks.Divisions)
    open_panel(blocks)
    widget(QtGui.QCheckBox, "auto_divisions").setChecked(False)
    widget(QtGui.QTableWidget, "divisions").item(0, 1).setText("many")
    press("OK")
    assert FreeCADGui.Control.activeDialog()
    (box,) = message_boxes()
    assert "η" in box.text() and "many" in box.text()
    press("Cancel")
    assert blocks.Divisions == before and blocks.isValid()


def test_tetgen_panel(document, box):
    pick(box, "Solid1")
    run("NMGS_TetGenMesh")
    made = document.getObject("TetGenMesh")
    count, steps = made.ElementCount, document.UndoCount
    open_panel(made)
    assert widget(QtGui.QLineEdit, "switches").text() == made.Switches
    widget(QtGui.QLineEdit, "switches").setText("pq")
    press("OK")
    assert made.Switches == "pq" and made.ElementCount < count
    assert document.UndoCount == steps + 1
    document.undo()
    assert made.ElementCount == count == made.FemMesh.TetraCount


def option(name):
    """The cell with an option's value."""
    table = widget(QtGui.QTableWidget, "options")
    names = [table.item(row, 0).text() for row in range(table.rowCount())]
    return table.item(names.index(name), 2)


def test_tetgen_panel_switches_and_options_follow_each_other(document, box):
    pick(box, "Solid1")
    run("NMGS_TetGenMesh")
    made = document.getObject("TetGenMesh")
    before = made.Switches
    open_panel(made)
    switches = widget(QtGui.QLineEdit, "switches")
    problem = FreeCADGui.getMainWindow().findChild(QtGui.QLabel, "problem")
    switches.setText("pq1.4a20")
    assert option("plc").checkState() == QtCore.Qt.Checked
    assert float(option("radius edge ratio").text()) == 1.4
    assert float(option("max volume").text()) == 20
    option("max volume").setText("5")
    option("radius edge ratio").setText("1.6")
    option("order").setText("2")
    parsed = nmgs.TetOptions.parse(switches.text())
    assert (parsed.max_volume, parsed.radius_edge_ratio, parsed.order) == (5, 1.6, 2)
    assert parsed.plc and parsed.quality and not problem.text()
    screenshot("panel_tetgen")
    option("max volume").setText("much")
    assert "max_volume" in problem.text() and "much" in problem.text()
    option("max volume").setText("")
    assert not problem.text() and nmgs.TetOptions.parse(switches.text()).max_volume is None
    switches.setText("pq1.4@")
    assert "@" in problem.text()
    preset = widget(QtGui.QComboBox, "preset")
    preset.setCurrentIndex(preset.findText("Mesh of the boundary"))
    assert switches.text() == "p" and not problem.text()
    assert option("quality").checkState() == QtCore.Qt.Unchecked
    press("Cancel")
    assert made.Switches == before


def test_tetgen_panel_shows_the_log(document, box):
    pick(box, "Solid1")
    run("NMGS_TetGenMesh")
    made = document.getObject("TetGenMesh")
    open_panel(made)
    widget(QtGui.QLineEdit, "switches").setText("pq1.5")
    press("Apply")
    log = widget(QtGui.QPlainTextEdit, "log").toPlainText()
    assert "Delaunizing" in log and "Statistics" in log
    press("OK")


def test_patches_panel(document, box):
    pick(box, "Face1")
    run("NMGS_FitPatches")
    made = document.getObject("Patches")
    open_panel(made)
    widget(QtGui.QLineEdit, "reference").setText("side")
    widget(QtGui.QWidget, "element_size").setProperty("rawValue", 5.0)
    press("OK")
    assert made.Reference == "side" and sorted(made.Divisions) == [4, 6]


def test_report(document, meshed):
    steps = document.UndoCount
    pick(meshed)
    run("NMGS_MeshReport")
    summary = widget(QtGui.QLabel, "summary").text()
    assert f"points: {meshed.NodeCount}," in summary and "volume: 6000 mm³" in summary
    metrics = widget(QtGui.QTableWidget, "metrics")
    names = [metrics.item(row, 0).text() for row in range(metrics.rowCount())]
    assert any(name.startswith("scaled jacobian") for name in names)
    screenshot("panel_report")
    # Nothing else is started while a panel is open.
    assert not FreeCADGui.Command.get("NMGS_MeshReport").isActive()
    press("Close")
    assert not FreeCADGui.Control.activeDialog()
    assert document.UndoCount == steps
