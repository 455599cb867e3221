# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all panels of document objects share: OK is one undo step, Cancel leaves no trace."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PySide import QtGui

from ..nmgs.errors import Cancelled
from ..objects import stale
from ..resources import icon, ui
from . import culprits, messages


def flags_value(flags: Any) -> int:
    """Qt's flags as the number that FreeCAD and Qt's items ask for, in PySide2 and PySide6."""
    return flags.value if hasattr(flags, "value") else int(flags)


def ok_cancel() -> int:
    """The buttons of a panel that has no Apply, as FreeCAD asks for them."""
    box = QtGui.QDialogButtonBox
    return flags_value(box.Ok | box.Cancel)


def tell(form: Any, problem: str) -> None:
    """Words below a form's widgets; "" takes them away."""
    form.problem.setText(problem)
    form.problem.setVisible(bool(problem))


class Panel:
    """Base. A subclass sets the names and writes fill(), which shows the properties, and store(),
    which writes the widgets into them."""

    ui_name = ""
    icon_name = ""

    def __init__(self, obj: Any):
        self.obj = obj
        self.form = FreeCADGui.PySideUic.loadUi(ui(self.ui_name))
        self.form.setWindowTitle(obj.Label)
        self.form.setWindowIcon(QtGui.QIcon(icon(self.icon_name)))
        self._open = False
        self._was_touched = "Touched" in obj.State
        self.connect()
        self.fill()

    def connect(self) -> None:
        """Signals of widgets; once, while fill() may come again."""

    def fill(self) -> None:
        raise NotImplementedError

    def store(self) -> None:
        raise NotImplementedError

    def getStandardButtons(self) -> int:
        box = QtGui.QDialogButtonBox
        return flags_value(box.Ok | box.Apply | box.Cancel)

    def clicked(self, button: int) -> None:
        if flags_value(button) == flags_value(QtGui.QDialogButtonBox.Apply):
            self.apply()

    def apply(self) -> bool:
        """Widgets into properties and a recompute; False, with a message, when that fails."""
        document = self.obj.Document
        if not self._open:
            document.openTransaction(f"Edit {self.obj.Label}")
            self._open = True
        try:
            self.store()
            with stale.forced():
                document.recompute([self.obj])
            if self.obj.Proxy.failure is not None:
                raise self.obj.Proxy.failure
        except Cancelled:
            return False
        except Exception as error:
            messages.show_error(self.obj.Label, error)
            names = getattr(error, "entities", ())
            culprits.point_out(self.obj.Proxy.culprits(names), error)
            return False
        culprits.clear()
        # What depends on it follows at once; its own errors are marked in the tree.
        document.recompute()
        self.fill()
        return True

    def accept(self) -> bool:
        if not self.apply():
            return False
        self.obj.Document.commitTransaction()
        self._close()
        return True

    def reject(self) -> bool:
        if self._open:
            self.obj.Document.abortTransaction()
            if not self._was_touched:
                self.obj.purgeTouched()
        self._close()
        return True

    def _close(self) -> None:
        culprits.clear()
        FreeCADGui.getDocument(self.obj.Document).resetEdit()
