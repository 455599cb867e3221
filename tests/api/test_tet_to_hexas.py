# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tet-to-hex on any solid; the oracles are OpenCASCADE's volumes, edges and distances."""

import numpy as np
import pytest

import FreeCAD  # noqa: F401  (Part needs it)
import Part
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs


def shell():
    return Part.makeCylinder(5, 8).cut(Part.makeCylinder(4.8, 8))


def filleted():
    box = Part.makeBox(10, 8, 6)
    return box.makeFillet(1.0, box.Edges)


def with_void():
    return Part.makeBox(6, 6, 6).cut(Part.makeSphere(1.5, Vector(3, 3, 3)))


def plate_with_holes():
    plate = Part.makeBox(12, 8, 1)
    for x in (2.5, 6, 9.5):
        plate = plate.cut(Part.makeCylinder(1, 1, Vector(x, 4, 0)))
    return plate


def touching():
    parts = [Part.makeBox(3, 3, 3), Part.makeCylinder(1, 3, Vector(1.5, 1.5, 3))]
    compound, _ = parts[0].generalFuse(parts[1:])
    return compound


SOLIDS = {
    "box": lambda: Part.makeBox(3, 2, 1),
    "cylinder": lambda: Part.makeCylinder(1, 4),
    "ball": lambda: Part.makeSphere(2),
    "torus": lambda: Part.makeTorus(5, 1),
    "thin shell": shell,
    "fillets": filleted,
    "void": with_void,
    "plate with holes": plate_with_holes,
    "touching": touching,
}


@pytest.fixture(scope="module", params=sorted(SOLIDS))
def meshed(request):
    shape = SOLIDS[request.param]()
    model = nmgs.fit(shape, method="tet-to-hex")
    return shape, model, model.generate()


def outer_faces(cells):
    sides = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    faces = np.sort(np.concatenate([cells[:, side] for side in sides]), axis=1)
    unique, count = np.unique(faces, axis=0, return_counts=True)
    assert count.max() <= 2
    return unique[count == 1]


def test_every_solid_gets_its_volume_in_sound_hexahedra(meshed):
    shape, model, mesh = meshed
    assert set(mesh.cells) == {"hexahedron", "quad"}
    assert mesh.quality()["hexahedron"].min() > 0
    volumes = mesh.quality("volume")["hexahedron"]
    for n, solid in enumerate(shape.Solids, 1):
        assert model.report[n - 1]["method"] == "tet-to-hex"
        own = mesh.groups[f"Solid{n}"][1]
        assert volumes[own].sum() == pytest.approx(solid.Volume, rel=0.01)


def test_the_mesh_is_closed_by_quads_on_the_faces(meshed):
    shape, _, mesh = meshed
    quads = {tuple(row) for row in np.sort(mesh.cells["quad"], axis=1).tolist()}
    assert all(tuple(face) in quads for face in outer_faces(mesh.cells["hexahedron"]).tolist())
    for n in range(1, len(shape.Faces) + 1):
        assert len(mesh.groups[f"Face{n}"][1])


def test_vertices_are_nodes_and_edges_are_covered(meshed):
    shape, _, mesh = meshed
    quads = mesh.cells["quad"]
    lines = np.sort(np.concatenate([quads[:, [i, (i + 1) % 4]] for i in range(4)]), axis=1)
    lines = np.unique(lines, axis=0)
    for n, vertex in enumerate(shape.Vertexes, 1):
        node = mesh.groups[f"Vertex{n}"][1]
        assert len(node) == 1
        assert np.allclose(mesh.points[node[0]], vertex.Point, atol=1e-6)
    for n, edge in enumerate(shape.Edges, 1):
        if edge.Degenerated:
            continue
        nodes = mesh.groups[f"Edge{n}"][1]
        mine = lines[np.isin(lines, nodes).all(axis=1)]
        length = np.linalg.norm(mesh.points[mine[:, 0]] - mesh.points[mine[:, 1]], axis=1).sum()
        assert length == pytest.approx(edge.Length, rel=0.03)
        for node in nodes[:: max(1, len(nodes) // 10)]:
            vertex = Part.Vertex(Vector(*mesh.points[node]))
            assert edge.distToShape(vertex)[0] < 1e-6


def test_one_solid_of_two_is_filled_alone():
    shape = touching()
    model = nmgs.fit(shape, method="tet-to-hex", entities=["Solid2"])
    mesh = model.generate()
    assert "Solid1" not in mesh.groups
    volume = mesh.quality("volume")["hexahedron"].sum()
    assert volume == pytest.approx(shape.Solids[1].Volume, rel=0.01)


def test_a_cancelled_fit_says_so():
    with pytest.raises(nmgs.Cancelled):
        nmgs.fit(Part.makeSphere(1), method="tet-to-hex", progress=lambda fraction: False)


def test_solids_that_touch_at_a_vertex_share_its_node():
    boxes = [Part.makeBox(1, 1, 1), Part.makeBox(2, 2, 2, Vector(1, 1, 1))]
    shape, _ = boxes[0].generalFuse(boxes[1:])
    model = nmgs.fit(shape, method="tet-to-hex")
    mesh = model.generate()
    common = [n for n, v in enumerate(shape.Vertexes, 1) if v.Point.isEqual(Vector(1, 1, 1), 1e-9)]
    assert len(common) == 1
    assert len(mesh.groups[f"Vertex{common[0]}"][1]) == 1
    assert mesh.quality()["hexahedron"].min() > 0
