# SPDX-License-Identifier: LGPL-2.1-or-later
"""StructuredMesh in the tree and the 3D view."""

from __future__ import annotations

from .mesh_view import MeshView


class StructuredMeshView(MeshView):
    icon_name = "nmgs_structured_mesh"
    panel = ("structured_mesh", "StructuredMeshPanel")
    colour = (0.45, 0.70, 0.90)
