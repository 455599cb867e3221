# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut solids in the tree and the 3D view."""

from __future__ import annotations

from typing import Any, List

from .base import ViewProvider, set_face_colour


class CutSolidsView(ViewProvider):
    icon_name = "nmgs_cut_solids"
    panel = ("cuts", "CutsPanel")

    def dress(self, vobj: Any) -> None:
        set_face_colour(vobj, 0.72, 0.78, 0.86)

    def claimChildren(self) -> List[Any]:
        obj = getattr(self, "Object", None)
        return list(dict.fromkeys(target for target, _ in obj.Source)) if obj else []
