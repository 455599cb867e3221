# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a file becomes objects of a document, the same for all importers."""

from __future__ import annotations

import os
from typing import Any, Callable

import FreeCAD

#: (document, path) -> the new object
Maker = Callable[[Any, str], Any]


def _show(filename: str, error: BaseException) -> None:
    # The window's own File > Open has no more for an importer's error than a traceback in a log.
    if FreeCAD.GuiUp:
        from .taskpanels.messages import show_error

        show_error(f"Cannot open {os.path.basename(filename)}", error)


def new_document(filename: str, make: Maker) -> Any:
    """A new document with the object. On an error no document is left; raises what make raises."""
    title = os.path.splitext(os.path.basename(filename))[0]
    document = FreeCAD.newDocument(title)
    document.Label = title
    try:
        make(document, filename)
    except BaseException as error:
        FreeCAD.closeDocument(document.Name)
        _show(filename, error)
        raise
    document.recompute()
    return document


def document(filename: str, name: str, make: Maker) -> Any:
    """The object, added to the document as one undo step; on an error nothing is added."""
    target = FreeCAD.getDocument(name)
    target.openTransaction(f"Import {os.path.basename(filename)}")
    try:
        obj = make(target, filename)
    except BaseException as error:
        target.abortTransaction()
        _show(filename, error)
        raise
    target.commitTransaction()
    target.recompute()
    return obj
