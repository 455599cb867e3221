# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notices that FEM asks for a mesh: an analysis takes it."""

from __future__ import annotations

from typing import Any, List

import FreeCAD


class _Watch:
    """FreeCAD's observer of documents; asks the members of a changed analysis to fill up."""

    def slotChangedObject(self, obj: Any, prop: str) -> None:
        if prop == "Group" and obj.isDerivedFrom("Fem::FemAnalysis"):
            for member in obj.Group:
                fill = getattr(getattr(member, "Proxy", None), "fill", None)
                if fill is not None and hasattr(member, "Data"):
                    fill(member)


_watches: List[_Watch] = []


def watch() -> None:
    """From now on; once is enough."""
    if not _watches:
        _watches.append(_Watch())
        FreeCAD.addDocumentObserver(_watches[0])
