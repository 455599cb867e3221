# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGenMesh in the tree and the 3D view."""

from __future__ import annotations

from .mesh_view import MeshView


class TetGenMeshView(MeshView):
    icon_name = "nmgs_tetgen_mesh"
    panel = ("tetgen_mesh", "TetGenMeshPanel")
    colour = (0.55, 0.80, 0.55)
