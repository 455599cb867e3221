# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user guide's pictures, made by scripts/pictures inside FreeCAD's window.

Environment: NMGS_PICTURES, the folder that they are written to.
"""

import os
import sys
import traceback

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore, QtGui

from freecad.NMGSWorkbench import gallery

OUT = os.environ["NMGS_PICTURES"]


def say(text):
    sys.__stdout__.write("".join(f"NMGS| {line}\n" for line in text.split("\n")))
    sys.__stdout__.flush()


def wait(milliseconds):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


def view():
    return FreeCADGui.activeDocument().activeView()


def look():
    view().viewIsometric()
    view().fitAll()
    wait(200)


def save_view(name, width=480, height=380):
    view().saveImage(os.path.join(OUT, f"{name}.png"), 2 * width, 2 * height, "White")
    path = os.path.join(OUT, f"{name}.png")
    image = QtGui.QImage(path).scaled(
        width, height, QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation
    )
    image.save(path)
    say(name)


def save_window(name):
    """The whole window: the screen, as only it has the 3D view."""
    wait(600)
    picture = QtGui.QApplication.primaryScreen().grabWindow(0).toImage()
    picture = picture.scaledToWidth(900, QtCore.Qt.SmoothTransformation)
    picture.save(os.path.join(OUT, f"{name}.png"))
    say(name)


def press(*texts):
    for box in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        for button in box.buttons() if box.isVisible() else ():
            if button.text().replace("&", "") in texts:
                button.click()
                wait(400)
                return


def close_panel():
    press("Cancel", "Close")


def child(kind, name):
    found = FreeCADGui.getMainWindow().findChildren(kind, name)
    return [w for w in found if w.isVisible()][0]


def pick(obj, *names):
    FreeCADGui.Selection.clearSelection()
    for name in names or ("",):
        FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)


def run(command):
    FreeCADGui.runCommand(command)
    wait(400)


def examples():
    for example in gallery.EXAMPLES:
        document = gallery.make(example.name)
        wait(100)
        for obj in document.Objects:
            if obj.isDerivedFrom("Fem::Constraint") or hasattr(obj, "Divisions"):
                obj.ViewObject.Visibility = False
        wait(100)
        look()
        save_view(f"example_{example.name}")
        FreeCAD.closeDocument(document.Name)


def cuts():
    document = FreeCAD.newDocument("Cuts")
    shape = Part.makeBox(60, 40, 10).fuse(Part.makeBox(10, 40, 50)).removeSplitter()
    part = document.addObject("Part::Feature", "Bracket")
    part.Shape = shape.cut(Part.makeCylinder(8, 30, FreeCAD.Vector(38, 20, -5)))
    document.recompute()
    look()
    pick(part)
    run("NMGS_CutSolids")
    table = child(QtGui.QTableWidget, "cuts")
    table.setCurrentCell(0, 0)
    table.item(0, 0).setCheckState(QtCore.Qt.Checked)
    save_window("cuts")
    close_panel()
    FreeCAD.closeDocument(document.Name)


def analysis():
    document = FreeCAD.newDocument("Analysis")
    bar = document.addObject("Part::Box", "Bar")
    bar.Length, bar.Width, bar.Height = 100, 20, 10
    document.recompute()
    look()
    pick(bar, "Solid1")
    run("NMGS_FitBlocks")
    document.getObject("Blocks").Size = 4
    run("NMGS_GenerateMesh")
    mesh = document.getObject("StructuredMesh")
    mesh.Order = 2
    document.recompute()
    pick(mesh)
    run("NMGS_Analysis")
    for face, button in (("Face1", "hold"), ("Face2", "load"), ("Face6", "along")):
        pick(bar, face)
        child(QtGui.QPushButton, button).click()
    save_window("analysis")
    press("OK")
    wait(500)
    save_window("analysis_result")
    FreeCAD.closeDocument(document.Name)


def panels():
    FreeCAD.newDocument("Guide")
    run("NMGS_ShapeLibrary")
    save_window("shape_library")
    close_panel()
    run("NMGS_NodeTable")
    save_window("node_table")
    close_panel()
    document = FreeCAD.ActiveDocument
    part = document.addObject("Part::Box", "Box")
    part.Length, part.Width, part.Height = 10, 20, 30
    document.recompute()
    look()
    pick(part, "Solid1")
    run("NMGS_FitBlocks")
    blocks = document.getObject("Blocks")
    blocks.Size = 3
    document.recompute()
    blocks.ViewObject.Proxy.doubleClicked(blocks.ViewObject)
    save_window("fit")
    close_panel()
    cuts()
    analysis()
    FreeCAD.setActiveDocument(document.Name)
    FreeCADGui.setActiveDocument(document.Name)
    pick(blocks)
    run("NMGS_Divisions")
    child(QtGui.QTableWidget, "chains").setCurrentCell(2, 0)
    child(QtGui.QComboBox, "grading").setCurrentIndex(1)
    child(QtGui.QDoubleSpinBox, "ratio").setValue(1.3)
    save_window("divisions")
    close_panel()
    FreeCAD.closeDocument(document.Name)

    document = gallery.make("elbow")
    mesh = document.getObject("Hexahedra")
    mesh.Blocks.ViewObject.Visibility = False
    look()
    pick(mesh)
    run("NMGS_PlotOptions")
    child(QtGui.QComboBox, "cut").setCurrentIndex(2)
    child(QtGui.QSlider, "shrink").setValue(15)
    colours = child(QtGui.QComboBox, "colour_by")
    colours.setCurrentIndex(1)
    save_window("plot")
    close_panel()
    pick(mesh)
    run("NMGS_MeshReport")
    histogram = child(QtGui.QWidget, "bars")
    summary = mesh.Proxy.mesh(mesh).report(bins=12).metrics["hexahedron"]["scaled_jacobian"]
    number = int(summary.histogram.argmax())
    event = QtGui.QMouseEvent(
        QtCore.QEvent.MouseButtonPress,
        QtCore.QPointF(histogram.bar(number).center()),
        QtCore.Qt.LeftButton,
        QtCore.Qt.LeftButton,
        QtCore.Qt.NoModifier,
    )
    QtGui.QApplication.sendEvent(histogram, event)
    save_window("report")
    close_panel()
    pick(mesh)
    run("NMGS_Export")
    save_window("export")
    close_panel()
    FreeCAD.closeDocument(document.Name)

    document = gallery.make("bracket")
    look()
    mesh = document.getObject("Tetrahedra")
    mesh.ViewObject.Proxy.doubleClicked(mesh.ViewObject)
    save_window("tetgen")
    close_panel()
    FreeCAD.closeDocument(document.Name)


def go():
    code = 1
    try:
        FreeCADGui.activateWorkbench("NMGSWorkbench")
        window = FreeCADGui.getMainWindow()
        window.showMaximized()
        docks = window.findChildren(QtGui.QDockWidget, "Combo View")
        window.resizeDocks(docks, [380] * len(docks), QtCore.Qt.Horizontal)
        for name in ("Report view", "Python console"):
            for dock in window.findChildren(QtGui.QDockWidget, name):
                dock.hide()
        examples()
        panels()
        code = 0
    except BaseException:
        say(traceback.format_exc())
    sys.stdout.flush()
    os._exit(code)


QtCore.QTimer.singleShot(1500, go)
