# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot options."""

from __future__ import annotations

from typing import Any

from . import selection
from .panel import PanelCommand


class PlotOptions(PanelCommand):
    icon_name = "nmgs_plot"
    menu_text = "Plot options"
    tooltip = (
        "How the picked mesh is shown: split, by block directions, cut, shrunk, coloured by quality"
    )
    accel = "N, O"
    panel_name = ("plot", "PlotPanel")

    def ready(self) -> bool:
        return bool(selection.picked(selection.MESH) or selection.picked(selection.BLOCKS))

    def argument(self) -> Any:
        found = selection.picked(selection.MESH) or selection.picked(selection.BLOCKS)
        if not found:
            raise ValueError("Pick a mesh or blocks.")
        return found[0]
