# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 3D view's camera: to a place, and where it looks from."""

from __future__ import annotations

from typing import Any, Optional

import FreeCADGui
import numpy as np
from pivy import coin


def zoom_to(points: np.ndarray, document: Any, slack: float = 1.6) -> None:
    """Shows the points (N, 3) and `slack` times as much round them, from where the view looks."""
    view = _view(document)
    if view is None or not len(points):
        return
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = 0.5 * (low + high), max(0.5 * slack * float((high - low).max()), 1e-9)
    box = coin.SbBox3f(*(float(c) for c in middle - half), *(float(c) for c in middle + half))
    view.getCameraNode().viewBoundingBox(box, 1.0, 1.0)


def axes(document: Any) -> Optional[np.ndarray]:
    """(3, 3): the view's right, up and towards-the-viewer axes; None without a 3D view."""
    view = _view(document)
    if view is None:
        return None
    turn = view.getCameraNode().orientation.getValue()
    rows = [
        turn.multVec(coin.SbVec3f(*axis)).getValue() for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    ]
    return np.array(rows, dtype=np.float64)


def _view(document: Any) -> Any:
    view = FreeCADGui.getDocument(document.Name).activeView()
    return view if hasattr(view, "getCameraNode") else None
