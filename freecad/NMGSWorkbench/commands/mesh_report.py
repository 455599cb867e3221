# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh report."""

from __future__ import annotations

from typing import Any

from . import selection
from .panel import PanelCommand


class MeshReport(PanelCommand):
    icon_name = "nmgs_mesh_report"
    menu_text = "Mesh report"
    tooltip = "Counts, bounds, volume and quality of the picked mesh, with its worst elements"
    accel = "N, R"
    panel_name = ("report", "ReportPanel")

    def ready(self) -> bool:
        return bool(selection.picked(selection.MESH))

    def argument(self) -> Any:
        found = selection.picked(selection.MESH)
        if not found:
            raise ValueError("Pick a mesh.")
        return found[0]
