# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is picked that can cut a solid."""

from __future__ import annotations

from typing import Any, List, Tuple

import FreeCADGui


def _faces(pick: Any) -> List[str]:
    return [name for name in pick.SubElementNames if name.startswith("Face")]


def faces_of(obj: Any) -> List[str]:
    """The names of obj's picked faces."""
    picks = FreeCADGui.Selection.getSelectionEx()
    return [name for pick in picks if pick.Object == obj for name in _faces(pick)]


def cutting_picks() -> List[Tuple[Any, str]]:
    """(object, face) of each picked face; (object, "") of each object picked as a whole that is a
    plane or has faces and no solid."""
    tools: List[Tuple[Any, str]] = []
    for pick in FreeCADGui.Selection.getSelectionEx():
        tools += [(pick.Object, name) for name in _faces(pick)]
        if pick.SubElementNames:
            continue
        shape = getattr(pick.Object, "Shape", None)
        if pick.Object.isDerivedFrom("App::Plane") or (
            shape is not None and shape.Faces and not shape.Solids
        ):
            tools.append((pick.Object, ""))
    return tools
