# SPDX-License-Identifier: LGPL-2.1-or-later
"""A histogram that is drawn, and clicked."""

from __future__ import annotations

from typing import Any, Callable, Optional, Sequence

import numpy as np
from PySide import QtCore, QtGui

from .base import flags_value

_MARGIN = 34
_BASE = 26
_TOP = 14


class Histogram(QtGui.QWidget):
    """Bars of counts (K,) over edges (K + 1,). chosen: called with a bar's number on a click."""

    def __init__(self, parent: Any, chosen: Callable[[int], Any]):
        super().__init__(parent)
        self._chosen = chosen
        self._counts: Sequence[int] = ()
        self._edges: Sequence[float] = ()
        self._colours: Optional[np.ndarray] = None
        self.selected = -1
        self.setObjectName("bars")
        self.setMouseTracking(True)

    def show_counts(self, counts: Any, edges: Any, colours: Optional[np.ndarray] = None) -> None:
        """colours: (K, 3), 0 to 1, of the bars."""
        self._counts, self._edges = [int(c) for c in counts], [float(e) for e in edges]
        self._colours = colours
        self.selected = -1
        self.update()

    def bar(self, number: int) -> Any:
        """The QRectF of a bar; one element alone is still seen."""
        width = (self.width() - _MARGIN - 8) / max(len(self._counts), 1)
        room = self.height() - _BASE - _TOP
        height = room * self._counts[number] / max(max(self._counts), 1)
        if self._counts[number]:
            height = max(height, 3.0)
        left = _MARGIN + number * width
        return QtCore.QRectF(left + 1, _TOP + room - height, width - 2, height)

    def at(self, x: float) -> int:
        """The bar at an x of the widget, -1 for none. The whole column counts."""
        for number in range(len(self._counts)):
            box = self.bar(number)
            if box.left() <= x <= box.right():
                return number
        return -1

    def mousePressEvent(self, event: Any) -> None:
        number = self.at(event.pos().x())
        self.selected = number
        self.update()
        self._chosen(number)

    def mouseMoveEvent(self, event: Any) -> None:
        number = self.at(event.pos().x())
        text = ""
        if number >= 0:
            low, high = self._edges[number : number + 2]
            text = f"{low:.4g} … {high:.4g}: {self._counts[number]}"
        self.setToolTip(text)

    def paintEvent(self, event: Any) -> None:
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        font = painter.font()
        font.setPointSizeF(max(font.pointSizeF() - 2, 6))
        painter.setFont(font)
        ink = self.palette().color(QtGui.QPalette.WindowText)
        base = self.height() - _BASE
        for number, count in enumerate(self._counts):
            box = self.bar(number)
            colour = QtGui.QColor(70, 130, 200)
            if self._colours is not None:
                colour = QtGui.QColor.fromRgbF(*(float(c) for c in self._colours[number]))
            painter.setPen(QtGui.QPen(ink, 2.0 if number == self.selected else 0.6))
            painter.setBrush(colour)
            if count:
                painter.drawRect(box)
                painter.setPen(ink)
                above = QtCore.QRectF(box.left() - 20, box.top() - _TOP, box.width() + 40, _TOP)
                painter.drawText(above, flags_value(QtCore.Qt.AlignCenter), str(count))
        painter.setPen(ink)
        painter.drawLine(_MARGIN, base, self.width() - 8, base)
        self._write_edges(painter, base)
        painter.end()

    def _write_edges(self, painter: Any, base: float) -> None:
        if not self._counts:
            return
        width = (self.width() - _MARGIN - 8) / len(self._counts)
        every = max(1, int(np.ceil(46 / max(width, 1))))
        for number in range(0, len(self._edges), every):
            box = QtCore.QRectF(_MARGIN + number * width - 30, base + 3, 60, _BASE - 4)
            text = f"{self._edges[number]:.3g}"
            painter.drawText(box, flags_value(QtCore.Qt.AlignHCenter | QtCore.Qt.AlignTop), text)
