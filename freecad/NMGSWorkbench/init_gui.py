# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench as FreeCAD's window knows it: names only, the rest when it is chosen."""

import FreeCADGui

from .resources import icon


class NMGSWorkbench(FreeCADGui.Workbench):
    MenuText = "NMGS"
    ToolTip = "Structured hexahedral meshes from blocks, TetGen meshes, and their way into FEM"
    Icon = icon("nmgs_workbench")

    def Initialize(self) -> None:
        from .commands import register

        names = register()
        self.appendToolbar("NMGS", names)
        self.appendMenu("NMGS", names)

    def ContextMenu(self, recipient: str) -> None:
        from .commands import names_for_context_menu

        names = names_for_context_menu()
        if names:
            self.appendContextMenu("NMGS", names)

    def GetClassName(self) -> str:
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(NMGSWorkbench())
