# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen mesh."""

from __future__ import annotations

import math
from typing import Any

import FreeCAD

from ..objects import preferences
from ..taskpanels.messages import warn_of_quality
from . import selection
from .base import Command


class TetGenMesh(Command):
    accel = "N, T"
    icon_name = "nmgs_tetgen_mesh"
    menu_text = "TetGen mesh"
    tooltip = "Fill the picked solids, PLC, blocks or closed surface mesh with TetGen's tetrahedra"

    def ready(self) -> bool:
        return bool(selection.picked(selection.ANY)) or selection.can_pick("Solid")

    def act(self, document: Any) -> Any:
        source = [(obj, ("",)) for obj in selection.picked(selection.ANY)[:1]]
        source = source or selection.picked_solids()
        if not source:
            raise ValueError("Pick a solid, a PLC, blocks, patches or a mesh.")
        from ..objects import tetgen_mesh  # only here: it imports NumPy and Part

        obj = tetgen_mesh.make(document)
        obj.Source = source
        obj.Switches = suggested_switches(source)
        obj.TimeLimit = preferences.time_limit()
        self.computed(obj)
        warn_of_quality(self.menu_text, obj)
        for part, _ in source:
            part.Visibility = False
        return obj


def suggested_switches(source: selection.Source) -> str:
    """For solids quality tetrahedra with edges of about a twentieth of the diagonal; for points
    their Delaunay tetrahedra; else what the boundary asks for."""
    first = source[0][0]
    if getattr(first, "FacetCount", None) == 0:
        return ""
    if selection.is_kind(first, selection.ANY):
        return "pq"
    from ..nmgs.tetgen import TetOptions

    box = FreeCAD.BoundBox()
    for part, _ in source:
        box.add(part.Shape.BoundBox)
    # A regular tetrahedron of edge e has the volume e^3 / (6 sqrt 2).
    volume = (box.DiagonalLength / 20) ** 3 / (6 * math.sqrt(2))
    options = TetOptions.parse("pq1.4")
    options.max_volume = float(f"{volume:.2g}")
    return str(options)
