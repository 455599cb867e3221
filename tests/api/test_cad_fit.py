# SPDX-License-Identifier: LGPL-2.1-or-later
"""nmgs.fit on real OpenCASCADE shapes; the oracles are OpenCASCADE's volume, area and distance."""

import math

import numpy as np
import pytest

import FreeCAD  # noqa: F401  (Part needs it)
import Part
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs


def twisted_prism():
    wires = []
    for z, angle, scale in ((0, 0, 1.0), (5, 20, 0.8), (10, 45, 0.6)):
        corners = [
            Vector(-2 * scale, -scale, z),
            Vector(2 * scale, -scale, z),
            Vector(2 * scale, scale, z),
            Vector(-2 * scale, scale, z),
        ]
        wire = Part.makePolygon(corners + corners[:1])
        wire.rotate(Vector(0, 0, 0), Vector(0, 0, 1), angle)
        wires.append(wire)
    return Part.makeLoft(wires, True, False)


def tube_sector(angle, start=0.0):
    outer = Part.makeCylinder(3, 2, Vector(0, 0, 0), Vector(0, 0, 1), angle)
    sector = outer.cut(Part.makeCylinder(2, 2))
    sector.rotate(Vector(0, 0, 0), Vector(0, 0, 1), start)
    return sector


SOLIDS = {
    "box": lambda: Part.makeBox(3, 2, 1),
    "moved box": lambda: Part.makeBox(3, 2, 1, Vector(100, -7, 3), Vector(1, 2, 3)),
    "reversed box": lambda: Part.makeBox(3, 2, 1).reversed(),
    "frustum": lambda: Part.makeWedge(0, 0, 0, 1, 1, 5, 4, 6, 4, 4),
    "tube sector": lambda: tube_sector(100),
    "twisted prism": twisted_prism,
}


def hexahedron_volumes(points, cells):
    """Volume of each trilinear hexahedron, exact: the divergence theorem over bilinear faces.

    The flux of x / 3 through a bilinear patch a, b, c, d (outward) is a sum of triple products
    (Davies and Salmond, 1985, with all four triangles at half weight).
    """
    total = np.zeros(len(cells))
    for face in (
        (0, 3, 2, 1),
        (4, 5, 6, 7),
        (0, 1, 5, 4),
        (1, 2, 6, 5),
        (2, 3, 7, 6),
        (3, 0, 4, 7),
    ):
        a, b, c, d = (points[cells[:, n]] for n in face)
        for p, q, r in ((a, b, c), (a, c, d), (a, b, d), (b, c, d)):
            total += np.einsum("ij,ij->i", p, np.cross(q, r)) / 12
    return total


@pytest.mark.parametrize("name", SOLIDS)
def test_hexahedra_fill_the_solid(name):
    shape = SOLIDS[name]()
    errors = []
    for divide in (4, 8):
        mesh = nmgs.fit(shape, size=shape.BoundBox.DiagonalLength / divide).generate()
        volumes = hexahedron_volumes(mesh.points, mesh.cells["hexahedron"])
        assert (volumes > 0).all()
        assert (mesh.quality()["hexahedron"] > 0.2).all()
        errors.append(abs(volumes.sum() / abs(shape.Volume) - 1))
    # Exact on planes, second order on curved faces.
    assert errors[1] < 1e-12 or errors[1] < 0.5 * errors[0]
    assert errors[1] < 0.02


@pytest.mark.parametrize("order", (1, 2))
@pytest.mark.parametrize("name", SOLIDS)
def test_nodes_of_a_face_lie_on_it(name, order):
    shape = SOLIDS[name]()
    diagonal = shape.BoundBox.DiagonalLength
    mesh = nmgs.fit(shape, size=diagonal / 5).generate(order=order)
    for number, face in enumerate(shape.Faces, 1):
        kind, cells = mesh.groups[f"Face{number}"]
        assert kind == ("quad" if order == 1 else "quad8")
        for node in np.unique(mesh.cells[kind][cells]):
            vertex = Part.Vertex(Vector(*mesh.points[node]))
            assert face.distToShape(vertex)[0] < 1e-7 * diagonal


@pytest.mark.parametrize("name", SOLIDS)
def test_face_groups_cover_the_boundary_once_and_look_outward(name):
    shape = SOLIDS[name]()
    mesh = nmgs.fit(shape, size=shape.BoundBox.DiagonalLength / 6).generate()
    quads = mesh.cells["quad"]
    grouped = np.concatenate([mesh.groups[f"Face{n}"][1] for n in range(1, 7)])
    assert sorted(grouped) == list(range(len(quads)))
    volume = 0.0
    a, b, c, d = (mesh.points[quads[:, n]] for n in range(4))
    for p, q, r in ((a, b, c), (a, c, d), (a, b, d), (b, c, d)):
        volume += np.einsum("ij,ij->i", p, np.cross(q, r)).sum() / 12
    assert volume == pytest.approx(
        hexahedron_volumes(mesh.points, mesh.cells["hexahedron"]).sum(), rel=1e-12
    )


def test_vertices_and_edges_are_kept():
    shape = twisted_prism()
    mesh = nmgs.fit(shape, size=1).generate(order=2)
    for number, vertex in enumerate(shape.Vertexes, 1):
        kind, nodes = mesh.groups[f"Vertex{number}"]
        assert kind == "node" and len(nodes) == 1
        assert np.linalg.norm(mesh.points[nodes[0]] - np.array(vertex.Point)) < 1e-9
    for number, edge in enumerate(shape.Edges, 1):
        _, nodes = mesh.groups[f"Edge{number}"]
        assert len(nodes) >= 3
        for node in nodes:
            assert edge.distToShape(Part.Vertex(Vector(*mesh.points[node])))[0] < 1e-6


def test_solids_that_share_a_face_share_its_nodes():
    compound = tube_sector(60).generalFuse([tube_sector(70, 60)])[0]
    assert len(compound.Solids) == 2 and len(compound.Faces) == 11
    model = nmgs.fit(compound, size=0.4)
    mesh = model.generate()
    places = {tuple(np.round(p, 9)) for p in mesh.points}
    assert len(places) == len(mesh.points)
    hexes = mesh.cells["hexahedron"]
    assert len(mesh.groups["Solid1"][1]) + len(mesh.groups["Solid2"][1]) == len(hexes)
    for number, solid in enumerate(compound.Solids, 1):
        cells = hexes[mesh.groups[f"Solid{number}"][1]]
        volume = hexahedron_volumes(mesh.points, cells).sum()
        assert volume == pytest.approx(solid.Volume, rel=0.01)
    # Watertight: a face of a cell is either between two cells or among the quads, outer ones once.
    outer = len(mesh.boundary().cells["quad"])
    shared = [
        n
        for n, face in enumerate(compound.Faces, 1)
        if sum(face.isPartner(f) for s in compound.Solids for f in s.Faces) == 2
    ]
    assert len(shared) == 1
    assert outer == len(mesh.cells["quad"]) - len(mesh.groups[f"Face{shared[0]}"][1])


def test_blocks_are_halved_until_they_follow_the_cad():
    shape = tube_sector(120)
    counts = []
    for tolerance in (0.1, 0.01, 0.001):
        model = nmgs.fit(shape, tolerance=tolerance)
        assert model.report[0]["error"] <= tolerance
        counts.append(len(model))
    assert counts[0] < counts[1] < counts[2]
    assert len(nmgs.fit(Part.makeBox(3, 2, 1), tolerance=1e-9)) == 1


def test_patches_cover_a_curved_face():
    face = Part.makeCylinder(3, 5, Vector(0, 0, 0), Vector(0, 0, 1), 120).Faces[0]
    model = nmgs.fit(face, size=0.3)
    assert model.dimension == 2 and model.report[0]["method"] == "mapped"
    mesh = model.generate()
    radius = np.hypot(mesh.points[:, 0], mesh.points[:, 1])
    assert np.abs(radius - 3).max() < 1e-9
    area = mesh.quality("area")["quad"].sum()
    assert area == pytest.approx(3 * 5 * math.radians(120), rel=2e-3)
    # The face's normal looks away from the axis, and so do the quads.
    a, b, c, d = (mesh.points[mesh.cells["quad"][:, n]] for n in range(4))
    normal = np.cross(c - a, d - b)
    middle = (a + b + c + d) / 4
    assert (normal[:, 0] * middle[:, 0] + normal[:, 1] * middle[:, 1] > 0).all()


def test_picked_entities_keep_their_names():
    box = Part.makeBox(3, 2, 1)
    model = nmgs.fit(box, size=1, entities=["Face2", "Face5"])
    assert [entry["entity"] for entry in model.report] == ["Face2", "Face5"]
    groups = model.generate().groups
    assert {name for name in groups if name.startswith("Face")} == {"Face2", "Face5"}


def test_what_cannot_be_blocked_says_why():
    with pytest.raises(nmgs.BlockingError) as caught:
        nmgs.fit(Part.makeCylinder(1, 2), method="mapped")
    assert caught.value.entities == ["Solid1"] and "3 faces" in caught.value.reasons[0]
    pair = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeSphere(1, Vector(5, 0, 0))])
    report = nmgs.fit(pair, method="mapped").report
    assert [bool(entry["method"]) for entry in report] == [True, False]
    assert report[1]["reason"]


def test_structured_blocks_and_tetrahedra_in_one_model():
    # Only the second has a structured strategy.
    lump = Part.makeSphere(2).cut(Part.makeBox(1, 3, 1.5)).cut(Part.makeCylinder(0.3, 5))
    pair = Part.makeCompound([lump, Part.makeBox(1, 1, 1, Vector(5, 0, 0))])
    model = nmgs.fit(pair)
    assert model.report[1]["method"] == "mapped"
    mesh = model.generate()
    assert set(mesh.cells) == {"hexahedron", "quad"}
    quality = mesh.quality()["hexahedron"]
    assert quality.min() > 0
    assert len(mesh.groups["Solid1"][1]) + len(mesh.groups["Solid2"][1]) == len(quality)
    assert mesh.report().volume == pytest.approx(pair.Volume, rel=0.02)


@pytest.mark.parametrize(
    "arguments, text",
    (
        ({"size": 0}, "size"),
        ({"size": float("nan")}, "size"),
        ({"tolerance": -1}, "tolerance"),
        ({"method": "magic"}, "magic"),
        ({"entities": ["Face9"]}, "Face9"),
        ({"entities": ["Edge1"]}, "Edge1"),
        ({"entities": ["Face1", "Solid1"]}, "faces only or solids only"),
        ({"entities": []}, "entities"),
    ),
)
def test_wrong_arguments_are_named(arguments, text):
    with pytest.raises(ValueError, match=text):
        nmgs.fit(Part.makeBox(1, 1, 1), **arguments)


def test_empty_and_unusable_shapes():
    with pytest.raises(nmgs.GeometryError, match="empty"):
        nmgs.fit(Part.Shape())
    with pytest.raises(nmgs.GeometryError, match="no faces"):
        nmgs.fit(Part.makeLine((0, 0, 0), (1, 0, 0)))
    with pytest.raises(TypeError, match="42"):
        nmgs.fit(42)


def test_cancel():
    with pytest.raises(nmgs.Cancelled):
        nmgs.fit(twisted_prism(), progress=lambda fraction: False)
    model = nmgs.fit(twisted_prism(), size=0.1)
    with pytest.raises(nmgs.Cancelled):
        model.generate(progress=lambda fraction: fraction < 0.5)


DEFAULTS = {
    "cylinder": lambda: Part.makeCylinder(3, 8),
    "tube": lambda: tube_sector(180),
    "plate": lambda: Part.makeBox(40, 30, 1),
}


@pytest.mark.parametrize("name", DEFAULTS)
def test_default_divisions_keep_the_volume(name):
    shape = DEFAULTS[name]()
    try:
        model = nmgs.fit(shape)
    except nmgs.BlockingError:
        pytest.skip("no strategy for it")
    errors = []
    for factor in (1, 2):
        model.divisions = np.array(model.divisions * factor, np.int32)
        mesh = model.generate()
        cells = mesh.cells["hexahedron"]
        assert len(cells) < 8 * 250_000
        volume = hexahedron_volumes(mesh.points, cells).sum()
        errors.append(abs(volume - shape.Volume) / shape.Volume)
    assert errors[0] < 0.01
    assert errors[1] < 0.3 * errors[0] + 1e-9  # second order
