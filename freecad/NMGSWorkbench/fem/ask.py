# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notices that FEM asks for a mesh, when an analysis takes it: large meshes fill up, and FEM then
finds the nodes of picked faces by their groups."""

from __future__ import annotations

from typing import Any, List

import FreeCAD


class _Watch:
    """FreeCAD's observer of documents; asks the members of a changed analysis to fill up."""

    def slotChangedObject(self, obj: Any, prop: str) -> None:
        if prop == "Group" and obj.isDerivedFrom("Fem::FemAnalysis"):
            from .picked import install  # only here: it imports FEM, which is there by now

            install()
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
