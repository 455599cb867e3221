# SPDX-License-Identifier: LGPL-2.1-or-later
"""Static analysis of the picked mesh."""

from __future__ import annotations

from typing import Any, List

from . import selection
from .panel import PanelCommand

_VOLUMES = ("hexahedron", "tetra", "wedge", "pyramid")


class Analysis(PanelCommand):
    accel = "N, A"
    icon_name = "nmgs_analysis"
    menu_text = "Static analysis"
    tooltip = "Hold and load faces of the part that the picked mesh is on, and solve with CalculiX"
    panel_name = ("analysis", "AnalysisPanel")

    def ready(self) -> bool:
        return len(_volume_meshes()) == 1

    def argument(self) -> Any:
        found = _volume_meshes()
        if len(found) != 1:
            raise ValueError("Pick one mesh of hexahedra or tetrahedra.")
        return found[0]


def _volume_meshes() -> List[Any]:
    # A mesh of quads or triangles alone would need a thickness.
    return [
        mesh
        for mesh in selection.picked(selection.MESH)
        if any(line.startswith(_VOLUMES) for line in mesh.Elements)
    ]
