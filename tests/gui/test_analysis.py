# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a mesh to CalculiX's answer by picks and buttons, against beam theory."""

import shutil

import FreeCADGui
import pytest
from conftest import message_boxes, pick, press, run, screenshot, wait_until, widget
from PySide import QtGui

pytestmark = pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")


@pytest.fixture
def bar(document):
    part = document.addObject("Part::Box", "Bar")
    part.Length, part.Width, part.Height = 100, 10, 10
    document.recompute()
    pick(part, "Solid1")
    run("NMGS_FitBlocks")
    run("NMGS_GenerateMesh")
    mesh = document.getObject("StructuredMesh")
    mesh.Order = 2
    document.getObject("Blocks").Size = 5
    document.recompute()
    FreeCADGui.activeDocument().activeView().viewIsometric()
    return part


def choose(bar, mesh):
    """Face1 of the bar held, Face2 loaded, along the normal of Face6."""
    pick(mesh)
    run("NMGS_Analysis")
    assert bar.Visibility and not mesh.Visibility
    for face, button in (("Face1", "hold"), ("Face2", "load"), ("Face6", "along")):
        pick(bar, face)
        widget(QtGui.QPushButton, button).click()
    assert widget(QtGui.QListWidget, "held").item(0).text() == "Bar.Face1"
    assert widget(QtGui.QListWidget, "loaded").item(0).text() == "Bar.Face2"
    assert "Face6" in widget(QtGui.QPushButton, "along").text()


def test_a_bar_bends_as_timoshenko_says(document, bar):
    mesh = document.getObject("StructuredMesh")
    steps, before = document.UndoCount, len(document.Objects)
    choose(bar, mesh)
    assert widget(QtGui.QWidget, "force").property("text") == "100.00 N"
    assert widget(QtGui.QWidget, "young").property("text") in ("210.00 GPa", "210000.00 MPa")
    screenshot("panel_analysis")
    press("OK")
    wait_until(lambda: not FreeCADGui.Control.activeDialog(), 60)
    assert not message_boxes()
    (result,) = [o for o in document.Objects if o.isDerivedFrom("Fem::FemResultObject")]
    young, poisson, load, length, side = 210000, 0.3, 100, 100, 10
    inertia, shear = side**4 / 12, young / (2 * (1 + poisson))
    wanted = load * length**3 / (3 * young * inertia) + load * length / (
        5 / 6 * shear * side**2
    )
    assert max(result.DisplacementLengths) == pytest.approx(wanted, rel=0.02)
    assert result.Mesh.Visibility and not mesh.Visibility and not bar.Visibility
    screenshot("analysis_result")
    assert document.UndoCount == steps + 1
    document.undo()
    assert len(document.Objects) == before


def test_a_pressure_shortens_the_bar(document, bar):
    mesh = document.getObject("StructuredMesh")
    pick(mesh)
    run("NMGS_Analysis")
    for face, button in (("Face1", "hold"), ("Face2", "load")):
        pick(bar, face)
        widget(QtGui.QPushButton, button).click()
    widget(QtGui.QComboBox, "kind").setCurrentIndex(1)
    press("OK")
    wait_until(lambda: not FreeCADGui.Control.activeDialog(), 60)
    (result,) = [o for o in document.Objects if o.isDerivedFrom("Fem::FemResultObject")]
    moved = [vector.x for vector in result.DisplacementVectors]
    # p L / E, but that the held end cannot bulge.
    assert min(moved) == pytest.approx(-1.0 * 100 / 210000, rel=0.03)


def test_cancel_leaves_no_trace(document, bar):
    mesh = document.getObject("StructuredMesh")
    steps, before = document.UndoCount, [obj.Name for obj in document.Objects]
    shown = [obj.Visibility for obj in document.Objects]
    choose(bar, mesh)
    press("Cancel")
    assert [obj.Name for obj in document.Objects] == before
    assert [obj.Visibility for obj in document.Objects] == shown
    assert document.UndoCount == steps


def test_without_faces_it_says_what_is_missing(document, bar):
    pick(document.getObject("StructuredMesh"))
    run("NMGS_Analysis")
    press("OK")
    assert FreeCADGui.Control.activeDialog()
    assert widget(QtGui.QLabel, "problem").isVisible()


def test_an_analysis_alone_is_made_without_calculix(document, bar):
    mesh = document.getObject("StructuredMesh")
    choose(bar, mesh)
    widget(QtGui.QCheckBox, "solve").setChecked(False)
    press("OK")
    (analysis,) = [o for o in document.Objects if o.isDerivedFrom("Fem::FemAnalysis")]
    assert mesh in analysis.Group
    assert not [o for o in document.Objects if o.isDerivedFrom("Fem::FemResultObject")]


def test_what_fails_leaves_the_document_as_it_was(document, bar):
    mesh = document.getObject("StructuredMesh")
    choose(bar, mesh)
    before = [obj.Name for obj in document.Objects]
    widget(QtGui.QWidget, "force").setProperty("rawValue", 0.0)
    press("OK")
    (box,) = message_boxes()
    assert "force" in box.text() + box.informativeText()
    assert [obj.Name for obj in document.Objects] == before
    assert FreeCADGui.Control.activeDialog()


def test_double_click_takes_a_face_away(document, bar):
    choose(bar, document.getObject("StructuredMesh"))
    held = widget(QtGui.QListWidget, "held")
    held.setCurrentRow(0)
    held.itemDoubleClicked.emit(held.item(0))
    assert held.count() == 0
