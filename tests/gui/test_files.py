# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files opened, imported and exported in the window, by FreeCAD's own machinery."""

import importlib

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from conftest import message_boxes, pick, process_events, run, screenshot, tree_labels, wait_until
from PySide import QtGui

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


def export_dialog():
    found = FreeCADGui.getMainWindow().findChildren(QtGui.QFileDialog, "NMGS_Export")
    (dialog,) = [dialog for dialog in found if dialog.isVisible()]
    return dialog


def test_export_asks_for_a_file_and_writes_it(document, files, tmp_path):
    load(files["n3s"])
    pick(FreeCAD.ActiveDocument.Objects[0])
    run("NMGS_GenerateMesh")
    run("NMGS_Export")
    dialog = export_dialog()
    filters = " ".join(dialog.nameFilters())
    assert "*.n3r" in filters and "*.vtu" in filters and "*.inp" in filters
    assert "*.n2s" not in filters
    target = tmp_path / "mesh.vtu"
    dialog.selectNameFilter(next(f for f in dialog.nameFilters() if "*.vtu" in f))
    dialog.findChild(QtGui.QLineEdit, "fileNameEdit").setText(str(target))
    dialog.accept()
    wait_until(target.exists)
    mesh = nmgs.read(target)
    assert len(mesh.cells["hexahedron"]) == 24
    assert message_boxes() == []


def test_an_export_that_fails_says_why(document, files, tmp_path):
    load(files["n3s"])
    pick(FreeCAD.ActiveDocument.Objects[0])
    run("NMGS_Export")
    dialog = export_dialog()
    dialog.fileSelected.emit(str(tmp_path / "no_such_folder" / "mesh.n3s"))
    process_events()
    (box,) = message_boxes()
    assert "no_such_folder" in box.text()
    dialog.reject()
