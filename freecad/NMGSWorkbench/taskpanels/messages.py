# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors in words, with the culprits selected. Never blocks: a script goes on."""

from __future__ import annotations

import traceback
from typing import Any, List

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..nmgs.errors import Error


def show_error(title: str, error: BaseException) -> Any:
    """A message box that does not block; the report view gets the text as well. Returns the box."""
    expected = isinstance(error, (Error, ValueError, TypeError, OSError))
    text = str(error) or type(error).__name__
    if not expected:
        text = f"{type(error).__name__}: {text}\nThis is a fault of the NMGS workbench."
        trace = traceback.format_exception(type(error), error, error.__traceback__)
        FreeCAD.Console.PrintLog("".join(trace))
    FreeCAD.Console.PrintError(f"{title}: {text}\n")
    box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName("NMGS_Error")
    box.setWindowTitle("NMGS")
    box.setIcon(QtGui.QMessageBox.Warning)
    box.setText(title)
    box.setInformativeText(text)
    details = _reasons(error)
    if details:
        box.setDetailedText("\n".join(details))
    box.finished.connect(box.deleteLater)
    box.open()
    return box


def _reasons(error: BaseException) -> List[str]:
    names = getattr(error, "entities", ())
    reasons = getattr(error, "reasons", ())
    return [f"{name}: {reason}" for name, reason in zip(names, reasons)]
