# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same blocks over a shape with other dimensions."""

import math

import numpy as np
import pytest

from freecad.NMGSWorkbench import nmgs

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")


def sector(radius, height, angle=70):
    """A sector of a thick tube: six four-sided faces, two of them round."""
    profile = Part.Face(
        Part.Wire(
            Part.makePolygon(
                [
                    FreeCAD.Vector(x, 0, z)
                    for x, z in (
                        (radius, 0),
                        (2 * radius, 0),
                        (2 * radius, height),
                        (radius, height),
                        (radius, 0),
                    )
                ]
            ).Edges
        )
    )
    return profile.revolve(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), angle)


def volume(mesh):
    return mesh.report().volume


def test_blocks_follow_a_changed_dimension_as_a_new_fit_would():
    old, new = sector(1, 2), sector(1.5, 5, 80)
    model = nmgs.fit(old)
    model.set_divisions(size=0.1)
    again = nmgs.refit(model, new)
    assert len(again) == len(model)
    assert (again.divisions == model.divisions).all()
    mesh = again.generate()
    exact = 0.5 * math.radians(80) * (9 - 2.25) * 5
    assert volume(mesh) == pytest.approx(exact, rel=2e-3)
    assert mesh.quality()["hexahedron"].min() > 0.5
    radius = np.hypot(*mesh.points[:, :2].T)
    assert radius.min() >= 1.5 - 1e-9 and radius.max() <= 3 + 1e-9
    assert {k: len(v[1]) for k, v in mesh.groups.items()} == {
        k: len(v[1]) for k, v in model.generate().groups.items()
    }


def test_nothing_moves_where_nothing_changed():
    shape = sector(1, 2)
    model = nmgs.fit(shape)
    again = nmgs.refit(model, shape)
    np.testing.assert_allclose(again.nodes, model.nodes, atol=1e-9)
    assert again.report[0]["error"] == pytest.approx(model.report[0]["error"], abs=1e-9)


def test_patches_are_fitted_again_as_well():
    old, new = Part.makePlane(1, 1), Part.makePlane(3, 2)
    mesh = nmgs.refit(nmgs.fit(old), new).generate()
    assert mesh.report().area == pytest.approx(6)


def test_another_topology_is_refused_by_name():
    model = nmgs.fit(Part.makeBox(1, 1, 1))
    with pytest.raises(nmgs.GeometryError, match="vertices"):
        nmgs.refit(model, Part.makeCylinder(1, 1))
    with pytest.raises(ValueError, match="fit"):
        nmgs.refit(nmgs.shapes.cube(), Part.makeBox(1, 1, 1))


def drilled_plate(length, radius):
    plate = Part.makeBox(length, 30, 5)
    return plate.cut(Part.makeCylinder(radius, 5, FreeCAD.Vector(length / 2, 12, 0)))


def test_patches_over_a_skin_follow_a_changed_dimension():
    old, new = drilled_plate(40, 4), drilled_plate(60, 7)
    faces = [f"Face{n}" for n in range(1, len(old.Faces) + 1)]
    model = nmgs.fit(old, entities=faces, size=4, counts={"Edge1": 8})
    again = nmgs.refit(model, new)
    assert (again.divisions == model.divisions).all()
    before, after = model.generate(), again.generate()
    assert (after.cells["quad"] == before.cells["quad"]).all()
    assert after.quality()["quad"].min() > 0.2
    for n, face in enumerate(new.Faces, 1):
        quads = after.points[after.cells["quad"][after.groups[f"Face{n}"][1]]]
        area = 0.5 * np.linalg.norm(
            np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1]), axis=1
        )
        assert area.sum() == pytest.approx(face.Area, rel=0.02)
    for point in after.points[::7]:
        assert new.distToShape(Part.Vertex(*point))[0] < 1e-7 * new.BoundBox.DiagonalLength


def test_patches_are_not_put_onto_another_topology():
    model = nmgs.fit(drilled_plate(40, 4), entities=["Face1"])
    with pytest.raises(nmgs.GeometryError, match="10 vertices.*has 8"):
        nmgs.refit(model, Part.makeBox(1, 2, 3))


def test_blocks_that_no_longer_follow_are_told():
    from freecad.NMGSWorkbench.nmgs.refit import follows

    shape = Part.makeCylinder(2, 5)
    model = nmgs.fit(shape, entities=["Face1"])
    assert follows(nmgs.refit(model, Part.makeCylinder(3, 9)), model)
    # A cylinder's patches on a thin and long one: in the diagonal's measure they are as near.
    assert follows(nmgs.refit(model, Part.makeCylinder(0.5, 90)), model)
    assert not follows(nmgs.refit(model, Part.makeCylinder(30, 0.5)), model, tolerance=1e-6)
