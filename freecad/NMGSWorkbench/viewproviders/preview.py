# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel draws into the 3D view while it is open; the document knows nothing of it."""

from __future__ import annotations

from typing import Any, Optional

import FreeCADGui


class Preview:
    """One node in the scene of a document's 3D view; replaced by show, taken away by clear."""

    def __init__(self, document: Any):
        # FreeCAD 1.0 hands its scene out only when Coin's Python side has been loaded.
        from pivy import coin  # noqa: F401  only here: it takes a while to import

        view = FreeCADGui.getDocument(document.Name).activeView()
        self._scene: Any = view.getSceneGraph() if hasattr(view, "getSceneGraph") else None
        self.node: Any = None

    def show(self, node: Optional[Any]) -> None:
        from .scene_nodes import remove, unpickable  # only here: Coin takes a while to import

        remove(self._scene, self.node)
        self.node = node
        if node is not None and self._scene is not None:
            node.insertChild(unpickable(), 0)
            self._scene.addChild(node)

    def clear(self) -> None:
        self.show(None)
