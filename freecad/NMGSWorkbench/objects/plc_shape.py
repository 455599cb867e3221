# SPDX-License-Identifier: LGPL-2.1-or-later
"""A PLC as a shape to look at."""

from __future__ import annotations

from typing import List

import FreeCAD
import numpy as np
import Part

from .. import nmgs

#: Beyond these a shape would take FreeCAD longer to draw than TetGen takes to mesh.
MOST_FACES = 5_000
MOST_OUTLINES = 50_000
MOST_POINTS = 20_000


def plc_shape(plc: nmgs.PLC) -> Part.Shape:
    """Facets as faces, or as outlines where they are many or not plane; else the points.

    Of more points than MOST_POINTS an even choice is shown.
    """
    shapes: List[Part.Shape] = []
    if 0 < len(plc) <= MOST_OUTLINES:
        for number in range(len(plc)):
            shapes += _facet(plc, number, len(plc) <= MOST_FACES)
    if not shapes:
        step = -(-len(plc.points) // MOST_POINTS) or 1
        shapes = [Part.Vertex(*point) for point in plc.points[::step].tolist()]
    return Part.makeCompound(shapes)


def _facet(plc: nmgs.PLC, number: int, filled: bool) -> List[Part.Shape]:
    wires, loose = [], []
    for nodes in plc.facet(number):
        places = _without_repeats(plc.points[nodes])
        if len(places) == 1:
            loose.append(Part.Vertex(*places[0]))
        elif len(places) == 2:
            loose.append(Part.makeLine(*(FreeCAD.Vector(*place) for place in places)))
        else:
            corners = [FreeCAD.Vector(*place) for place in places]
            wires.append(Part.makePolygon([*corners, corners[0]]))
    # Facets with several outlines need not have holes, so that only plain ones are filled.
    if filled and len(wires) == 1:
        try:
            return [Part.Face(wires[0]), *loose]
        except Part.OCCError:  # the polygon is not plane, or crosses itself
            return [*wires, *loose]
    return [*wires, *loose]


def _without_repeats(places: np.ndarray) -> np.ndarray:
    following = np.roll(places, -1, axis=0)
    keep = (places != following).any(axis=1)
    return places[keep] if keep.any() else places[:1]
