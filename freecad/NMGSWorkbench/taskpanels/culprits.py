# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows what an error is about: elements of the document selected, facets that are no elements
drawn red over everything until the selection changes or the next error comes."""

from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple

import FreeCADGui
import numpy as np

#: The scene that holds the drawn facets, and they.
_drawn: Optional[Tuple[Any, Any]] = None
_observer: Any = None
RED = (0.90, 0.10, 0.10)


class _Observer:
    """Whoever picks something else has seen it."""

    def addSelection(self, *_: Any) -> None:
        clear()

    def setSelection(self, *_: Any) -> None:
        clear()

    def clearSelection(self, *_: Any) -> None:
        clear()


def point_out(entities: Sequence[Tuple[Any, str]], error: BaseException) -> None:
    """entities: (object, element's name, or "" for the whole). error: its outlines, polygons of
    (n, 3) points, are drawn where there are no entities but whole objects."""
    clear()
    if entities:
        FreeCADGui.Selection.clearSelection()
        for obj, name in entities:
            FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)
    outlines = getattr(error, "outlines", ())
    if len(outlines) and not any(name for _, name in entities):
        _draw(outlines)


def drawn() -> bool:
    """Whether facets are drawn at present."""
    return _drawn is not None


def clear() -> None:
    """Removes the drawn facets."""
    global _drawn, _observer
    if _observer is not None:
        FreeCADGui.Selection.removeObserver(_observer)
        _observer = None
    if _drawn is not None:
        root, node = _drawn
        _drawn = None
        root.removeChild(node)


def _draw(outlines: Sequence[np.ndarray]) -> None:
    global _drawn, _observer
    document = FreeCADGui.activeDocument()
    view = document.activeView() if document is not None else None
    if view is None or not hasattr(view, "getSceneGraph"):
        return
    node = _node(outlines)  # before the scene, which FreeCAD 1.0 has only when Coin is loaded
    root = view.getSceneGraph()
    root.addChild(node)
    _drawn = root, node
    _observer = _Observer()
    FreeCADGui.Selection.addObserver(_observer)


def _node(outlines: Sequence[np.ndarray]) -> Any:
    from pivy import coin

    from ..viewproviders import scene_nodes

    separator = coin.SoSeparator()
    depth = coin.SoDepthBuffer()
    depth.test = False
    parts: List[Any] = [depth, scene_nodes.flat(), scene_nodes.pen(3)]
    parts.append(scene_nodes.coordinates(np.concatenate(outlines)))
    first = np.cumsum([0, *(len(ring) for ring in outlines)])
    for size in sorted({len(ring) for ring in outlines}):
        starts = np.array([first[i] for i, ring in enumerate(outlines) if len(ring) == size])
        rows = starts[:, None] + np.arange(size)
        if size > 2:
            parts += [scene_nodes.material(RED, 0.6), scene_nodes.faces(rows)]
        parts.append(scene_nodes.material(RED))
        parts.append(scene_nodes.lines(np.column_stack([rows, rows[:, :1]])))
    for part in parts:
        separator.addChild(part)
    return separator
