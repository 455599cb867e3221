# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stale marks: what depends on a change is marked until it is computed again.

By preference a recompute of the document computes it at once, or leaves it marked until it is
asked for by update().
"""

from __future__ import annotations

import contextlib
from typing import Any, Iterator, List

import FreeCAD

from . import preferences

_OUTPUT = 8  # App::Prop_Output: a change of it touches nothing
_forced = 0


def at_once() -> bool:
    """Whether a recompute computes what is stale; without a window it always does."""
    if _forced or not FreeCAD.GuiUp:
        return True
    return preferences.recompute_at_once()


@contextlib.contextmanager
def forced() -> Iterator[None]:
    """Within it, everything that is recomputed is computed."""
    global _forced
    _forced += 1
    try:
        yield
    finally:
        _forced -= 1


def add_property(obj: Any) -> None:
    """obj.Stale, read-only."""
    if "Stale" not in obj.PropertiesList:
        obj.addProperty(
            "App::PropertyBool", "Stale", "NMGS", "What it depends on has changed since", _OUTPUT
        )
        obj.setEditorMode("Stale", 1)


def mark(obj: Any, is_stale: bool) -> None:
    """Marks the object, and shows it."""
    if hasattr(obj, "Stale") and obj.Stale != is_stale:
        obj.Stale = is_stale
        view = getattr(obj.ViewObject, "Proxy", None) if FreeCAD.GuiUp else None
        if hasattr(view, "show_stale"):
            view.show_stale(obj.ViewObject)


def compute(obj: Any) -> None:
    """Computes one object now, whatever is preferred; raises what its computation does."""
    # Not by the document: that would write a traceback into the report view for each error.
    obj.Proxy.compute(obj)
    obj.purgeTouched()
    mark(obj, False)


def update(document: Any) -> List[Any]:
    """Computes what is stale, what it depends on first. Returns these objects."""
    found = [obj for obj in document.Objects if getattr(obj, "Stale", False)]
    for obj in found:
        obj.touch()
    with forced():
        document.recompute()
    return found


class _Watch:
    """FreeCAD's observer of documents."""

    def slotChangedObject(self, obj: Any, prop: str) -> None:
        document = obj.Document
        # What changes while a document is opened, or by a recompute, is not a change of the user.
        if prop in _NO_INPUT or document is None or document.Restoring or document.Recomputing:
            return
        if "Touched" not in obj.State:
            return
        if hasattr(obj, "Stale"):
            mark(obj, bool(getattr(obj, "ElementCount", 0)))
        for follower in obj.InListRecursive:
            if hasattr(follower, "Stale"):
                mark(follower, bool(getattr(follower, "ElementCount", 0)))


_NO_INPUT = frozenset(
    (
        ("Stale", "Visibility", "Label", "Label2", "ExpressionEngine", "Proxy", "Content", "Data")
        + ("FemMesh", "NodeCount", "ElementCount", "Elements", "WorstScaledJacobian", "Report")
        + ("ReportData", "SchemaVersion")
    )
)
_watches: List[_Watch] = []


def watch() -> None:
    """From now on; once is enough."""
    if not _watches:
        _watches.append(_Watch())
        FreeCAD.addDocumentObserver(_watches[0])
