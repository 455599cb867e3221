# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes arm.step beside this file: a bent, tapering, twisting arm with six four-sided faces.

Run with scripts/python examples/make_arm.py. Lengths in mm.
"""

import math
import pathlib

import FreeCAD  # noqa: F401  (Part needs it)
import Part
from FreeCAD import Rotation, Vector

BEND_RADIUS = 60.0
SECTIONS = 7


def section(share: float) -> Part.Wire:
    """Rectangle at a share (0 to 1) of the quarter bend, normal to its centre line."""
    angle = share * math.pi / 2
    centre = Vector(
        BEND_RADIUS * (1 - math.cos(angle)),
        0,
        40 + BEND_RADIUS * math.sin(angle) - 40 * (1 - share),
    )
    width = 34 - 16 * share
    height = 22 - 8 * share
    corners = [
        Vector(-height / 2, -width / 2, 0),
        Vector(height / 2, -width / 2, 0),
        Vector(height / 2, width / 2, 0),
        Vector(-height / 2, width / 2, 0),
    ]
    turn = Rotation(Vector(0, 1, 0), math.degrees(angle)).multiply(
        Rotation(Vector(0, 0, 1), 25 * share)
    )
    points = [centre + turn.multVec(corner) for corner in corners]
    return Part.makePolygon(points + points[:1])


def main() -> None:
    wires = [section(i / (SECTIONS - 1)) for i in range(SECTIONS)]
    arm = Part.makeLoft(wires, True, False)
    assert arm.isValid() and len(arm.Faces) == 6
    arm.exportStep(str(pathlib.Path(__file__).with_name("arm.step")))


main()
