# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generate mesh."""

from __future__ import annotations

from typing import Any

from ..objects import structured_mesh
from ..objects.blocking import Blocking
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
        return bool(selection.picked(Blocking))

    def act(self, document: Any) -> Any:
        made = None
        for blocks in selection.picked(Blocking):
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
