# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors in words, with the culprits selected. Never blocks: a script goes on."""

from __future__ import annotations

import traceback
from typing import Any, List, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..objects import preferences


def show_error(title: str, error: BaseException) -> Any:
    """A message box that does not block; the report view gets the text as well. Returns the box."""
    from ..nmgs.errors import Error  # only here: it imports NumPy and Part

    expected = isinstance(error, (Error, ValueError, TypeError, OSError))
    text = str(error) or type(error).__name__
    if not expected:
        text = f"{type(error).__name__}: {text}\nThis is a fault of the NMGS workbench."
        trace = traceback.format_exception(type(error), error, error.__traceback__)
        FreeCAD.Console.PrintLog("".join(trace))
    FreeCAD.Console.PrintError(f"{title}: {text}\n")
    return _box(title, text, _reasons(error))


def report_left_out(title: str, obj: Any) -> Any:
    """The same for faces or solids that a fit had to leave out; None when there are none."""
    left_out = [line for line in obj.Report if ": left out, " in line]
    if not left_out:
        return None
    text = f"{len(left_out)} of {len(obj.Report)} could not be used; {obj.Label} has the others."
    FreeCAD.Console.PrintWarning("\n".join([f"{title}: {text}", *left_out]) + "\n")
    return _box(title, text, left_out)


def warn_of_quality(title: str, obj: Any) -> None:
    """A line in the report view when the mesh's worst element is below the preference."""
    worst, bar = obj.WorstScaledJacobian, preferences.warn_below()
    if obj.ElementCount and worst < bar:
        FreeCAD.Console.PrintWarning(
            f"{title}: the worst scaled Jacobian of {obj.Label} is {worst:.3g}, below {bar:.3g}\n"
        )


def _box(title: str, text: str, details: Sequence[str]) -> Any:
    box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName("NMGS_Message")
    box.setWindowTitle("NMGS")
    box.setIcon(QtGui.QMessageBox.Warning)
    box.setText(f"{title}\n\n{text}")
    if details:
        box.setDetailedText("\n".join(details))
    box.finished.connect(box.deleteLater)
    box.open()
    return box


def _reasons(error: BaseException) -> List[str]:
    names = getattr(error, "entities", ())
    reasons = getattr(error, "reasons", ())
    return [f"{name}: {reason}" for name, reason in zip(names, reasons)]
