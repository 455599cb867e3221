# SPDX-License-Identifier: LGPL-2.1-or-later
"""Help."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .base import Command


class Help(Command):
    icon_name = "nmgs_help"
    menu_text = "NMGS user guide"
    tooltip = "The user guide: from a part to a mesh, every panel, file formats, the console"
    accel = "N, F1"

    def IsActive(self) -> bool:
        return True

    def Activated(self, index: int = 0) -> Any:
        from ..taskpanels.guide import show  # only here: the window is not needed before

        show(FreeCADGui.getMainWindow())
