# SPDX-License-Identifier: LGPL-2.1-or-later
"""ImportedMesh in the tree and the 3D view."""

from __future__ import annotations

from typing import Any, List

from .base import ViewProvider, set_face_colour


class ImportedMeshView(ViewProvider):
    icon_name = "nmgs_structured_mesh"
    panel = ("", "")

    def dress(self, vobj: Any) -> None:
        set_face_colour(vobj, 0.70, 0.70, 0.75)
        vobj.BackfaceCulling = False

    def claimChildren(self) -> List[Any]:
        return [self.Object.Blocks] if self.Object.Blocks else []
