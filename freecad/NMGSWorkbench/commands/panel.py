# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that open a panel, which makes its own undo steps."""

from __future__ import annotations

import importlib
from typing import Any, Tuple

import FreeCAD
import FreeCADGui

from ..taskpanels import messages
from .base import Command


class PanelCommand(Command):
    """A subclass sets panel_name (module, class in taskpanels) and writes argument()."""

    panel_name: Tuple[str, str] = ("", "")

    def argument(self) -> Any:
        """What the panel is made for. Raises ValueError in words."""
        raise NotImplementedError

    def Activated(self, index: int = 0) -> None:
        from ..nmgs.errors import Cancelled  # only here: it imports NumPy and Part

        package = __package__.rpartition(".")[0]
        try:
            module = importlib.import_module(f"{package}.taskpanels.{self.panel_name[0]}")
            panel = getattr(module, self.panel_name[1])(self.argument())
        except Cancelled:
            FreeCAD.Console.PrintMessage(f"{self.menu_text}: cancelled\n")
        except Exception as error:
            messages.show_error(self.menu_text, error)
        else:
            FreeCADGui.Control.showDialog(panel)


class NewCommand(PanelCommand):
    """Opens a panel that makes something new; makes a document for it where there is none."""

    def ready(self) -> bool:
        return True

    def IsActive(self) -> bool:
        return not FreeCADGui.Control.activeDialog()

    def argument(self) -> None:
        if FreeCAD.ActiveDocument is None:
            FreeCAD.newDocument()
        return None
