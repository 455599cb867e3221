# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: texts, one undo step, errors in words."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import FreeCAD
import FreeCADGui

from ..objects import stale
from ..resources import icon
from ..taskpanels import messages


class Command:
    """Base. A subclass sets the texts and writes ready() and act(document)."""

    icon_name = ""
    menu_text = ""
    tooltip = ""
    #: Keys, FreeCAD's way to write them; "" for none.
    accel = ""
    #: Elements that are to blame for the last error.
    culprits: List[Tuple[Any, str]] = []

    def GetResources(self) -> Dict[str, str]:
        return {
            "Pixmap": icon(self.icon_name),
            "MenuText": self.menu_text,
            "ToolTip": self.tooltip,
            "StatusTip": self.tooltip,
            "WhatsThis": self.tooltip,
            "Accel": self.accel,
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

    def computed(self, obj: Any) -> Any:
        """obj, computed. Raises what its computation raised."""
        sources = [source for source in obj.OutList if "Touched" in source.State]
        if sources:
            with stale.forced():
                obj.Document.recompute(sources)
        try:
            stale.compute(obj)
        except Exception as error:
            self.culprits = obj.Proxy.culprits(getattr(error, "entities", ()))
            raise
        return obj

    def Activated(self, index: int = 0) -> None:
        from ..nmgs.errors import Cancelled  # only here: it imports NumPy and Part

        document = FreeCAD.ActiveDocument
        self.culprits = []
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
            from ..taskpanels import culprits  # only here: it imports NumPy

            culprits.point_out(self.culprits, error)
        else:
            document.commitTransaction()
            if made is not None:
                _select([(made, "")])


def _select(entities: List[Tuple[Any, str]]) -> None:
    FreeCADGui.Selection.clearSelection()
    for obj, name in entities:
        FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)
