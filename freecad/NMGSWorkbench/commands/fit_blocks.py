# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fit blocks to solids."""

from __future__ import annotations

from typing import Any

from . import selection
from ..taskpanels.messages import report_left_out
from .base import Command


class FitBlocks(Command):
    accel = "N, B"
    icon_name = "nmgs_fit_blocks"
    menu_text = "Fit blocks to solids"
    tooltip = "Fill the picked solids, or the solids that own the picked faces, with 20-node blocks"

    def ready(self) -> bool:
        return selection.can_pick("Solid")

    def act(self, document: Any) -> Any:
        from ..objects import blocks  # only here: it imports NumPy and Part

        source = selection.picked_solids()
        if not source:
            raise ValueError("Pick one or more solids, or a face of each.")
        obj = blocks.make(document)
        obj.Source = source
        self.computed(obj)
        # The blocks are inside the solids and would not be seen.
        for part, _ in source:
            part.Visibility = False
        report_left_out(self.menu_text, obj)
        return obj
