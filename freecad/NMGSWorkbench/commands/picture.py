# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .panel import PanelCommand


class Picture(PanelCommand):
    icon_name = "nmgs_picture"
    menu_text = "Picture"
    tooltip = "The 3D view as PNG, PDF, SVG or on paper, with a title and axes"
    accel = "N, I"
    panel_name = ("picture", "PicturePanel")

    def ready(self) -> bool:
        return hasattr(FreeCADGui.ActiveDocument.ActiveView, "saveImage")

    def argument(self) -> Any:
        return FreeCAD.ActiveDocument
