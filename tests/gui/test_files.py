# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files opened, imported and exported in the window, by FreeCAD's own machinery."""

import importlib

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from conftest import (
    message_boxes,
    pick,
    press,
    process_events,
    run,
    screenshot,
    tree_labels,
    wait_until,
    widget,
)
from PySide import QtCore, QtGui

from freecad.NMGSWorkbench import nmgs

#: A patch with one curved edge; a unit cube's 20 nodes; a tetrahedron.
PATCH = np.array(
    [[[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0], [1, 0, 0.4], [2, 0.5, 0], [1, 1, 0], [0, 0.5, 0]]]
)
BOTTOM = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
MIDDLES = [[0.5, 0, 0], [1, 0.5, 0], [0.5, 1, 0], [0, 0.5, 0]]
UP = np.array([0, 0, 1.0])
CUBE = np.concatenate([BOTTOM, BOTTOM + UP, MIDDLES, MIDDLES + UP, np.array(BOTTOM) + UP / 2])[None]
TETRA = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
FACETS = np.array([[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


@pytest.fixture
def files(tmp_path):
    """One file of each type, by extension."""
    contents = {
        "n2s": nmgs.BlockModel(PATCH, [4, 3]),
        "n3s": nmgs.BlockModel(CUBE, [2, 3, 4]),
        "node": nmgs.PLC(TETRA, ()),
        "poly": nmgs.PLC(TETRA, FACETS),
        "smesh": nmgs.PLC(TETRA, FACETS),
        "ele": nmgs.Mesh(TETRA, {"tetra": np.array([[0, 1, 2, 3]])}),
        "n2r": nmgs.BlockModel(PATCH, [4, 3]).generate(),
        "n3r": nmgs.BlockModel(CUBE, [2, 3, 4]).generate(),
    }
    paths = {}
    for extension, content in contents.items():
        paths[extension] = tmp_path / f"my_{extension}.{extension}"
        nmgs.write(paths[extension], content)
    return paths


def load(path):
    """FreeCAD finds the module by the extension and calls it, as File > Open does."""
    try:
        FreeCADGui.loadFile(str(path))
    finally:
        process_events()


@pytest.mark.parametrize("extension", ["n2s", "n3s", "node", "poly", "smesh", "ele", "n2r", "n3r"])
def test_open(document, files, extension):
    load(files[extension])
    opened = FreeCAD.ActiveDocument
    assert opened is not document
    label = f"my_{extension}"
    assert opened.Label == label
    wait_until(lambda: tree_labels().count(label) == 2)
    obj = next(o for o in opened.Objects if o.Label == label and o.Visibility)
    assert obj.ViewObject.Proxy is not None and obj.ViewObject.isVisible()
    assert "Touched" not in obj.State
    screenshot(f"open_{extension}")


def test_import_into_a_document(document, files):
    (module,) = FreeCAD.getImportType("n3s")
    importlib.import_module(module).insert(str(files["n3s"]), document.Name)
    (obj,) = document.Objects
    assert obj.Label == "my_n3s" and len(obj.Shape.Edges) == 12
    document.undo()
    assert document.Objects == []


def test_the_whole_way_from_a_file(document, files):
    load(files["n3s"])
    opened = FreeCAD.ActiveDocument
    pick(opened.Objects[0])
    run("NMGS_GenerateMesh")
    mesh = opened.getObject("StructuredMesh")
    assert mesh.FemMesh.HexaCount == 24
    assert mesh.Proxy.mesh(mesh).report().volume == pytest.approx(1)


def test_a_bad_file_is_an_error_in_words(document, tmp_path):
    path = tmp_path / "bad.n3s"
    path.write_text("NMGS-SVMG Problem Setup File\nsome text\nmany\n")
    before = set(FreeCAD.listDocuments())
    load(path)
    (box,) = message_boxes()
    assert "Cannot open bad.n3s" in box.text() and f"{path}:3" in box.text().replace(", line ", ":")
    # FreeCAD itself closes an untouched empty document when another is opened.
    assert set(FreeCAD.listDocuments()) <= before


def test_export_panel_writes_a_file(document, files, tmp_path):
    load(files["n3s"])
    pick(FreeCAD.ActiveDocument.Objects[0])
    run("NMGS_GenerateMesh")
    run("NMGS_Export")
    formats = widget(QtGui.QComboBox, "format")
    texts = " ".join(formats.itemText(n) for n in range(formats.count()))
    assert "*.n3r" in texts and "*.vtu" in texts and "*.inp" in texts and "*.n2s" not in texts
    target = tmp_path / "mesh.vtu"
    widget(QtGui.QLineEdit, "path").setText(str(target))
    assert "*.vtu" in formats.currentText()
    screenshot("panel_export")
    press("OK")
    mesh = nmgs.read(target)
    assert len(mesh.cells["hexahedron"]) == 24
    assert message_boxes() == [] and not FreeCADGui.Control.activeDialog()


def test_export_of_another_order_and_fewer_groups(document, box, tmp_path):
    pick(box, "Solid1")
    run("NMGS_FitBlocks")
    document.getObject("Blocks").Size = 10
    document.recompute()
    run("NMGS_GenerateMesh")
    mesh = FreeCADGui.Selection.getSelection()[0]
    held = mesh.Proxy.mesh(mesh)
    run("NMGS_Export")
    groups = widget(QtGui.QListWidget, "groups")
    assert groups.count() == len(held.groups)
    for row in range(groups.count()):
        groups.item(row).setCheckState(QtCore.Qt.Unchecked)
    widget(QtGui.QComboBox, "order").setCurrentIndex(2)
    formats = widget(QtGui.QComboBox, "format")
    target = tmp_path / "mesh.vtu"
    widget(QtGui.QLineEdit, "path").setText(str(target))
    # Another format takes the file's ending along.
    (inp,) = [n for n in range(formats.count()) if "*.inp" in formats.itemText(n)]
    formats.setCurrentIndex(inp)
    target = tmp_path / "mesh.inp"
    assert widget(QtGui.QLineEdit, "path").text() == str(target)
    press("OK")
    written = nmgs.read(target)
    assert len(written.cells["hexahedron20"]) == 6
    assert held.groups and not set(written.groups) & set(held.groups)
    # What is in the document stays as it is.
    assert mesh.Proxy.mesh(mesh) is held


def test_export_split_into_tetrahedra(document, files, tmp_path):
    load(files["n3s"])
    pick(FreeCAD.ActiveDocument.Objects[0])
    run("NMGS_GenerateMesh")
    run("NMGS_Export")
    widget(QtGui.QLineEdit, "path").setText(str(tmp_path / "mesh.vtu"))
    widget(QtGui.QCheckBox, "split").setChecked(True)
    widget(QtGui.QComboBox, "order").setCurrentIndex(2)
    press("OK")
    assert len(nmgs.read(tmp_path / "mesh.vtu").cells["tetra10"]) == 12 * 24


def test_an_export_that_fails_says_why_and_stays(document, files, tmp_path):
    load(files["n3s"])
    pick(FreeCAD.ActiveDocument.Objects[0])
    run("NMGS_Export")
    widget(QtGui.QLineEdit, "path").setText(str(tmp_path / "no_such_folder" / "mesh.n3s"))
    press("OK")
    (box,) = message_boxes()
    assert "no_such_folder" in box.text()
    assert FreeCADGui.Control.activeDialog()
    press("Cancel")
