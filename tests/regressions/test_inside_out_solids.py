# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid that is stored inside out gave a mirrored block, then a refusal."""

import FreeCAD  # noqa: F401
import Part

from freecad.NMGSWorkbench import nmgs


def test_block_of_a_reversed_solid_is_not_mirrored():
    mesh = nmgs.fit(Part.makeBox(3, 2, 1).reversed(), size=0.5).generate()
    assert (mesh.quality()["hexahedron"] > 0.99).all()
