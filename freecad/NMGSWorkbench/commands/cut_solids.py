# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut solids by picked faces, or open the panel that proposes where."""

from __future__ import annotations

from typing import Any, List

from ..taskpanels.cutting_picks import cutting_picks, faces_of
from . import selection
from .base import Command
from .panel import PanelCommand


class CutSolids(PanelCommand):
    accel = "N, C"
    icon_name = "nmgs_cut_solids"
    menu_text = "Cut solids"
    tooltip = (
        "Cut picked solids into pieces that blocks fill: by the faces and planes picked with them, "
        "or where it is proposed"
    )
    panel_name = ("cuts", "panel_for")

    def ready(self) -> bool:
        return selection.can_pick("Solid") or bool(_fitted_blocks())

    def Activated(self, index: int = 0) -> None:
        if cutting_picks() and not _fitted_blocks():
            Command.Activated(self, index)
        else:
            super().Activated(index)

    def argument(self) -> Any:
        blocks = _fitted_blocks()
        return blocks[0] if blocks else _source()

    def act(self, document: Any) -> Any:
        from ..objects import cut_solids  # only here: it imports NumPy and Part

        obj = cut_solids.make(document)
        obj.Source = _source()
        obj.Tools = cutting_picks()
        self.computed(obj)
        for part, _ in obj.Source:
            part.Visibility = False
        return obj


def _source() -> selection.Source:
    """Solids picked as such or as whole objects; else those that own the picked faces."""
    found = selection.picked_solids()
    if not found:
        raise ValueError("Pick one or more solids, and faces or planes that cut them.")
    return [entry for entry in found if not faces_of(entry[0])] or found


def _fitted_blocks() -> List[Any]:
    """Picked Blocks that were fitted to solids."""
    return [
        obj
        for obj in selection.picked(selection.BLOCKS)
        if obj.Source and obj.Proxy.nodes_per_element == 20
    ]
