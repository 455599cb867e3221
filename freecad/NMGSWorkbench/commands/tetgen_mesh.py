# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen mesh."""

from __future__ import annotations

from typing import Any

from ..objects import tetgen_mesh
from ..objects.base import DocumentObject
from . import selection
from .base import Command


class TetGenMesh(Command):
    icon_name = "nmgs_tetgen_mesh"
    menu_text = "TetGen mesh"
    tooltip = "Fill the picked solids, PLC, blocks or closed surface mesh with TetGen's tetrahedra"

    def ready(self) -> bool:
        return bool(selection.picked(DocumentObject)) or selection.can_pick("Solid")

    def act(self, document: Any) -> Any:
        source = [(obj, ("",)) for obj in selection.picked(DocumentObject)[:1]]
        source = source or selection.picked_solids()
        if not source:
            raise ValueError("Pick a solid, a PLC, blocks, patches or a mesh.")
        obj = tetgen_mesh.make(document)
        obj.Source = source
        if getattr(source[0][0], "FacetCount", None) == 0:
            # Points alone have no boundary to keep: their Delaunay tetrahedra.
            obj.Switches = ""
        self.computed(obj)
        for part, _ in source:
            part.Visibility = False
        return obj
