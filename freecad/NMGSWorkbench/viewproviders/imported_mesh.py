# SPDX-License-Identifier: LGPL-2.1-or-later
"""ImportedMesh in the tree and the 3D view."""

from __future__ import annotations

from .mesh_view import MeshView


class ImportedMeshView(MeshView):
    icon_name = "nmgs_structured_mesh"
    panel = ("", "")
    colour = (0.70, 0.70, 0.75)
