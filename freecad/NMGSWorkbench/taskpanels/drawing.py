# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes as pictures by Qt's painter: for the shape library, the gallery and vector files.

Faces are painted from the farthest to the nearest (M. Newell, R. Newell, T. Sancha, A solution to
the hidden surface problem, 1972, without their splitting), which is exact enough for small convex
faces of one size.
"""

from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

import numpy as np
from PySide import QtCore, QtGui

from ..nmgs.block_model import BlockModel
from ..nmgs.mesh import Mesh
from ..nmgs.plot import Plot, PlotOptions, plot

_FACE = np.array((0.45, 0.68, 0.90))
_LIGHT = np.array((0.35, 0.25, 0.90))
_LIGHT = _LIGHT / np.linalg.norm(_LIGHT)


def isometric() -> np.ndarray:
    """(3, 3): rows are the view's right, up and towards-the-viewer axes."""
    towards = np.array((0.75, -1.0, 0.65))
    towards = towards / np.linalg.norm(towards)
    right = np.cross((0.0, 0.0, 1.0), towards)
    right = right / np.linalg.norm(right)
    return np.array((right, np.cross(towards, right), towards))


def paint(
    painter: Any,
    box: Any,
    drawn: Plot,
    view: np.ndarray,
    colours: Optional[Sequence[np.ndarray]] = None,
    pen: float = 1.0,
) -> Tuple[float, np.ndarray]:
    """Paints into a QRectF, as large as fits. view: as isometric() gives it. colours: (K, 3) of
    each of the plot's arrays of polygons. Returns the scale and the point of the box's middle."""
    places = drawn.points.astype(np.float64) @ view.T
    low, high = places.min(axis=0), places.max(axis=0)
    spread = np.maximum(high - low, 1e-12)
    scale = min(box.width() / spread[0], box.height() / spread[1]) * 0.96
    middle = 0.5 * (low + high)
    flat = np.empty((len(places), 2))
    flat[:, 0] = box.center().x() + scale * (places[:, 0] - middle[0])
    flat[:, 1] = box.center().y() - scale * (places[:, 1] - middle[1])
    painter.setPen(QtGui.QPen(QtGui.QColor(25, 40, 60), pen))
    depths, jobs = [], []
    for number, polygons in enumerate(drawn.polygons):
        if not len(polygons):
            continue
        corners = places[polygons]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, -1] - corners[:, 0])
        length = np.linalg.norm(normal, axis=1)
        length[length == 0] = 1.0
        shade = 0.55 + 0.45 * np.abs(normal @ _LIGHT) / length
        base = np.broadcast_to(_FACE, (len(polygons), 3)) if colours is None else colours[number]
        depths.append(corners[:, :, 2].mean(axis=1))
        jobs += list(zip(polygons, (255 * shade[:, None] * base).astype(int)))
    order = np.argsort(np.concatenate(depths), kind="stable") if depths else []
    for at in order:
        polygon, colour = jobs[at]
        painter.setBrush(QtGui.QColor(*(int(c) for c in colour)))
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(*flat[n]) for n in polygon]))
    if not depths:
        for a, b in drawn.lines:
            painter.drawLine(QtCore.QPointF(*flat[a]), QtCore.QPointF(*flat[b]))
    return scale, middle @ view


def picture(
    source: Any, options: PlotOptions = PlotOptions(), width: int = 96, height: int = 76
) -> Any:
    """A QPixmap of a Mesh, or of a BlockModel's mesh."""
    mesh: Mesh = source.generate() if isinstance(source, BlockModel) else source
    pixmap = QtGui.QPixmap(2 * width, 2 * height)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    paint(
        painter,
        QtCore.QRectF(4, 4, 2 * width - 8, 2 * height - 8),
        plot(mesh, options),
        isometric(),
    )
    painter.end()
    pixmap.setDevicePixelRatio(2.0)
    return pixmap
