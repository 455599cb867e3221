# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh report."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from ..objects.mesh_base import MeshObject
from . import selection
from .base import Command


class MeshReport(Command):
    icon_name = "nmgs_mesh_report"
    menu_text = "Mesh report"
    tooltip = "Counts, bounds, volume and quality of the picked mesh, with its worst elements"

    def ready(self) -> bool:
        return bool(selection.picked(MeshObject))

    def act(self, document: Any) -> Any:
        from ..taskpanels.report import ReportPanel

        found = selection.picked(MeshObject)
        if not found:
            raise ValueError("Pick a mesh.")
        FreeCADGui.Control.showDialog(ReportPanel(found[0]))
        return None
