# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts: proposals go through what stands in the way; pieces make up the solid and share faces."""

import math
import subprocess
import sys

import FreeCAD  # noqa: F401  (Part needs it)
import Part
import pytest
from FreeCAD import Placement, Rotation, Vector

from freecad.NMGSWorkbench import nmgs


def step():
    """A box with a corner cut out along one edge, x = 1 and z = 1."""
    return Part.makeBox(3, 3, 3).cut(Part.makeBox(9, 9, 9, Vector(1, -1, 1)))


def volumes(shape):
    return sorted(solid.Volume for solid in shape.Solids)


def test_proposals_go_through_the_concave_edge():
    shape = step()
    cuts = nmgs.propose_cuts(shape)
    assert cuts and len(set(cuts)) == len(cuts)
    assert [cut.resolves for cut in cuts] == sorted((cut.resolves for cut in cuts), reverse=True)
    for cut in cuts:
        assert cut.name and cut.entities and math.isclose(math.hypot(*cut.direction), 1)
        normal, off = Vector(*cut.direction), Vector(1, 1.5, 1) - Vector(*cut.origin)
        assert not cut.radius and abs(normal.dot(off)) < 1e-9


def test_a_convex_solid_needs_no_cut():
    assert nmgs.propose_cuts(Part.makeBox(1, 2, 3)) == []


def test_one_plane_of_two_solids_is_proposed_once():
    shape = Part.makeCompound([step(), step().translated(Vector(0, 7, 0))])
    both, one = nmgs.propose_cuts(shape), nmgs.propose_cuts(shape, ["Solid2"])
    level = [cut for cut in both if abs(cut.direction[2]) > 0.999]
    assert len(level) == 1 and level[0].resolves == 2
    assert [cut.resolves for cut in one if abs(cut.direction[2]) > 0.999] == [1]


def test_pieces_make_up_the_solid_and_share_a_face():
    shape = step()
    pieces = nmgs.cut(shape, nmgs.Cut((0, 0, 1), (0, 0, 1)))
    assert volumes(pieces) == pytest.approx([1 * 3 * 2, 3 * 3 * 1])
    assert len(pieces.Faces) == sum(len(solid.Faces) for solid in pieces.Solids) - 1
    model = nmgs.fit(pieces)
    assert {entry["method"] for entry in model.report} <= {"mapped", "submap"}
    report = model.generate().report()
    assert report.volume == pytest.approx(shape.Volume)


@pytest.mark.parametrize(
    "face, wanted",
    [
        (Part.makePlane(1, 1, Vector(2, 2, 3)), [300, 700]),
        (Part.makeCylinder(2, 1, Vector(5, 5, 3)).Faces[0], [40 * math.pi, 1000 - 40 * math.pi]),
        (
            Part.makeSphere(2, Vector(5, 5, 5)).Faces[0],
            [32 / 3 * math.pi, 1000 - 32 / 3 * math.pi],
        ),
        # A cone of half angle 45 degrees, its apex in the bottom: up to the top without its rim.
        (
            Part.makeCone(1, 2, 1, Vector(5, 5, 6)).Faces[0],
            [125 / 3 * math.pi, 1000 - 125 / 3 * math.pi],
        ),
        (
            Part.makeTorus(3, 1, Vector(5, 5, 5)).Faces[0],
            [6 * math.pi**2, 1000 - 6 * math.pi**2],
        ),
    ],
    ids=["plane", "cylinder", "sphere", "cone", "torus"],
)
def test_a_face_cuts_as_far_as_its_surface_goes(face, wanted):
    assert volumes(nmgs.cut(Part.makeBox(10, 10, 10), face)) == pytest.approx(sorted(wanted))


def test_a_placed_face_cuts_where_it_is():
    face = Part.makePlane(1, 1)
    face.Placement = Placement(Vector(4, 0, 0), Rotation(Vector(0, 1, 0), 90))
    assert volumes(nmgs.cut(Part.makeBox(10, 10, 10), face)) == pytest.approx([400, 600])


def test_another_face_cuts_as_far_as_it_reaches():
    arc = Part.Arc(Vector(-1, 5, 5), Vector(5, 5, 7), Vector(11, 5, 5)).toShape()
    nurbs = arc.toNurbs().Edges[0]
    face = nurbs.extrude(Vector(0, 9, 0)).Faces[0].translated(Vector(0, -6, 0))
    short = nurbs.extrude(Vector(0, 3, 0)).Faces[0]
    box = Part.makeBox(10, 8, 10)
    assert len(nmgs.cut(box, face).Solids) == 2
    with pytest.raises(nmgs.GeometryError, match="divided"):
        nmgs.cut(box, short)


def test_neighbours_stay_joined():
    shape = Part.makeCompound([Part.makeBox(2, 2, 2), Part.makeBox(2, 2, 2, Vector(2, 0, 0))])
    pieces = nmgs.cut(shape, nmgs.Cut((0, 0, 1), (0, 0, 1)))
    assert volumes(pieces) == pytest.approx([4, 4, 4, 4])
    # Four boxes in a square share four faces.
    assert len(pieces.Faces) == 4 * 6 - 4
    alone = nmgs.cut(shape, nmgs.Cut((0, 0, 1), (0, 0, 1)), ["Solid1"])
    assert volumes(alone) == pytest.approx([4, 4])


def test_wrong_arguments_are_named():
    box = Part.makeBox(1, 1, 1)
    with pytest.raises(nmgs.GeometryError, match="plane at .*9"):
        nmgs.cut(box, nmgs.Cut((0, 0, 9), (0, 0, 1)))
    with pytest.raises(ValueError, match="tools"):
        nmgs.cut(box, [])
    with pytest.raises(ValueError, match="direction"):
        nmgs.cut(box, nmgs.Cut((0, 0, 0.5), (0, 0, 0)))
    with pytest.raises(ValueError, match="finite"):
        nmgs.cut(box, nmgs.Cut((0, 0, math.nan), (0, 0, 1)))
    with pytest.raises(ValueError, match="without any"):
        nmgs.cut(box, Part.makeLine(Vector(0, 0, 0), Vector(1, 1, 1)))
    with pytest.raises(TypeError, match="shape"):
        nmgs.cut(box, "Face1")
    with pytest.raises(nmgs.GeometryError, match="no solid"):
        nmgs.propose_cuts(box.Faces[0])
    with pytest.raises(ValueError, match="Solid2"):
        nmgs.propose_cuts(box, ["Solid2"])
    with pytest.raises(ValueError, match="solids"):
        nmgs.cut(box, nmgs.Cut((0, 0, 0.5), (0, 0, 1)), ["Face1"])


def test_importing_needs_no_freecad():
    code = "import sys; import freecad.NMGSWorkbench.nmgs; assert 'Part' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
