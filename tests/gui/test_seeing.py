# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of a mesh: plot options, report with its histogram, pictures, stale marks."""

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from conftest import content, message_boxes, open_panel, pick, press, process_events, run
from conftest import screenshot, widget
from PySide import QtCore, QtGui, QtSvg

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.objects import make, structured_mesh
from freecad.NMGSWorkbench.taskpanels.histogram import Histogram

COUNTS = (2, 3, 4)


@pytest.fixture
def mesh(document):
    """A box of 24 hexahedra, one corner pulled so that their quality differs."""
    model = nmgs.shapes.box(10, 20, 30, COUNTS)
    model.nodes[0, 6] += (6.0, 3.0, 4.0)
    for a, middle, b in ((6, 13, 5), (6, 14, 7), (6, 18, 2)):
        model.nodes[0, middle] = 0.5 * (model.nodes[0, a] + model.nodes[0, b])
    obj = make.blocks_from_model(document, model)
    made = structured_mesh.make(document)
    made.Blocks = obj
    document.recompute()
    assert made.Proxy.failure is None
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return made


def scene(obj):
    return obj.ViewObject.Proxy.scene


def drawn(obj):
    """Number of polygons that are drawn."""
    return sum(len(polygons) for polygons in scene(obj).plot.polygons)


OUTER = 2 * (2 * 3 + 3 * 4 + 4 * 2)


def test_plot_panel(document, mesh):
    pick(mesh)
    run("NMGS_PlotOptions")
    assert drawn(mesh) == OUTER
    widget(QtGui.QCheckBox, "xi").setChecked(False)
    assert drawn(mesh) == OUTER - 2 * 12
    widget(QtGui.QCheckBox, "xi").setChecked(True)
    widget(QtGui.QComboBox, "plot_as").setCurrentIndex(1)
    assert drawn(mesh) == 2 * OUTER
    widget(QtGui.QComboBox, "plot_as").setCurrentIndex(0)
    widget(QtGui.QComboBox, "cut").setCurrentIndex(1)
    widget(QtGui.QSlider, "cut_at").setValue(400)
    assert drawn(mesh) == 2 * (1 * 3 + 3 * 4 + 4 * 1)
    kept = scene(mesh).plot.points[:, 0].max()
    widget(QtGui.QCheckBox, "cut_flip").setChecked(True)
    assert scene(mesh).plot.points[:, 0].max() > kept + 4
    widget(QtGui.QSlider, "shrink").setValue(20)
    # All of these cells have a face outside, so that each shows its six.
    assert drawn(mesh) == 6 * 12
    colours = widget(QtGui.QComboBox, "colour_by")
    assert scene(mesh).legend.getNumChildren() == 0
    colours.setCurrentIndex(colours.findText("scaled jacobian"))
    assert scene(mesh).legend.getNumChildren() == 1
    screenshot("panel_plot")
    press("Cancel")
    assert drawn(mesh) == OUTER and scene(mesh).legend.getNumChildren() == 0
    assert mesh.ViewObject.ColourBy == "Plain"


def test_plot_options_are_saved(document, mesh, tmp_path):
    pick(mesh)
    run("NMGS_PlotOptions")
    widget(QtGui.QComboBox, "cut").setCurrentIndex(3)
    press("OK")
    assert mesh.ViewObject.Cut == "Z"
    path = str(tmp_path / "plot.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(path).getObject("StructuredMesh")
    process_events(50)
    assert again.ViewObject.Cut == "Z" and drawn(again) == 2 * (2 * 3 + 3 * 2 + 2 * 2)


def test_surfaces_are_plotted_as_quads_or_triangles(document):
    patches = make.blocks_from_model(document, nmgs.shapes.hemisphere(10.0, 3))
    made = structured_mesh.make(document)
    made.Blocks = patches
    document.recompute()
    quads = drawn(made)
    made.ViewObject.PlotAs = "Triangles or tetrahedra"
    assert drawn(made) == 2 * quads == 2 * made.ElementCount


def bars():
    (found,) = [
        w for w in FreeCADGui.getMainWindow().findChildren(QtGui.QWidget, "bars") if w.isVisible()
    ]
    return found


def click(bar_widget, number):
    """What a click on a bar does, by the mouse."""
    place = bar_widget.bar(number).center()
    event = QtGui.QMouseEvent(
        QtCore.QEvent.MouseButtonPress,
        QtCore.QPointF(place),
        QtCore.Qt.LeftButton,
        QtCore.Qt.LeftButton,
        QtCore.Qt.NoModifier,
    )
    QtGui.QApplication.sendEvent(bar_widget, event)
    process_events()


def test_a_bar_marks_its_elements(document, mesh):
    quality = mesh.Proxy.mesh(mesh).quality()["hexahedron"]
    pick(mesh)
    run("NMGS_MeshReport")
    histogram = bars()
    assert isinstance(histogram, Histogram) or histogram.width() > 100
    counts, edges = np.histogram(quality, bins=12, range=(0.0, 1.0))
    number = int(np.argmax(counts))
    assert scene(mesh).marks.getNumChildren() == 0
    click(histogram, number)
    marked = widget(QtGui.QLabel, "marked").text()
    assert marked.startswith(f"{counts[number]} elements")
    assert f"{edges[number]:.4g}" in marked
    assert scene(mesh).marks.getNumChildren() == 1
    screenshot("panel_report_bar")
    press("Close")
    assert scene(mesh).marks.getNumChildren() == 0


def test_a_worst_element_is_zoomed_to(document, mesh):
    cells = mesh.Proxy.mesh(mesh)
    quality = cells.quality()["hexahedron"]
    pick(mesh)
    run("NMGS_MeshReport")
    table = widget(QtGui.QTableWidget, "worst")
    assert int(table.item(0, 0).text()) == int(np.argmin(quality)) + 1
    camera = FreeCADGui.activeDocument().activeView().getCameraNode()
    far = camera.height.getValue()
    table.cellClicked.emit(0, 0)
    process_events()
    assert camera.height.getValue() < 0.8 * far
    middle = cells.points[cells.cells["hexahedron"][np.argmin(quality)]].mean(axis=0)
    way = np.array(camera.getViewVolume(1.0).getProjectionDirection().getValue())
    beside = middle - np.array(camera.position.getValue())
    assert np.linalg.norm(beside - way * (beside @ way)) < 0.2 * far
    screenshot("panel_report_worst")
    press("Close")


def test_colour_by_the_metric_while_the_report_is_open(document, mesh):
    pick(mesh)
    run("NMGS_MeshReport")
    widget(QtGui.QCheckBox, "colours").setChecked(True)
    assert mesh.ViewObject.ColourBy == "scaled_jacobian"
    press("Close")
    assert mesh.ViewObject.ColourBy == "Plain"


def test_fit_panel_tells_of_each_solid_and_picks_it(document, box):
    ball = document.addObject("Part::Sphere", "Ball")
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(box)
    FreeCADGui.Selection.addSelection(ball)
    run("NMGS_FitBlocks")
    made = document.getObject("Blocks")
    open_panel(made)
    # A ball has no six faces with four sides, so that this method has to leave it out.
    widget(QtGui.QComboBox, "method").setCurrentText("mapped")
    press("Apply")
    assert made.ElementCount == 1
    table = widget(QtGui.QTableWidget, "report")
    assert [table.item(row, 0).text() for row in (0, 1)] == ["Box.Solid1", "Ball.Solid1"]
    assert table.item(0, 1).text() == "mapped" and table.item(1, 1).text() == "left out"
    assert len(table.item(1, 3).text()) > 10
    screenshot("panel_fit")
    table.cellClicked.emit(1, 0)
    (picked,) = FreeCADGui.Selection.getSelectionEx()
    assert picked.Object == ball and picked.SubElementNames == ("Solid1",)
    method = widget(QtGui.QComboBox, "method")
    from freecad.NMGSWorkbench.nmgs.cad import METHODS

    assert [method.itemText(n) for n in range(method.count())] == list(METHODS)
    press("Cancel")


@pytest.mark.parametrize("kind", ["png", "pdf", "svg"])
def test_picture(document, mesh, tmp_path, kind):
    mesh.ViewObject.ColourBy = "scaled_jacobian"
    run("NMGS_Picture")
    path = tmp_path / f"mesh.{kind}"
    widget(QtGui.QLineEdit, "path").setText(str(path))
    widget(QtGui.QLineEdit, "title").setText("A pulled box")
    widget(QtGui.QSpinBox, "picture_width").setValue(800)
    widget(QtGui.QSpinBox, "picture_height").setValue(600)
    press("OK")
    assert not message_boxes()
    data = path.read_bytes()
    assert list(tmp_path.iterdir()) == [path]
    if kind == "png":
        image = QtGui.QImage(str(path))
        assert (image.width(), image.height()) == (800, 600)
        # Not all white: the title above, the mesh in the middle.
        rows = [{image.pixel(x, y) for x in range(0, 800, 4)} for y in (*range(4, 32, 2), 300)]
        assert len(set().union(*rows[:-1])) > 2 and len(rows[-1]) > 5
    elif kind == "pdf":
        assert data.startswith(b"%PDF") and b"%%EOF" in data[-32:]
    else:
        drawing = QtSvg.QSvgRenderer(str(path))
        assert drawing.isValid() and drawing.viewBox() == QtCore.QRect(0, 0, 800, 600)
        text = data.decode()
        assert "A pulled box" in text and "x = " in text and "z = " in text


def test_a_picture_that_cannot_be_written(document, mesh, tmp_path):
    run("NMGS_Picture")
    widget(QtGui.QLineEdit, "path").setText(str(tmp_path / "mesh.bmp"))
    assert "png" in widget(QtGui.QLabel, "problem").text()
    widget(QtGui.QLineEdit, "path").setText(str(tmp_path / "none" / "mesh.png"))
    press("OK")
    (box,) = message_boxes()
    assert "none" in box.text() and FreeCADGui.Control.activeDialog()
    press("Cancel")


@pytest.fixture
def when_asked():
    """The preference that leaves stale things until they are asked for."""
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/NMGS")
    group.SetBool("RecomputeAtOnce", False)
    yield
    group.RemBool("RecomputeAtOnce")


@pytest.fixture
def meshed(document, box):
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    run("NMGS_GenerateMesh")
    return document.getObject("Blocks"), document.getObject("StructuredMesh")


def test_a_change_marks_all_that_depends_on_it(document, box, meshed):
    blocks, mesh = meshed
    assert not blocks.Stale and not mesh.Stale
    fresh = blocks.ViewObject.Proxy.getIcon()
    box.Length = 12
    assert blocks.Stale and mesh.Stale
    assert blocks.ViewObject.Proxy.getIcon() != fresh
    screenshot("stale")
    document.recompute()
    assert not blocks.Stale and not mesh.Stale
    assert blocks.ViewObject.Proxy.getIcon() == fresh
    assert mesh.Proxy.mesh(mesh).report().volume == pytest.approx(12 * 20 * 30)
    blocks.Size = 5
    assert blocks.Stale and mesh.Stale
    document.recompute()
    assert not mesh.Stale
    # What changes nothing of the mesh makes nothing stale.
    mesh.ViewObject.ColourBy = "shape"
    mesh.Label = "Another name"
    box.ViewObject.Visibility = True
    assert not blocks.Stale and not mesh.Stale


def test_a_count_marks_the_mesh(document, box, meshed):
    blocks, mesh = meshed
    blocks.AutoDivisions = False
    blocks.Divisions = [1, 2, 3]
    assert mesh.Stale
    document.recompute()
    assert mesh.ElementCount == 6 and not mesh.Stale


def test_stale_until_asked_for(document, box, meshed, when_asked, tmp_path):
    blocks, mesh = meshed
    before = content(mesh)
    assert not FreeCADGui.Command.get("NMGS_Update").isActive()
    box.Length = 12
    document.recompute()
    assert blocks.Stale and mesh.Stale and content(mesh) == before
    # It stays so in a file.
    path = str(tmp_path / "stale.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(path)
    mesh = again.getObject("StructuredMesh")
    assert mesh.Stale
    assert FreeCADGui.Command.get("NMGS_Update").isActive()
    run("NMGS_Update")
    assert not mesh.Stale and not again.getObject("Blocks").Stale
    assert mesh.Proxy.mesh(mesh).report().volume == pytest.approx(12 * 20 * 30)
