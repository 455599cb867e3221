# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGenMesh in the tree and the 3D view."""

from __future__ import annotations

from typing import Any

from .base import ViewProvider, set_face_colour


class TetGenMeshView(ViewProvider):
    icon_name = "nmgs_tetgen_mesh"
    panel = ("tetgen_mesh", "TetGenMeshPanel")

    def dress(self, vobj: Any) -> None:
        set_face_colour(vobj, 0.55, 0.80, 0.55)
        vobj.BackfaceCulling = False
