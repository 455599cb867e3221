# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generate mesh."""

from __future__ import annotations

from typing import Any

from ..taskpanels.messages import warn_of_quality
from . import selection
from .base import Command


class GenerateMesh(Command):
    accel = "N, G"
    icon_name = "nmgs_generate_mesh"
    menu_text = "Generate mesh"
    tooltip = (
        "Divide the picked patches into quads, the picked blocks into hexahedra, as a FEM mesh"
    )

    def ready(self) -> bool:
        return bool(selection.picked(selection.BLOCKS))

    def act(self, document: Any) -> Any:
        from ..objects import structured_mesh  # only here: it imports NumPy and Part

        made = None
        for blocks in selection.picked(selection.BLOCKS):
            made = structured_mesh.make(document)
            made.Blocks = blocks
            self.computed(made)
            warn_of_quality(self.menu_text, made)
            # The mesh would be covered with them.
            blocks.ViewObject.ShowCounts = False
            # The mesh lies in the surfaces of the part and would not be seen behind them.
            for part, _ in blocks.Source:
                part.Visibility = False
        if made is None:
            raise ValueError("Pick a Blocks or Patches object.")
        return made
