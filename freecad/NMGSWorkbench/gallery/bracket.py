# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bracket of FreeCAD's own primitives, filled by TetGen."""

from __future__ import annotations

from typing import Any

import FreeCAD

from ..objects import tetgen_mesh


def make(document: Any) -> None:
    """Two plates joined, two holes, tetrahedra."""
    foot = document.addObject("Part::Box", "Foot")
    foot.Length, foot.Width, foot.Height = 60, 30, 8
    wall = document.addObject("Part::Box", "Wall")
    wall.Length, wall.Width, wall.Height = 8, 30, 40
    joined = document.addObject("Part::Fuse", "Plates")
    joined.Base, joined.Tool = foot, wall
    down = document.addObject("Part::Cylinder", "HoleDown")
    down.Radius, down.Height = 6, 20
    down.Placement.Base = FreeCAD.Vector(40, 15, -5)
    through = document.addObject("Part::Cylinder", "HoleThrough")
    through.Radius, through.Height = 6, 20
    turned = FreeCAD.Rotation(FreeCAD.Vector(0, 1, 0), 90)
    through.Placement = FreeCAD.Placement(FreeCAD.Vector(-5, 15, 26), turned)
    holes = document.addObject("Part::Fuse", "Holes")
    holes.Base, holes.Tool = down, through
    part = document.addObject("Part::Cut", "Bracket")
    part.Base, part.Tool = joined, holes
    document.recompute()
    mesh = tetgen_mesh.make(document, "Tetrahedra")
    mesh.Source = [(part, ("Solid1",))]
    mesh.Switches = "pq1.4a12"
    for obj in (foot, wall, joined, down, through, holes, part):
        obj.Visibility = False
