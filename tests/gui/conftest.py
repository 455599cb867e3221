# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every test gets a window with the NMGS workbench and an empty document."""

import os
import pathlib
import time

import FreeCAD
import FreeCADGui
import pytest
import similarity
from PySide import QtCore, QtGui


def process_events(milliseconds: int = 0) -> None:
    """Lets Qt handle what is waiting, for at least that long."""
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


def wait_until(condition, seconds: float = 10.0) -> None:
    """Handles events until the condition holds: the tree, for one, follows with a delay."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        process_events(20)


@pytest.fixture(scope="session", autouse=True)
def workbench():
    # The report view would come and go with each message, and the pictures with it.
    output = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/OutputWindow")
    for what in ("Error", "Warning", "NormalMessage", "LogMessage"):
        output.SetBool(f"checkShowReportViewOn{what}", False)
    FreeCADGui.activateWorkbench("NMGSWorkbench")
    # A first start's side bar is narrower than the buttons of a panel.
    window = FreeCADGui.getMainWindow()
    docks = window.findChildren(QtGui.QDockWidget, "Combo View")
    window.resizeDocks(docks, [400] * len(docks), QtCore.Qt.Horizontal)
    process_events()


@pytest.fixture
def document():
    """A new document; all documents, panels and messages are gone after the test."""
    made = FreeCAD.newDocument("Test")
    yield made
    FreeCADGui.Selection.clearSelection()
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    for dialog in FreeCADGui.getMainWindow().findChildren(QtGui.QFileDialog):
        dialog.close()
    for box in message_boxes():
        box.close()
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    process_events()


def message_boxes():
    """The workbench's messages that are on the screen."""
    return [
        widget
        for widget in QtGui.QApplication.topLevelWidgets()
        if widget.objectName() == "NMGS_Message" and widget.isVisible()
    ]


def tree_labels():
    """Labels of all entries of the model tree that the user sees."""
    labels = []
    for tree in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget):
        walker = QtGui.QTreeWidgetItemIterator(tree)
        while walker.value():
            labels.append(walker.value().text(0))
            walker += 1
    return labels


def pick(obj, *names):
    """Picks sub-elements of an object, or the whole object, as clicks with Ctrl do."""
    FreeCADGui.Selection.clearSelection()
    for name in names or ("",):
        FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)


def open_panel(obj):
    """A double click in the tree; the widget of the panel."""
    assert obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    process_events()
    assert FreeCADGui.Control.activeDialog()


def _found(find, what):
    """What find() returns once it is not empty: FreeCAD 1.1 shows a panel some time after it is
    opened."""
    end = time.monotonic() + 5.0
    while not (found := find()):
        assert time.monotonic() < end, f"no {what}"
        process_events(20)
    return found


def widget(kind, name):
    """A widget of the open panel."""
    window = FreeCADGui.getMainWindow()
    (found,) = _found(
        lambda: [
            w for w in window.findChildren(kind, name) if w.isVisible() and w.window() is window
        ],
        name,
    )
    return found


def press(text):
    """A click on a button of the open panel."""
    boxes = FreeCADGui.getMainWindow().findChildren
    button = _found(
        lambda: [
            button
            for box in boxes(QtGui.QDialogButtonBox)
            for button in (box.buttons() if box.isVisible() else ())
            if button.text().replace("&", "") == text
        ],
        f"button {text}",
    )[0]
    button.click()
    process_events()


def run(command: str) -> None:
    """What a click on the toolbar does."""
    FreeCADGui.runCommand(command)
    process_events()


def content(obj):
    """The FEM mesh of an object as plain values, to compare node for node."""
    mesh = obj.FemMesh
    nodes = {number: tuple(place) for number, place in mesh.Nodes.items()}
    elements = {n: mesh.getElementNodes(n) for n in (*mesh.Volumes, *mesh.Faces, *mesh.Edges)}
    groups = {
        (mesh.getGroupName(g), mesh.getGroupElementType(g)): tuple(sorted(mesh.getGroupElements(g)))
        for g in mesh.Groups
    }
    return nodes, elements, groups


#: Pictures that were looked at and found good, of this FreeCAD; others look different.
STORED = pathlib.Path(__file__).parent / "pictures"
STORED_FOR = ("0", "20")
ALIKE = 0.75


def screenshot(name: str) -> None:
    """The whole window into the folder for pictures, if there is one; compared with a stored one.

    NMGS_STORE_PICTURES=1 stores it instead, where there is a stored one.
    """
    folder = os.environ.get("NMGS_SCREENSHOTS")
    if not folder:
        return
    FreeCADGui.SendMsgToActiveView("ViewFit")
    process_events(300)
    # The screen, not the widget: only the screen has the 3D view.
    picture = QtGui.QApplication.primaryScreen().grabWindow(0)
    assert picture.save(str(pathlib.Path(folder) / f"{name}.png"))
    stored = STORED / f"{name}.png"
    if not stored.is_file() or tuple(FreeCAD.Version()[:2]) != STORED_FOR:
        return
    image = picture.toImage()
    if os.environ.get("NMGS_STORE_PICTURES"):
        small = image.scaled(
            similarity.WIDTH,
            similarity.HEIGHT,
            QtCore.Qt.IgnoreAspectRatio,
            QtCore.Qt.SmoothTransformation,
        )
        assert small.convertToFormat(QtGui.QImage.Format_Grayscale8).save(str(stored))
        return
    alike = similarity.similarity(image, QtGui.QImage(str(stored)))
    assert alike > ALIKE, f"{name}: {alike:.2f} like the stored picture"


@pytest.fixture
def box(document):
    """A box of 10 x 20 x 30 as a document object."""
    part = document.addObject("Part::Box", "Box")
    part.Length, part.Width, part.Height = 10, 20, 30
    document.recompute()
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return part
