# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export."""

from __future__ import annotations

from typing import Any

from . import selection
from .panel import PanelCommand


class Export(PanelCommand):
    icon_name = "nmgs_export"
    menu_text = "Export"
    tooltip = "Write the picked blocks or mesh to a file: N2S, N3S, N2R, N3R, TetGen, FEM formats"
    accel = "N, E"
    panel_name = ("export", "ExportPanel")

    def ready(self) -> bool:
        return len(selection.picked(selection.ANY)) == 1

    def argument(self) -> Any:
        found = selection.picked(selection.ANY)
        if len(found) != 1:
            raise ValueError("Pick one mesh, Blocks, Patches or PLC object.")
        return found[0]
