# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gallery, help, about, preferences: where a user starts."""

import os
import re

import FreeCAD
import FreeCADGui
import pytest
from conftest import message_boxes, open_panel, press, process_events, run, screenshot, widget
from PySide import QtGui

from freecad.NMGSWorkbench import gallery, resources
from freecad.NMGSWorkbench.objects import preferences


@pytest.mark.parametrize("row", range(len(gallery.EXAMPLES)))
def test_each_example_opens_ready(document, row):
    run("NMGS_Examples")
    listed = widget(QtGui.QListWidget, "examples")
    assert listed.count() == len(gallery.EXAMPLES)
    assert not listed.item(row).icon().isNull()
    listed.setCurrentRow(row)
    press("OK")
    assert not message_boxes(), [box.text() for box in message_boxes()]
    opened = FreeCAD.ActiveDocument
    assert opened is not document and opened.Label == gallery.EXAMPLES[row].title
    meshes = [obj for obj in opened.Objects if hasattr(obj, "WorstScaledJacobian")]
    assert meshes and opened.UndoCount == 0
    for obj in opened.Objects:
        assert obj.isValid() and "Touched" not in obj.State
        assert not getattr(obj, "Stale", False)
    for mesh in meshes:
        assert mesh.ElementCount > 50
        # TetGen promises no scaled Jacobian; structured examples are good ones.
        assert mesh.WorstScaledJacobian > (0.3 if hasattr(mesh, "Blocks") else 0.0)
        drawn = mesh.ViewObject.Proxy.scene.plot
        assert drawn is not None and len(drawn.points)
    screenshot(f"example_{gallery.EXAMPLES[row].name}")


def test_the_cantilever_is_ready_for_calculix(document, tmp_path):
    from freecad.NMGSWorkbench.fem.analysis import solve

    opened = gallery.make("cantilever")
    result = solve(opened.getObject("Analysis"), str(tmp_path))
    # Beam theory: F L^3 / (3 E I) = 100 * 100^3 / (3 * 210000 * 10^4 / 12) = 0.1905 mm, and shear.
    assert max(abs(d.z) for d in result.DisplacementVectors) == pytest.approx(0.1905, rel=0.03)


def test_an_unknown_example():
    with pytest.raises(ValueError, match="hemisphere"):
        gallery.make("teapot")


def test_help_shows_the_guide_with_its_pictures(document):
    run("NMGS_Help")
    (window,) = [w for w in QtGui.QApplication.topLevelWidgets() if w.objectName() == "NMGS_Guide"]
    browser = window.findChild(QtGui.QTextBrowser)
    text = browser.toPlainText()
    for command in ("Fit blocks to solids", "Shape library", "Divisions and grading"):
        assert command in text
    folder = os.path.dirname(resources.guide())
    with open(resources.guide(), encoding="utf-8") as file:
        pictures = re.findall(r"!\[[^]]*\]\(([^)]+)\)", file.read())
    assert len(pictures) > 5
    for name in pictures:
        assert os.path.isfile(os.path.join(folder, name)), name
    process_events(300)
    picture = browser.loadResource(QtGui.QTextDocument.ImageResource, pictures[0])
    assert picture is not None
    screenshot("help")
    window.close()


def test_about_has_versions(document):
    run("NMGS_About")
    (box,) = [w for w in QtGui.QApplication.topLevelWidgets() if w.objectName() == "NMGS_About"]
    for name in ("NMGS Workbench", "FreeCAD", "OpenCASCADE", "TetGen", "Python", "Qt", "NumPy"):
        assert re.search(name + r"(&nbsp;|\s)*</td><td>[\d.]+", box.text()), name
    box.close()


def test_preferences_page_has_every_preference():
    page = FreeCADGui.PySideUic.loadUi(resources.ui("preferences"))
    group = FreeCAD.ParamGet(preferences.PATH)
    entries = {
        w.property("prefEntry"): w
        for w in page.findChildren(QtGui.QWidget)
        if w.property("prefEntry")
    }
    entries = {bytes(k).decode() if not isinstance(k, str) else k: w for k, w in entries.items()}
    assert set(entries) == {"RecomputeAtOnce", "ShowCounts", "WarnBelow", "MostFilled", "TimeLimit"}
    # The page's defaults are those of the program.
    assert not group.GetContents()
    assert entries["RecomputeAtOnce"].isChecked() == preferences.recompute_at_once()
    assert entries["ShowCounts"].isChecked() == preferences.show_counts()
    assert entries["WarnBelow"].value() == preferences.warn_below()
    assert entries["MostFilled"].value() == preferences.most_filled()
    assert entries["TimeLimit"].value() == preferences.time_limit()


def test_new_blocks_follow_the_preference(document):
    group = FreeCAD.ParamGet(preferences.PATH)
    group.SetBool("ShowCounts", False)
    try:
        run("NMGS_ShapeLibrary")
        press("OK")
        (obj,) = document.Objects
        assert not obj.ViewObject.ShowCounts
        open_panel(obj)
        press("Cancel")
    finally:
        group.RemBool("ShowCounts")
