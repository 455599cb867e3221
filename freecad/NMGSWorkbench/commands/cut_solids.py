# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut solids by picked faces, or open the panel that proposes where."""

from __future__ import annotations

from typing import Any, List, Tuple

import FreeCADGui

from ..taskpanels import messages
from . import selection
from .base import Command


class CutSolids(Command):
    accel = "N, C"
    icon_name = "nmgs_cut_solids"
    menu_text = "Cut solids"
    tooltip = (
        "Cut picked solids into pieces that blocks fill: by the faces and planes picked with them, "
        "or where it is proposed"
    )

    def ready(self) -> bool:
        return selection.can_pick("Solid") or bool(_fitted_blocks())

    def Activated(self, index: int = 0) -> None:
        if self._tools() and not _fitted_blocks():
            super().Activated(index)
            return
        from ..taskpanels import cuts  # only here: it imports NumPy and Part

        try:
            blocks = _fitted_blocks()
            if blocks:
                panel = cuts.open_for(blocks[0])
            else:
                panel = cuts.CutsPanel(source=self._source())
        except Exception as error:
            messages.show_error(self.menu_text, error)
        else:
            FreeCADGui.Control.showDialog(panel)

    def act(self, document: Any) -> Any:
        from ..objects import cut_solids  # only here: it imports NumPy and Part

        obj = cut_solids.make(document)
        obj.Source = self._source()
        obj.Tools = self._tools()
        self.computed(obj)
        for part, _ in obj.Source:
            part.Visibility = False
        return obj

    def _source(self) -> selection.Source:
        """Solids picked as such or as whole objects; else those that own the picked faces."""
        whole = [entry for entry in selection.picked_solids() if not _faces_of(entry[0])]
        source = whole or selection.picked_solids()
        if not source:
            raise ValueError("Pick one or more solids, and faces or planes that cut them.")
        return source

    def _tools(self) -> List[Tuple[Any, str]]:
        """Picked faces, and picked objects without solids that have faces or are planes."""
        tools: List[Tuple[Any, str]] = []
        for pick in FreeCADGui.Selection.getSelectionEx():
            tools += [(pick.Object, name) for name in _faces_of(pick.Object)]
            if pick.SubElementNames:
                continue
            shape = getattr(pick.Object, "Shape", None)
            if pick.Object.isDerivedFrom("App::Plane") or (
                shape is not None and shape.Faces and not shape.Solids
            ):
                tools.append((pick.Object, ""))
        return tools


def _faces_of(obj: Any) -> List[str]:
    """The names of obj's picked faces."""
    return [
        name
        for pick in FreeCADGui.Selection.getSelectionEx()
        if pick.Object == obj
        for name in pick.SubElementNames
        if name.startswith("Face")
    ]


def _fitted_blocks() -> List[Any]:
    """Picked Blocks that were fitted to solids."""
    return [
        obj
        for obj in selection.picked(selection.BLOCKS)
        if obj.Source and obj.Proxy.nodes_per_element == 20
    ]
