# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 3D view as a picture with a title and axes: PNG, PDF, SVG or paper."""

from __future__ import annotations

import os
import tempfile
from typing import Any, Optional, Tuple

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ..resources import icon, ui
from ..texts import tr
from . import messages
from .base import flags_value, ok_cancel, tell

KINDS = {"png": "PNG picture", "pdf": "PDF file", "svg": "SVG drawing"}
_BACKGROUNDS = ("White", "Current", "Transparent")
_AXIS_COLOURS = ((190, 30, 30), (20, 130, 40), (30, 60, 190))


class PicturePanel:
    """Changes nothing in the document. OK writes the file."""

    def __init__(self, document: Any):
        self.document = document
        self.form = form = FreeCADGui.PySideUic.loadUi(ui("picture"))
        form.setWindowIcon(QtGui.QIcon(icon("nmgs_picture")))
        folder = os.path.dirname(document.FileName) or os.path.expanduser("~")
        form.path.setText(os.path.join(folder, f"{document.Label}.png"))
        form.title.setText(document.Label)
        form.browse.clicked.connect(self._browse)
        form.print_it.clicked.connect(self._print)
        form.path.textChanged.connect(self._check)
        self._check()

    def _check(self, *_: Any) -> None:
        ending = os.path.splitext(self.form.path.text())[1].lower()[1:]
        known = ending in KINDS
        text = tr("The file's ending is to be one of {known}").format(known=", ".join(KINDS))
        tell(self.form, "" if known else text)

    def _browse(self) -> None:
        dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), self.form.windowTitle())
        dialog.setObjectName("NMGS_Picture")
        dialog.setAcceptMode(QtGui.QFileDialog.AcceptSave)
        dialog.setNameFilters([f"{text} (*.{name})" for name, text in KINDS.items()])
        dialog.selectFile(self.form.path.text())
        dialog.fileSelected.connect(self.form.path.setText)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _paint(self, painter: Any, box: Any) -> None:
        form = self.form
        paint(
            painter,
            box,
            self.document,
            form.title.text(),
            form.axes.isChecked(),
            _BACKGROUNDS[form.background.currentIndex()],
            (form.picture_width.value(), form.picture_height.value()),
        )

    def _print(self) -> None:
        FreeCADGui.runCommand("Std_Print")

    def getStandardButtons(self) -> int:
        return ok_cancel()

    def accept(self) -> bool:
        form = self.form
        try:
            write(
                form.path.text(),
                (form.picture_width.value(), form.picture_height.value()),
                self._paint,
            )
        except Exception as error:
            messages.show_error(tr("Picture"), error)
            return False
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self) -> bool:
        FreeCADGui.Control.closeDialog()
        return True


def write(path: str, size: Any, paint_it: Any) -> None:
    """A file of the kind that its ending says; it appears whole or not at all.

    paint_it(painter, QRectF) paints it. Raises ValueError, OSError.
    """
    ending = os.path.splitext(path)[1].lower()[1:]
    if ending not in KINDS:
        raise ValueError(f"{path}: expected one of {', '.join(KINDS)} as the file's ending")
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise FileNotFoundError(f"{folder}: no such folder")
    partial = os.path.join(folder, f".{os.path.basename(path)}.part.{ending}")
    box = QtCore.QRectF(0, 0, *size)
    try:
        if ending == "png":
            image = QtGui.QImage(*size, QtGui.QImage.Format_ARGB32)
            image.fill(QtCore.Qt.transparent)
            device: Any = image
        elif ending == "pdf":
            device = QtGui.QPdfWriter(partial)
            device.setResolution(96)
            _set_page(device, size)
            device.setPageMargins(QtCore.QMarginsF(0, 0, 0, 0))
        else:
            from PySide import QtSvg

            device = QtSvg.QSvgGenerator()
            device.setFileName(partial)
            device.setSize(QtCore.QSize(*size))
            device.setViewBox(box)
        painter = QtGui.QPainter(device)
        if not painter.isActive():
            raise OSError(f"{path}: cannot be written")
        try:
            paint_it(painter, box)
        finally:
            painter.end()
        if ending == "png" and not device.save(partial):
            raise OSError(f"{path}: cannot be written")
        os.replace(partial, path)
    finally:
        if os.path.exists(partial):
            os.remove(partial)


def _set_page(device: Any, size: Any) -> None:
    """Size in pixels of 1/96 inch; Qt 6 has no other way than the one that PySide2 cannot take."""
    inches = QtCore.QSizeF(size[0] / 96.0, size[1] / 96.0)
    if hasattr(device, "setPageSizeMM"):
        device.setPageSizeMM(25.4 * inches)
    else:
        device.setPageSize(QtGui.QPageSize(inches, QtGui.QPageSize.Inch))


def paint(
    painter: Any,
    box: Any,
    document: Any,
    title: str,
    axes: bool,
    background: str,
    size: Any,
) -> None:
    """The document's 3D view into a QRectF, with a title above and axes along its bounds."""
    head = 0.06 * box.height() if title else 0.0
    if background == "White":
        painter.fillRect(box, QtGui.QColor("white"))
    inside = QtCore.QRectF(box.left(), box.top() + head, box.width(), box.height() - head)
    width, height = int(size[0]), max(int(size[1] * (1 - head / box.height())), 1)
    view = FreeCADGui.getDocument(document.Name).activeView()
    if not hasattr(view, "saveImage"):
        raise ValueError("There is no 3D view to take a picture of.")
    picked = FreeCADGui.Selection.getSelectionEx(document.Name)
    # What is picked is drawn in the colour of the selection, not in its own.
    FreeCADGui.Selection.clearSelection(document.Name)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "view.png")
        view.saveImage(path, width, height, background)
        image = QtGui.QImage(path)
    for pick in picked:
        FreeCADGui.Selection.addSelection(pick.Object, pick.SubElementNames)
    painter.drawImage(inside, image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    font = painter.font()
    if title:
        font.setPixelSize(max(int(0.6 * head), 8))
        font.setBold(True)
        painter.setFont(font)
        painter.setPen(QtGui.QColor(20, 30, 45))
        top = QtCore.QRectF(box.left(), box.top(), box.width(), head)
        painter.drawText(top, flags_value(QtCore.Qt.AlignCenter), title)
    if axes:
        font.setPixelSize(max(int(0.022 * box.height()), 8))
        painter.setFont(font)
        _paint_axes(painter, inside, view, document)


def _paint_axes(painter: Any, box: Any, view: Any, document: Any) -> None:
    bounds = _bounds(document)
    if bounds is None:
        return
    from pivy import coin  # only here: Coin takes a while to import

    low, high = bounds
    aspect = box.width() / box.height()
    volume = view.getCameraNode().getViewVolume(aspect)
    if aspect < 1.0:
        volume.scale(1.0 / aspect)

    def on_paper(place: np.ndarray) -> Any:
        x, y, _ = volume.projectToScreen(coin.SbVec3f(*(float(c) for c in place))).getValue()
        return QtCore.QPointF(box.left() + x * box.width(), box.bottom() - y * box.height())

    middle = on_paper(0.5 * (low + high))
    for axis in range(3):
        start, end = _outer_edge(axis, low, high, on_paper, middle)
        colour = QtGui.QColor(*_AXIS_COLOURS[axis])
        painter.setPen(QtGui.QPen(colour, max(0.002 * box.height(), 1.0)))
        painter.drawLine(on_paper(start), on_paper(end))
        for share in np.linspace(0.0, 1.0, 5):
            place = start + share * (end - start)
            text = f"{place[axis]:.4g}"
            if share in (0.0, 0.5, 1.0):
                words = f"{'xyz'[axis]} = {text}" if share == 0.5 else text
                _write(painter, box, on_paper(place), middle, words)
            painter.drawEllipse(on_paper(place), 2.0, 2.0)


def _outer_edge(
    axis: int, low: np.ndarray, high: np.ndarray, on_paper: Any, middle: Any
) -> Tuple[np.ndarray, np.ndarray]:
    """Of the bounds' four edges along the axis the one farthest out on the paper, lower or left."""
    best, found = -1.0, (low, high)
    others = [n for n in range(3) if n != axis]
    for corner in ((a, b) for a in (0, 1) for b in (0, 1)):
        start = low.copy()
        start[others] = [(low, high)[c][n] for c, n in zip(corner, others)]
        end = start.copy()
        end[axis] = high[axis]
        half = on_paper(0.5 * (start + end)) - middle
        # As far out, the lower and then the left one.
        far = (half.x() ** 2 + half.y() ** 2) ** 0.5 + 0.01 * half.y() - 0.005 * half.x()
        if far > best:
            best, found = far, (start, end)
    return found


def _write(painter: Any, box: Any, place: Any, middle: Any, words: str) -> None:
    """Beside a place, on the side away from the middle."""
    away = place - middle
    length = max((away.x() ** 2 + away.y() ** 2) ** 0.5, 1e-9)
    shift = 0.03 * box.height() / length
    at = QtCore.QPointF(place.x() + shift * away.x(), place.y() + shift * away.y())
    frame = QtCore.QRectF(at.x() - 100, at.y() - 20, 200, 40)
    painter.drawText(frame, flags_value(QtCore.Qt.AlignCenter), words)


def _bounds(document: Any) -> Optional[Any]:
    """Lowest and highest coordinates of what is seen."""
    found = FreeCAD.BoundBox()
    for obj in document.Objects:
        if obj.ViewObject is None or not obj.ViewObject.isVisible():
            continue
        proxy = getattr(obj, "Proxy", None)
        if hasattr(proxy, "mesh"):
            points = proxy.mesh(obj).points
            for place in (points.min(axis=0), points.max(axis=0)) if len(points) else ():
                found.add(FreeCAD.Vector(*place))
        elif hasattr(obj, "Shape") and not obj.Shape.isNull():
            found.add(obj.Shape.BoundBox)
    if not found.isValid():
        return None
    low = np.array((found.XMin, found.YMin, found.ZMin))
    return low, np.array((found.XMax, found.YMax, found.ZMax))
