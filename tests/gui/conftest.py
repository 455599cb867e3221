# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every test gets a window with the NMGS workbench and an empty document."""

import os
import pathlib

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui


def process_events(milliseconds: int = 0) -> None:
    """Lets Qt handle what is waiting, for at least that long."""
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


@pytest.fixture(scope="session", autouse=True)
def workbench():
    FreeCADGui.activateWorkbench("NMGSWorkbench")
    process_events()


@pytest.fixture
def document():
    """A new document; all documents, panels and messages are gone after the test."""
    made = FreeCAD.newDocument("Test")
    yield made
    FreeCADGui.Selection.clearSelection()
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
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
        if widget.objectName() == "NMGS_Error" and widget.isVisible()
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


def screenshot(name: str) -> None:
    """The whole window into the folder for pictures, if there is one."""
    folder = os.environ.get("NMGS_SCREENSHOTS")
    if folder:
        process_events(300)
        # The screen, not the widget: only the screen has the 3D view.
        picture = QtGui.QApplication.primaryScreen().grabWindow(0)
        assert picture.save(str(pathlib.Path(folder) / f"{name}.png"))


@pytest.fixture
def box(document):
    """A box of 10 x 20 x 30 as a document object."""
    part = document.addObject("Part::Box", "Box")
    part.Length, part.Width, part.Height = 10, 20, 30
    document.recompute()
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return part
