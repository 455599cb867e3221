# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts on CAD edges and boundary layers on CAD faces."""

import numpy as np
import pytest

from freecad.NMGSWorkbench import nmgs

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")


def edge_along(shape, axis, at):
    """Name of the edge through a point, parallel to an axis (0, 1, 2)."""
    for n, edge in enumerate(shape.Edges, 1):
        centre = edge.CenterOfMass
        if (centre - FreeCAD.Vector(*at)).Length < 1e-6:
            return f"Edge{n}"
    raise AssertionError(at)


def face_at(shape, at):
    for n, face in enumerate(shape.Faces, 1):
        if (face.CenterOfMass - FreeCAD.Vector(*at)).Length < 1e-6:
            return f"Face{n}"
    raise AssertionError(at)


def nodes_on(mesh, name):
    return mesh.points[mesh.groups[name][1]]


def test_an_edge_and_all_that_its_chain_links_get_the_count():
    box = Part.makeBox(2, 3, 4)
    model = nmgs.fit(box, size=1)
    name = edge_along(box, 0, (1, 0, 0))
    nmgs.sizing.set_edge_counts(model, {name: 7})
    mesh = model.generate()
    assert len(nodes_on(mesh, name)) == 8
    assert len(nodes_on(mesh, edge_along(box, 0, (1, 3, 4)))) == 8
    assert len(nodes_on(mesh, edge_along(box, 1, (0, 1.5, 0)))) == 4


def test_contradicting_counts_are_refused():
    box = Part.makeBox(2, 3, 4)
    model = nmgs.fit(box, size=1)
    before = model.divisions.copy()
    counts = {edge_along(box, 0, (1, 0, 0)): 7, edge_along(box, 0, (1, 3, 4)): 8}
    with pytest.raises(nmgs.BlockingError):
        nmgs.sizing.set_edge_counts(model, counts)
    assert (model.divisions == before).all()


def test_layers_have_the_heights_that_were_asked_for():
    box = Part.makeBox(2, 3, 4)
    model = nmgs.fit(box, size=0.5)
    nmgs.sizing.set_boundary_layers(model, [face_at(box, (1, 1.5, 0))], first=0.01, growth=1.5)
    mesh = model.generate()
    heights = np.diff(np.unique(np.round(mesh.points[:, 2], 9)))
    grown = heights[: np.argmax(heights[1:] / heights[:-1] < 1.4) + 1]
    assert heights[0] == pytest.approx(0.01)
    np.testing.assert_allclose(grown[1:] / grown[:-1], 1.5)
    assert len(grown) > 8 and heights.max() < 0.5 + 1e-9
    assert mesh.report().volume == pytest.approx(24)


def test_layers_at_both_ends_and_a_given_number_of_them():
    box = Part.makeBox(2, 3, 4)
    model = nmgs.fit(box, size=0.5)
    faces = [face_at(box, (0, 1.5, 2)), face_at(box, (2, 1.5, 2))]
    nmgs.sizing.set_boundary_layers(model, faces, first=0.02, growth=2, layers=3)
    x = np.unique(np.round(model.generate().points[:, 0], 9))
    np.testing.assert_allclose(np.diff(x)[:3], [0.02, 0.04, 0.08])
    np.testing.assert_allclose(np.diff(x)[-3:], [0.08, 0.04, 0.02])
    assert np.diff(x)[3:-3].max() <= 0.5


@pytest.mark.parametrize(
    "arguments",
    [{"first": 0}, {"first": float("nan")}, {"first": 1, "growth": 0.5}, {"first": 1, "layers": 0}],
)
def test_nonsense_is_refused_by_name(arguments):
    model = nmgs.fit(Part.makeBox(2, 3, 4))
    with pytest.raises(ValueError, match=list(arguments)[-1]):
        nmgs.sizing.set_boundary_layers(model, ["Face1"], **arguments)


def test_a_face_without_blocks_and_layers_without_room():
    model = nmgs.fit(Part.makeBox(2, 3, 4))
    with pytest.raises(nmgs.GeometryError, match="Face9"):
        nmgs.sizing.set_boundary_layers(model, ["Face9"], first=0.1)
    with pytest.raises(nmgs.BlockingError, match="too short"):
        nmgs.sizing.set_boundary_layers(model, ["Face1"], first=5, layers=2)
    with pytest.raises(nmgs.GeometryError, match="Edge99"):
        nmgs.sizing.set_edge_counts(model, {"Edge99": 3})
