# SPDX-License-Identifier: LGPL-2.1-or-later
"""About."""

from __future__ import annotations

from .base import Command


class About(Command):
    icon_name = "nmgs_workbench"
    menu_text = "About NMGS"
    tooltip = "Versions of the workbench and of everything that it is linked with"

    def IsActive(self) -> bool:
        return True

    def Activated(self, index: int = 0) -> None:
        from ..taskpanels.about import show  # only here: it loads the kernel

        show()
