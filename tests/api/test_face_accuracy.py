# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes lie on their faces, and areas of meshes over faces converge at their order."""

import math

import numpy as np
import pytest

import FreeCAD  # noqa: F401  (Part needs it)
import Part
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs


def flat_area(mesh):
    """Of the quads' two triangles by the diagonals' cross product."""
    p, q = mesh.points, mesh.cells["quad"]
    return (
        0.5 * np.linalg.norm(np.cross(p[q[:, 2]] - p[q[:, 0]], p[q[:, 3]] - p[q[:, 1]]), axis=1)
    ).sum()


def curved_area(mesh):
    """Of 8-node quads by 5 x 5 Gauss points (serendipity shape functions; Zienkiewicz, ch. 8)."""
    p = mesh.points[mesh.cells["quad8"]]
    places, weights = np.polynomial.legendre.leggauss(5)
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    total = 0.0
    for x, wx in zip(places, weights):
        for y, wy in zip(places, weights):
            d = np.zeros((2, 8))
            for k, (a, b) in enumerate(corners):
                d[0, k] = a * (1 + b * y) * (2 * a * x + b * y) / 4
                d[1, k] = b * (1 + a * x) * (2 * b * y + a * x) / 4
            d[0, [4, 6]] = -x * (1 - y), -x * (1 + y)
            d[1, [4, 6]] = -(1 - x * x) / 2, (1 - x * x) / 2
            d[0, [5, 7]] = (1 - y * y) / 2, -(1 - y * y) / 2
            d[1, [5, 7]] = -y * (1 + x), -y * (1 - x)
            du, dv = np.einsum("k,mki->mi", d[0], p), np.einsum("k,mki->mi", d[1], p)
            total += wx * wy * np.linalg.norm(np.cross(du, dv), axis=1).sum()
    return total


#: Faces whose areas are known without OpenCASCADE.
CLOSED_FORMS = {
    "sphere": (lambda: Part.makeSphere(2).Faces[0], 4 * math.pi * 4),
    "torus": (lambda: Part.makeTorus(3, 1).Faces[0], 4 * math.pi**2 * 3),
    "frustum": (lambda: Part.makeCone(2, 1, 3).Faces[0], math.pi * 3 * math.hypot(1, 3)),
    "disc": (lambda: Part.Face(Part.Wire(Part.makeCircle(2))), math.pi * 4),
}


@pytest.mark.parametrize("name", CLOSED_FORMS)
def test_areas_converge(name):
    make, exact = CLOSED_FORMS[name]
    face = make()
    flat, curved = [], []
    model = nmgs.fit(face, tolerance=face.BoundBox.DiagonalLength)
    start = np.ones_like(model.divisions)
    for n in (4, 8):
        model.divisions = n * start
        flat.append(abs(flat_area(model.generate()) / exact - 1))
        curved.append(abs(curved_area(model.generate(order=2)) / exact - 1))
    assert flat[1] < flat[0] / 2**1.8, flat
    assert curved[1] < curved[0] / 2**3.4, curved
    assert curved[1] < 1e-4


def spline_patch():
    surface = Part.BSplineSurface()
    surface.interpolate(
        [[Vector(i, j, 0.4 * math.sin(i) * math.cos(0.8 * j)) for j in range(7)] for i in range(7)]
    )
    return surface.toShape()


def half_round():
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(2, 0, 0), Vector(1, 0, 1), Vector(1.5, 0, 2.5), Vector(0.8, 0, 4)])
    return curve.toShape().revolve(Vector(0, 0, 0), Vector(0, 0, 1), 200).Faces[0]


#: Nodes of each are on the face by a closed form or by OpenCASCADE's distance.
SURFACES = {
    "spline": spline_patch,
    "revolution": half_round,
    "extrusion": lambda: Part.makeCircle(2, Vector(), Vector(0, 0, 1), 10, 200).extrude(
        Vector(1, 0, 3)
    ),
    "offset": lambda: spline_patch().makeOffsetShape(0.1, 1e-5).Faces[0],
    "torus": lambda: Part.makeTorus(3, 1).Faces[0],
    "cone with its tip": lambda: Part.makeCone(2, 0, 3).Faces[0],
    "drilled cylinder": lambda: max(
        Part.makeCylinder(2, 6)
        .cut(Part.makeCylinder(0.7, 6, Vector(0, 0, 3), Vector(1, 0, 0)))
        .Faces,
        key=lambda face: face.Area,
    ),
}


@pytest.mark.parametrize("order", (1, 2))
@pytest.mark.parametrize("name", SURFACES)
def test_all_nodes_lie_on_the_face(name, order):
    face = SURFACES[name]()
    size = face.BoundBox.DiagonalLength
    mesh = nmgs.fit(face, size=size / 20).generate(order=order)
    for point in mesh.points[:: max(1, len(mesh.points) // 250)]:
        assert face.distToShape(Part.Vertex(*point))[0] < 1e-7 * size


def test_a_closed_surface_with_a_gap_at_its_seam_is_not_refined_for_it():
    # Interpolated round and back to 1e-5 of where it began: OpenCASCADE calls it open, the face's
    # seam joins it; points near the seam have their foot on the other side of it.
    rings = []
    for j in range(4):
        ring = []
        for i in range(25):
            angle = 2 * math.pi * i / 24 * (1 - 1e-6)
            ring.append(Vector(2 * math.cos(angle), 2 * math.sin(angle), j))
        rings.append(ring)
    surface = Part.BSplineSurface()
    surface.interpolate(rings)
    face = surface.toShape()
    model = nmgs.fit(face)
    assert model.report[0]["error"] < 1e-3 * face.BoundBox.DiagonalLength
    assert len(model) < 100
    mesh = model.generate()
    assert mesh.quality()["quad"].min() > 0.5
    assert flat_area(mesh) == pytest.approx(face.Area, rel=0.01)
