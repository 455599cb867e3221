# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench as FreeCAD's window knows it: names only, the rest when it is chosen."""

import FreeCADGui

from .resources import TRANSLATIONS, icon, icons, ui


class NMGSWorkbench(FreeCADGui.Workbench):
    MenuText = "NMGS"
    ToolTip = "Structured hexahedral meshes from blocks, TetGen meshes, and their way into FEM"
    Icon = icon("nmgs_workbench")

    def Initialize(self) -> None:
        from .commands import register, toolbar

        menu = register()
        self.appendToolbar("NMGS", toolbar())
        self.appendMenu("NMGS", menu)

    def ContextMenu(self, recipient: str) -> None:
        from .commands import names_for_context_menu

        names = names_for_context_menu()
        if names:
            self.appendContextMenu("NMGS", names)

    def GetClassName(self) -> str:
        return "Gui::PythonWorkbench"


FreeCADGui.addLanguagePath(TRANSLATIONS)
FreeCADGui.updateLocale()
FreeCADGui.addIconPath(icons())
FreeCADGui.addPreferencePage(ui("preferences"), "NMGS")
FreeCADGui.addWorkbench(NMGSWorkbench())
