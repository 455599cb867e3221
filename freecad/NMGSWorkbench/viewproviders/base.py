# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all view providers share: icon, double click to the panel, nothing pickled."""

from __future__ import annotations

import importlib
from typing import Any, Callable, List, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtCore

from ..resources import icon
from ..taskpanels import progress

# A document that is opened before the workbench is chosen recomputes behind the dialog, too.
progress.install()


def set_face_colour(vobj: Any, red: float, green: float, blue: float) -> None:
    """Colour of the faces; FreeCAD 1.0 moved it from ShapeColor into ShapeAppearance."""
    if "ShapeColor" in vobj.PropertiesList:
        vobj.ShapeColor = (red, green, blue)
    elif "ShapeAppearance" in vobj.PropertiesList:
        vobj.ShapeAppearance = (FreeCAD.Material(DiffuseColor=(red, green, blue)),)


def face_colour(vobj: Any) -> Tuple[float, float, float]:
    """Colour of the faces, red, green, blue."""
    if "ShapeColor" in vobj.PropertiesList:
        return tuple(vobj.ShapeColor[:3])
    return tuple(vobj.ShapeAppearance[0].DiffuseColor[:3])


def later(job: Callable[[], Any]) -> None:
    """Does it when the window is idle, unless the object is gone by then."""

    def attempt() -> None:
        try:
            job()
        except ReferenceError:
            pass

    QtCore.QTimer.singleShot(0, attempt)


class ViewProvider:
    """Base. A subclass sets `icon_name`, and `panel` (module, class in taskpanels) or none."""

    icon_name = ""
    panel: Tuple[str, str] = ("", "")

    def __init__(self, vobj: Any):
        vobj.Proxy = self
        self.dress(vobj)

    def dress(self, vobj: Any) -> None:
        """Colours and widths of a new object; documents keep what the user sets later."""

    def attach(self, vobj: Any) -> None:
        self.Object = vobj.Object

    def getIcon(self) -> str:
        is_stale = getattr(getattr(self, "Object", None), "Stale", False)
        return icon(f"stale/{self.icon_name}" if is_stale else self.icon_name)

    def show_stale(self, vobj: Any) -> None:
        """The object's Stale has changed."""
        vobj.signalChangeIcon()

    def onChanged(self, vobj: Any, prop: str) -> None:
        """A property of the view changed."""

    def claimChildren(self) -> List[Any]:
        return []

    def doubleClicked(self, vobj: Any) -> bool:
        if not self.panel[0]:
            return False
        if FreeCADGui.Control.activeDialog():
            FreeCAD.Console.PrintWarning("NMGS: close the open task panel first.\n")
            return True
        FreeCADGui.getDocument(vobj.Object.Document).setEdit(vobj.Object.Name)
        return True

    def setEdit(self, vobj: Any, mode: int = 0) -> Any:
        if mode != 0 or not self.panel[0]:
            return None
        package = __package__.rpartition(".")[0]
        module = importlib.import_module(f"{package}.taskpanels.{self.panel[0]}")
        FreeCADGui.Control.showDialog(getattr(module, self.panel[1])(vobj.Object))
        return True

    def unsetEdit(self, vobj: Any, mode: int = 0) -> Any:
        if mode != 0:
            return None
        FreeCADGui.Control.closeDialog()
        return True

    # FreeCAD asks for these up to 0.21 and for dumps and loads from 0.21 on.
    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None
