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
