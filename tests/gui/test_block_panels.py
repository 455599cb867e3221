# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that make and change blocks by hand: node table, shape library, divisions and grading."""

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from conftest import message_boxes, open_panel, pick, press, process_events, run, screenshot
from conftest import wait_until, widget
from PySide import QtCore, QtGui

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.objects import make, structured_mesh
from freecad.NMGSWorkbench.objects.block_edges import unique_edges


def panel():
    """The Python object of the open panel."""
    for found in _panels:
        return found
    raise AssertionError("no panel")


_panels = []


@pytest.fixture(autouse=True)
def remember(monkeypatch):
    """Keeps the panel that is shown last, to look at what it draws."""
    from freecad.NMGSWorkbench.taskpanels import model_panel

    made = model_panel.ModelPanel.__init__

    def init(self, *args, **kwargs):
        _panels[:] = [self]
        made(self, *args, **kwargs)

    monkeypatch.setattr(model_panel.ModelPanel, "__init__", init)
    yield
    _panels.clear()


def problem():
    (label,) = FreeCADGui.getMainWindow().findChildren(QtGui.QLabel, "problem")
    return label.text()


def type_in(table, row, column, text):
    table.item(row, column).setText(text)
    process_events(250)


def nodes_of(obj):
    return np.array([tuple(node) for node in obj.Nodes])


def test_new_blocks_by_nodes_is_one_undo_step(document):
    run("NMGS_NodeTable")
    table = widget(QtGui.QTableWidget, "nodes")
    assert table.rowCount() == 20 and table.columnCount() == 5
    assert panel().preview.node is not None
    # Node 7 of the block, where x, y and z are largest.
    type_in(table, 6, 2, "14")
    screenshot("panel_node_table")
    widget(QtGui.QPushButton, "straighten").click()
    type_in(widget(QtGui.QTableWidget, "divisions"), 0, 1, "3")
    assert document.Objects == []
    press("OK")
    (obj,) = document.Objects
    assert obj.Name == "Blocks" and obj.Divisions == [3, 4, 4]
    assert np.allclose(nodes_of(obj)[6], [14, 10, 10])
    # The middle of the edge between nodes 6 and 7.
    assert np.allclose(nodes_of(obj)[13], [12, 5, 10])
    assert panel().preview.node is None
    document.undo()
    assert document.Objects == []


def test_wrong_coordinates_are_marked_as_they_are_typed(document):
    run("NMGS_NodeTable")
    table = widget(QtGui.QTableWidget, "nodes")
    type_in(table, 2, 3, "1o")
    assert table.item(2, 3).background().style() != QtCore.Qt.NoBrush
    assert "1o" in problem() and "3" in problem()
    press("OK")
    assert FreeCADGui.Control.activeDialog() and document.Objects == []
    for box in message_boxes():
        assert "1o" in box.text()
        box.close()
    # A decimal comma is as good as a point.
    type_in(table, 2, 3, "10,5")
    assert table.item(2, 3).background().style() == QtCore.Qt.NoBrush and not problem()
    # A corner pulled through the block folds it over.
    type_in(table, 0, 2, "40")
    assert "Block1" in problem()
    press("Cancel")
    assert document.Objects == [] and document.UndoCount == 0


def test_patches_by_nodes_and_more_blocks(document):
    run("NMGS_NodeTable")
    widget(QtGui.QComboBox, "kind").setCurrentIndex(0)
    assert widget(QtGui.QTableWidget, "nodes").rowCount() == 8
    widget(QtGui.QPushButton, "add").click()
    widget(QtGui.QPushButton, "add").click()
    widget(QtGui.QTableWidget, "nodes").setCurrentCell(10, 2)
    widget(QtGui.QPushButton, "remove").click()
    press("OK")
    (obj,) = document.Objects
    assert obj.Name == "Patches" and obj.ElementCount == 2
    # Of 0, 10 and 20 mm the middle one went.
    assert sorted(set(nodes_of(obj)[:, 0])) == [0, 5, 10, 20, 25, 30]


def test_editing_given_blocks_and_cancel(document):
    obj = make.blocks_from_model(document, nmgs.shapes.cube(10.0, 2))
    mesh = structured_mesh.make(document)
    mesh.Blocks = obj
    document.recompute()
    before, steps = nodes_of(obj), document.UndoCount
    open_panel(obj)
    type_in(widget(QtGui.QTableWidget, "nodes"), 6, 4, "12")
    press("Cancel")
    assert np.array_equal(nodes_of(obj), before) and document.UndoCount == steps
    open_panel(obj)
    type_in(widget(QtGui.QTableWidget, "nodes"), 6, 4, "12")
    type_in(widget(QtGui.QTableWidget, "divisions"), 0, 3, "5")
    press("OK")
    assert document.UndoCount == steps + 1
    assert nodes_of(obj)[6][2] == 12 and mesh.ElementCount == 2 * 2 * 5
    document.undo()
    assert np.array_equal(nodes_of(obj), before) and mesh.ElementCount == 8


def test_shape_library(document):
    run("NMGS_ShapeLibrary")
    shapes = widget(QtGui.QListWidget, "shapes")
    assert shapes.count() == len(nmgs.shapes.NAMES)
    pictures = set()
    for row in range(shapes.count()):
        picture = shapes.item(row).icon().pixmap(96, 76).toImage()
        assert not picture.isNull()
        pictures.add(bytes(picture.constBits()))
    assert len(pictures) == len(nmgs.shapes.NAMES)
    screenshot("panel_shape_library")
    shapes.setCurrentRow(nmgs.shapes.NAMES.index("tube"))
    process_events(250)
    widget(QtGui.QWidget, "argument_radius").setProperty("rawValue", 20.0)
    widget(QtGui.QWidget, "argument_inner_radius").setProperty("rawValue", 30.0)
    process_events(250)
    assert "inner_radius" in problem()
    widget(QtGui.QWidget, "argument_inner_radius").setProperty("rawValue", 12.0)
    widget(QtGui.QSpinBox, "argument_divisions").setValue(3)
    process_events(250)
    assert not problem()
    press("OK")
    (obj,) = document.Objects
    assert obj.Label == "Tube" and obj.Library == "tube"
    radii = np.hypot(*nodes_of(obj)[:, :2].T)
    assert radii.max() == pytest.approx(20) and radii.min() == pytest.approx(12)
    # It stays parametric.
    open_panel(obj)
    assert widget(QtGui.QWidget, "argument_radius").property("rawValue") == 20
    widget(QtGui.QWidget, "argument_height").setProperty("rawValue", 33.0)
    press("OK")
    assert np.ptp(nodes_of(obj)[:, 2]) == pytest.approx(33)
    document.undo()
    assert np.ptp(nodes_of(obj)[:, 2]) == pytest.approx(10)


def test_shape_library_cancelled(document):
    run("NMGS_ShapeLibrary")
    press("Cancel")
    assert document.Objects == [] and document.UndoCount == 0


@pytest.fixture
def flange(document):
    """Two boxes side by side: counts along y and z are common."""
    one = nmgs.shapes.box(10, 20, 30, (2, 3, 4))
    nodes = np.concatenate([one.nodes, one.nodes + (10.0, 0, 0)])
    model = nmgs.BlockModel(nodes, np.tile(one.divisions, (2, 1)))
    obj = make.blocks_from_model(document, model)
    document.recompute()
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return obj


def edge_along(obj, axis, first=True):
    """Name of an edge of the shape along an axis."""
    for number, edge in enumerate(obj.Shape.Edges, 1):
        ends = np.array([tuple(v.Point) for v in edge.Vertexes])
        if np.count_nonzero(np.ptp(ends, axis=0) > 1e-9) == 1 and np.ptp(ends[:, axis]) > 1e-9:
            if first or ends[:, 0].max() > 15:
                return f"Edge{number}"
    raise AssertionError("no such edge")


def test_the_shape_has_the_edges_of_the_table(flange):
    model = flange.Proxy.model(flange)
    assert len(flange.Shape.Edges) == len(unique_edges(model.nodes)) == 12 + 8


def test_divisions_of_a_picked_edge_go_along_its_chain(document, flange):
    steps = document.UndoCount
    pick(flange)
    run("NMGS_Divisions")
    FreeCADGui.Selection.addSelection(document.Name, flange.Name, edge_along(flange, 1))
    process_events()
    count = widget(QtGui.QSpinBox, "count")
    assert count.value() == 3
    # 6 of the 20 edges run along y, with an arrow each; 3 columns of nodes and curves behind.
    group = panel().preview.node.getChild(1)
    assert group.getNumChildren() == 6 + 2
    count.setValue(7)
    widget(QtGui.QComboBox, "grading").setCurrentIndex(1)
    widget(QtGui.QDoubleSpinBox, "ratio").setValue(2.0)
    process_events()
    screenshot("panel_divisions")
    assert list(flange.Divisions) == [2, 3, 4] * 2
    press("OK")
    assert list(flange.Divisions) == [2, 7, 4] * 2
    assert document.UndoCount == steps + 1
    mesh = flange.Proxy.model(flange).generate()
    levels = np.unique(np.round(mesh.points[:, 1], 9))
    assert np.allclose(np.diff(levels)[1:] / np.diff(levels)[:-1], 2.0)
    document.undo()
    assert list(flange.Divisions) == [2, 3, 4] * 2 and not flange.Grading


def test_sizes_that_cannot_be_are_said(document, flange):
    pick(flange, edge_along(flange, 2))
    run("NMGS_Divisions")
    assert widget(QtGui.QSpinBox, "count").value() == 4
    widget(QtGui.QComboBox, "grading").setCurrentIndex(2)
    widget(QtGui.QWidget, "first").setProperty("rawValue", 100.0)
    process_events()
    assert problem()
    press("Cancel")
    assert not flange.Grading and not message_boxes()
    assert FreeCAD.ActiveDocument.UndoCount == document.UndoCount


def test_a_fitted_model_keeps_divisions_by_hand(document, box):
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    made = document.getObject("Blocks")
    run("NMGS_Divisions")
    widget(QtGui.QTableWidget, "chains").setCurrentCell(0, 0)
    widget(QtGui.QSpinBox, "count").setValue(9)
    press("OK")
    assert 9 in made.Divisions and not made.AutoDivisions
    made.touch()
    document.recompute()
    assert 9 in made.Divisions


def test_counts_are_written_on_the_edges(document, flange):
    view = flange.ViewObject
    texts = view.Proxy._counts
    wait_until(lambda: texts.getNumChildren() == 1)
    assert texts.getChild(0).getNumChildren() == 20
    screenshot("blocks_with_counts")
    view.ShowCounts = False
    wait_until(lambda: texts.getNumChildren() == 0)
    view.ShowCounts = True
    wait_until(lambda: texts.getNumChildren() == 1)
    view.Visibility = False
    wait_until(lambda: texts.getNumChildren() == 0)


def test_many_blocks_are_drawn_finely_with_one_count_a_chain(document):
    grid = nmgs.shapes.cube(divisions=5).generate(order=2)
    model = nmgs.BlockModel(grid.points[grid.cells["hexahedron20"]], [[3, 2, 1]] * 125)
    view = make.blocks_from_model(document, model).ViewObject
    document.recompute()
    texts = view.Proxy._counts
    wait_until(lambda: texts.getNumChildren() == 1)
    # Five layers of blocks in each of three directions.
    assert texts.getChild(0).getNumChildren() == 15
    wait_until(lambda: view.LineWidth == 2 and view.PointSize == 3)
    view.LineWidth = 7
    document.Blocks.touch()
    document.recompute()
    process_events(50)
    assert view.LineWidth == 7
