# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that stand for a solid or a cavity lay between a curved face and its triangles, or outside
of the cavity: TetGen then emptied the solid and filled the cavity."""

import FreeCAD  # noqa: F401
import Part
import pytest
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs

BALL = Part.makeSphere(1, Vector(2, 2, 2))


def test_a_cavity_is_empty():
    shape = Part.makeBox(4, 4, 4).cut(BALL)
    mesh = nmgs.tetrahedralize(shape, "p")
    assert mesh.quality("volume")["tetra"].sum() == pytest.approx(shape.Volume, rel=0.01)


def test_every_tetrahedron_belongs_to_a_solid():
    both = Part.makeBox(4, 4, 4).generalFuse([BALL])[0]
    mesh = nmgs.tetrahedralize(both, "p")
    assert not [name for name in mesh.groups if name.startswith("Region")]
