# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: texts, one undo step, errors in words."""

from __future__ import annotations

from typing import Any, Dict

import FreeCAD
import FreeCADGui

from ..nmgs.errors import Cancelled
from ..resources import icon
from ..taskpanels import messages


class Command:
    """Base. A subclass sets the texts and writes ready() and act(document)."""

    icon_name = ""
    menu_text = ""
    tooltip = ""

    def GetResources(self) -> Dict[str, str]:
        return {
            "Pixmap": icon(self.icon_name),
            "MenuText": self.menu_text,
            "ToolTip": self.tooltip,
            "StatusTip": self.tooltip,
        }

    def IsActive(self) -> bool:
        return (
            FreeCAD.ActiveDocument is not None
            and not FreeCADGui.Control.activeDialog()
            and self.ready()
        )

    def ready(self) -> bool:
        """Whether what is picked is something that the command can act on."""
        raise NotImplementedError

    def act(self, document: Any) -> Any:
        """Does it; returns the new document object, which is selected, or None."""
        raise NotImplementedError

    def Activated(self, index: int = 0) -> None:
        document = FreeCAD.ActiveDocument
        document.openTransaction(self.menu_text)
        try:
            made = self.act(document)
        except Cancelled:
            document.abortTransaction()
            FreeCAD.Console.PrintMessage(f"{self.menu_text}: cancelled\n")
        except Exception as error:
            # Whatever went wrong, the document is as it was before and the user reads why.
            document.abortTransaction()
            messages.show_error(self.menu_text, error)
        else:
            document.commitTransaction()
            if made is not None:
                FreeCADGui.Selection.clearSelection()
                FreeCADGui.Selection.addSelection(made)


def computed(obj: Any) -> Any:
    """obj, recomputed. Raises what its recompute raised."""
    obj.Document.recompute([obj])
    if obj.Proxy.failure is not None:
        raise obj.Proxy.failure
    return obj
