# SPDX-License-Identifier: LGPL-2.1-or-later
"""nmgs.fit over faces of every kind; the oracles are OpenCASCADE's areas and distances."""

import math
import os
from pathlib import Path

import numpy as np
import pytest

import FreeCAD  # noqa: F401  (Part needs it)
import Part
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs


def polygon(*points):
    corners = [Vector(*p) for p in points]
    return Part.Face(Part.makePolygon(corners + corners[:1]))


def plate_with_holes():
    plate = Part.makePlane(10, 6)
    for x, y, r in ((2, 2, 0.8), (6, 3, 1.5), (9, 5, 0.3)):
        plate = plate.cut(Part.Face(Part.Wire(Part.makeCircle(r, Vector(x, y, 0)))))
    return plate.Faces[0]


def bspline_face():
    surface = Part.BSplineSurface()
    points = [
        [Vector(i, j, math.sin(0.9 * i) * math.cos(0.7 * j)) for j in range(6)] for i in range(6)
    ]
    surface.interpolate(points)
    return surface.toShape()


def bezier_face():
    surface = Part.BezierSurface()
    surface.increase(2, 2)
    for i in range(3):
        for j in range(3):
            surface.setPole(i + 1, j + 1, Vector(i, j, 0.8 * (i == 1) + 0.3 * (j == 2)))
    return surface.toShape()


def trimmed_cylinder():
    pipe = Part.makeCylinder(2, 6)
    drilled = pipe.cut(Part.makeCylinder(0.7, 6, Vector(0, 0, 3), Vector(1, 0, 0)))
    return max(
        (f for f in drilled.Faces if isinstance(f.Surface, Part.Cylinder)), key=lambda f: f.Area
    )


def offset_face():
    return max(bspline_face().makeOffsetShape(0.2, 1e-4).Faces, key=lambda f: f.Area)


def revolved():
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(2, 0, 0), Vector(1, 0, 1), Vector(1.5, 0, 2.5), Vector(0.8, 0, 4)])
    return curve.toShape().revolve(Vector(0, 0, 0), Vector(0, 0, 1), 360).Faces[0]


def extruded():
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(0, 0, 0), Vector(1, 1, 0), Vector(2, -1, 0), Vector(4, 0, 0)])
    return curve.toShape().extrude(Vector(0, 0.5, 3))


FACES = {
    "rectangle": lambda: Part.makePlane(3, 2),
    "triangle": lambda: polygon((0, 0, 0), (3, 0, 0), (1, 2, 0)),
    "pentagon": lambda: polygon((0, 0, 0), (2, 0, 0), (3, 2, 0), (1, 3.5, 0), (-1, 2, 0)),
    "letter L": lambda: polygon((0, 0, 0), (4, 0, 0), (4, 1, 0), (1, 1, 0), (1, 5, 0), (0, 5, 0)),
    "sliver": lambda: polygon((0, 0, 0), (10, 0, 0), (10, 0.05, 0), (0, 0.05, 0)),
    "tiny edge": lambda: polygon((0, 0, 0), (5, 0, 0), (5, 4, 0), (0.002, 4, 0), (0, 3.998, 0)),
    "disc": lambda: Part.Face(Part.Wire(Part.makeCircle(2))),
    "annulus": lambda: Part.Face(Part.Wire(Part.makeCircle(2)))
    .cut(Part.Face(Part.Wire(Part.makeCircle(1))))
    .Faces[0],
    "plate with holes": plate_with_holes,
    "cylinder": lambda: Part.makeCylinder(1, 3).Faces[0],
    "trimmed cylinder": trimmed_cylinder,
    "frustum": lambda: Part.makeCone(2, 1, 3).Faces[0],
    "cone": lambda: Part.makeCone(1, 0, 2).Faces[0],
    "sphere": lambda: Part.makeSphere(1).Faces[0],
    "torus": lambda: Part.makeTorus(3, 1).Faces[0],
    "revolution": revolved,
    "extrusion": extruded,
    "bezier": bezier_face,
    "bspline": bspline_face,
    "offset": offset_face,
    "reversed": lambda: plate_with_holes().reversed(),
}


def quad_area(mesh):
    p = mesh.points
    q = mesh.cells["quad"]
    return 0.5 * np.linalg.norm(np.cross(p[q[:, 2]] - p[q[:, 0]], p[q[:, 3]] - p[q[:, 1]]), axis=1)


def check_cover(shape, mesh):
    """Only quads, none turned over; vertices are nodes, edges are covered, faces tile."""
    assert set(mesh.cells) == {"quad"}
    assert (mesh.quality()["quad"] > 0).all()
    quads = mesh.cells["quad"]
    ends = np.sort(np.concatenate([quads[:, [i, (i + 1) % 4]] for i in range(4)]), axis=1)
    edges = {tuple(e) for e in ends.tolist()}
    for vertex in shape.Vertexes:
        gap = np.linalg.norm(mesh.points - np.array(vertex.Point), axis=1).min()
        assert gap < 1e-7 * shape.BoundBox.DiagonalLength
    for n, edge in enumerate(shape.Edges, 1):
        if edge.Length < 1e-9:
            continue
        kind, nodes = mesh.groups[f"Edge{n}"]
        assert kind == "node"
        on = set(nodes.tolist())
        for vertex in edge.Vertexes:
            gaps = np.linalg.norm(mesh.points - np.array(vertex.Point), axis=1)
            on.add(int(gaps.argmin()))
        covered = [e for e in edges if e[0] in on and e[1] in on]
        length = sum(np.linalg.norm(mesh.points[a] - mesh.points[b]) for a, b in covered)
        assert length > 0.9 * edge.Length
    return ends


@pytest.mark.parametrize("name", FACES)
def test_every_kind_of_face_is_covered(name):
    face = FACES[name]()
    size = face.BoundBox.DiagonalLength
    errors = []
    for divide in (25, 50):
        model = nmgs.fit(face, size=size / divide)
        assert model.dimension == 2
        (entry,) = model.report
        assert entry["method"] and entry["entity"] == "Face1"
        mesh = model.generate()
        check_cover(face, mesh)
        assert mesh.quality()["quad"].min() > 0.2
        errors.append(abs(quad_area(mesh).sum() / face.Area - 1))
        sample = mesh.points[:: max(1, len(mesh.points) // 40)]
        for point in sample:
            assert face.distToShape(Part.Vertex(*point))[0] < 1e-7 * size
        # Counter-clockwise about the face's normal.
        quad = mesh.cells["quad"][len(mesh.cells["quad"]) // 2]
        corners = mesh.points[quad]
        normal = np.cross(corners[2] - corners[0], corners[3] - corners[1])
        u, v = face.Surface.parameter(Vector(*corners.mean(axis=0)))
        assert np.dot(normal, face.normalAt(u, v)) > 0
    # Exact on planes with straight edges, second order else.
    assert errors[1] < 1e-9 or errors[1] < 0.5 * errors[0] or errors[1] < 2e-4


SKINS = {
    "cylinder": lambda: Part.makeCylinder(1, 3),
    "tube": lambda: Part.makeCylinder(2, 3).cut(Part.makeCylinder(1.5, 3)),
    "drilled block": lambda: Part.makeBox(6, 4, 2).cut(Part.makeCylinder(0.8, 4, Vector(2, 2, -1))),
    "rounded box": lambda: (lambda box: box.makeFillet(0.4, box.Edges))(Part.makeBox(4, 3, 2)),
    "bracket": lambda: Part.makeBox(4, 3, 1)
    .fuse(Part.makeBox(1, 3, 4))
    .cut(Part.makeCylinder(0.5, 3, Vector(2.5, 1.5, -1)))
    .removeSplitter(),
}


@pytest.mark.parametrize("name", SKINS)
def test_faces_of_a_skin_share_their_edges(name):
    solid = SKINS[name]()
    faces = [f"Face{n}" for n in range(1, len(solid.Faces) + 1)]
    mesh = nmgs.fit(solid, entities=faces).generate()
    ends = check_cover(solid, mesh)
    _, counts = np.unique(ends, axis=0, return_counts=True)
    assert (counts == 2).all()
    assert mesh.quality()["quad"].min() > 0.2
    for n, face in enumerate(solid.Faces, 1):
        kind, indices = mesh.groups[f"Face{n}"]
        assert kind == "quad"
        assert quad_area(mesh)[indices].sum() == pytest.approx(face.Area, rel=0.05)


def test_strategies_by_name():
    rectangle = Part.makePlane(3, 2)
    assert nmgs.fit(rectangle, method="mapped").report[0]["method"] == "mapped"
    assert nmgs.fit(rectangle, method="general").report[0]["method"] == "general"
    assert nmgs.fit(FACES["annulus"](), method="ring").report[0]["method"] == "ring"
    with pytest.raises(nmgs.BlockingError, match="Face1"):
        nmgs.fit(FACES["plate with holes"](), method="mapped")


def test_an_unbounded_face_is_named():
    face = Part.Plane().toShape()
    with pytest.raises((nmgs.BlockingError, nmgs.GeometryError), match="Face1"):
        nmgs.fit(face)


def bow_tie():
    return polygon((0, 0, 0), (1, 1, 0), (1, 0, 0), (0, 1, 0))


@pytest.mark.parametrize(
    "make, named, words",
    [
        (lambda: Part.Plane().toShape(), ["Face1"], "Face1 has no end"),
        (lambda: Part.Cylinder().toShape(), ["Face1"], "Face1 has no end"),
        (lambda: Part.makeCompound([Part.makePlane(1, 1), bow_tie()]), ["Face2"], "not valid"),
        (lambda: Part.makeCompound([]), [], "no faces"),
        (lambda: Part.Vertex(0, 0, 0), [], "no faces"),
        (Part.Shape, [], "empty"),
        (lambda: [], [], "empty"),
    ],
)
def test_what_cannot_be_covered_is_named(make, named, words):
    with pytest.raises(nmgs.GeometryError, match=words) as caught:
        nmgs.fit(make())
    assert list(caught.value.entities) == named


def test_an_empty_pick_is_an_error():
    with pytest.raises(ValueError, match="entities: nothing is picked"):
        nmgs.fit(Part.makeBox(1, 1, 1), entities=[])


def nodes_on(mesh, edge):
    return len(mesh.groups[f"Edge{edge}"][1])


def test_counts_on_edges_hold_along_blocks_where_these_allow_it():
    model = nmgs.fit(Part.makePlane(3, 2), counts={"Edge1": 5, "Edge3": 5})
    assert len(model) == 1
    assert nodes_on(model.generate(), 1) == nodes_on(model.generate(), 3) == 6


@pytest.mark.parametrize("size", (None, 0.4))
def test_counts_that_differ_across_a_face_are_laid_out(size):
    face = Part.makePlane(3, 2)
    mesh = nmgs.fit(face, size=size, counts={"Edge1": 5, "Edge3": 9}).generate()
    check_cover(face, mesh)
    assert nodes_on(mesh, 1) == 6 and nodes_on(mesh, 3) == 10
    assert quad_area(mesh).sum() == pytest.approx(6, rel=1e-9)


def test_counts_hold_on_edges_that_faces_share():
    solid = SKINS["drilled block"]()
    faces = [f"Face{n}" for n in range(1, len(solid.Faces) + 1)]
    circle = next(
        n for n, e in enumerate(solid.Edges, 1) if isinstance(e.Curve, Part.Circle) and e.Closed
    )
    line = next(n for n, e in enumerate(solid.Edges, 1) if e.Length == pytest.approx(6))
    wanted = {f"Edge{circle}": 14, f"Edge{line}": 9}
    mesh = nmgs.fit(solid, entities=faces, counts=wanted).generate()
    ends = check_cover(solid, mesh)
    _, uses = np.unique(ends, axis=0, return_counts=True)
    assert (uses == 2).all()
    assert nodes_on(mesh, circle) == 14 and nodes_on(mesh, line) == 10


def test_counts_that_contradict_each_other_are_named():
    counts = {"Edge1": 5, "Edge2": 3, "Edge3": 8, "Edge4": 3}  # 19 segments: no quads fit in
    with pytest.raises(nmgs.BlockingError, match="Face1.*odd number") as caught:
        nmgs.fit(Part.makePlane(3, 2), counts=counts)
    assert set(counts) < set(caught.value.entities)


@pytest.mark.parametrize(
    "counts, words",
    [
        ({"Edge9": 3}, "Edge9"),
        ({"Face1": 3}, "Face1"),
        ({"Edge1": 0}, "Edge1"),
        ({"Edge1": 2.5}, "Edge1"),
    ],
)
def test_counts_that_make_no_sense_are_named(counts, words):
    with pytest.raises((ValueError, nmgs.GeometryError), match=words):
        nmgs.fit(Part.makePlane(3, 2), counts=counts)


def test_a_fit_can_be_cancelled():
    with pytest.raises(nmgs.Cancelled):
        nmgs.fit(plate_with_holes(), progress=lambda fraction: False)


CORPUS = Path(
    os.environ.get("NMGS_CORPUS", Path(__file__).resolve().parents[3] / "shared" / "corpus")
)


@pytest.mark.skipif(not (CORPUS / "cad").is_dir(), reason=f"no CAD files in {CORPUS}")
@pytest.mark.parametrize("file", ["meshkit/holycyl.stp", "meshkit/threeholecube.stp"])
def test_models_of_the_corpus(file):
    shape = Part.Shape()
    shape.read(str(CORPUS / "cad" / file))
    faces = [f"Face{n}" for n, face in enumerate(shape.Faces, 1) if face.isValid()]
    mesh = nmgs.fit(shape, entities=faces).generate()
    check_cover(shape, mesh)
    assert mesh.quality()["quad"].min() > 0.2
