# SPDX-License-Identifier: LGPL-2.1-or-later
"""StructuredMesh in the tree and the 3D view."""

from __future__ import annotations

from typing import Any, List

from .base import ViewProvider, set_face_colour


class StructuredMeshView(ViewProvider):
    icon_name = "nmgs_structured_mesh"
    panel = ("structured_mesh", "StructuredMeshPanel")

    def dress(self, vobj: Any) -> None:
        set_face_colour(vobj, 0.45, 0.70, 0.90)
        vobj.BackfaceCulling = False

    def claimChildren(self) -> List[Any]:
        return [self.Object.Blocks] if self.Object.Blocks else []
