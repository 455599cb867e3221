# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ready-made shapes: valid blocks, nodes on the true shape, measures that converge."""

import math

import numpy as np
import pytest
from block_helpers import (
    edge_counts,
    euler_of_solid,
    euler_of_surface,
    face_counts,
    hexahedron_volumes,
    quad_areas,
    quad_normals,
)

from freecad.NMGSWorkbench import nmgs

PI = math.pi
# name: (arguments, closed form of area or volume, Euler characteristic, order of convergence)
CASES = {
    "square": (dict(size=(2, 3)), 6, 1, None),
    "disc": (dict(radius=2), 4 * PI, 1, 4),
    "cylinder_surface": (dict(radius=2, height=3), 12 * PI, 0, 4),
    "cone_surface": (dict(radius=3, height=4), 15 * PI, 1, 2),
    "hemisphere": (dict(radius=2), 8 * PI, 1, 4),
    "sphere_surface": (dict(radius=2), 16 * PI, 2, 4),
    "torus_surface": (dict(radius=3, tube_radius=1), 12 * PI * PI, 0, 4),
    "cube": (dict(size=2), 8, 1, None),
    "box": (dict(length=2, width=3, height=4), 24, 1, None),
    "cylinder": (dict(radius=2, height=3), 12 * PI, 1, 4),
    "cone": (dict(radius=3, height=4), 12 * PI, 1, 2),
    "tube": (dict(radius=2, inner_radius=1, height=3), 9 * PI, 0, 4),
    "ball": (dict(radius=2), 32 / 3 * PI, 1, 4),
    "half_ball": (dict(radius=2), 16 / 3 * PI, 1, 4),
    "torus": (dict(radius=3, tube_radius=1), 6 * PI * PI, 0, 4),
    "wedge": (dict(length=2, width=3, height=4), 12, 1, None),
}
SOLIDS = [name for name in CASES if nmgs.shapes.NAMES.index(name) >= 7]


def shape(name, **more):
    return getattr(nmgs.shapes, name)(**CASES[name][0], **more)


def measure(mesh):
    if "quad" in mesh.cells:
        return quad_areas(mesh.points, mesh.cells["quad"]).sum()
    return hexahedron_volumes(mesh.points, mesh.cells["hexahedron"]).sum()


def test_names_are_complete():
    assert set(nmgs.shapes.NAMES) == set(CASES)


@pytest.mark.parametrize("name", CASES)
def test_blocks_have_no_problems(name):
    model = shape(name)
    assert model.check() == []
    assert model.dimension == (3 if name in SOLIDS else 2)


@pytest.mark.parametrize("name", CASES)
def test_topology(name):
    mesh = shape(name, divisions=3).generate()
    if name in SOLIDS:
        cells = mesh.cells["hexahedron"]
        assert euler_of_solid(cells) == CASES[name][2]
        assert face_counts(cells)[1].max() == 2
        assert hexahedron_volumes(mesh.points, cells).min() > 0
    else:
        cells = mesh.cells["quad"]
        assert euler_of_surface(cells) == CASES[name][2]
        assert edge_counts(cells)[1].max() == 2
    assert len(np.unique(np.round(mesh.points, 9), axis=0)) == len(mesh.points)


@pytest.mark.parametrize("name", [n for n in CASES if CASES[n][3] is None])
def test_flat_shapes_are_exact(name):
    assert measure(shape(name).generate()) == pytest.approx(CASES[name][1], rel=1e-13)


@pytest.mark.parametrize("name", [n for n in CASES if CASES[n][3]])
def test_curved_shapes_converge_to_the_closed_form(name):
    """At fixed blocks the mesh converges to the blocks' own measure, by Richardson's extrapolation;
    with more pieces that meets the closed form at the order of the blocks."""
    _, exact, _, order = CASES[name]

    def own(pieces):
        coarse, fine = (measure(shape(name, divisions=n, pieces=pieces).generate()) for n in (2, 4))
        return fine + (fine - coarse) / 3

    errors = [abs(own(pieces) - exact) / exact for pieces in (1, 2, 4)]
    assert errors[1] < errors[0] / 2**order * 1.7
    assert errors[2] < errors[1] / 2**order * 1.7
    assert errors[2] < 2e-3


@pytest.mark.parametrize("pieces", [1, 2])
def test_nodes_are_on_the_true_shape(pieces):
    for name in ("hemisphere", "sphere_surface"):
        nodes = shape(name, pieces=pieces).nodes.reshape(-1, 3)
        np.testing.assert_allclose(np.linalg.norm(nodes, axis=1), 2, rtol=1e-14)
    nodes = shape("cylinder_surface", pieces=pieces).nodes
    np.testing.assert_allclose(np.hypot(nodes[..., 0], nodes[..., 1]), 2, rtol=1e-14)
    nodes = shape("torus_surface", pieces=pieces).nodes
    ring = np.hypot(nodes[..., 0], nodes[..., 1]) - 3
    np.testing.assert_allclose(np.hypot(ring, nodes[..., 2]), 1, rtol=1e-14)
    nodes = shape("cone_surface", pieces=pieces).nodes
    np.testing.assert_allclose(
        np.hypot(nodes[..., 0], nodes[..., 1]), 3 * (1 - nodes[..., 2] / 4), atol=1e-14
    )


def test_boundaries_of_solids_are_on_the_true_shape():
    outer = nmgs.shapes.ball(radius=2, divisions=1).generate().boundary()
    np.testing.assert_allclose(np.linalg.norm(outer.points, axis=1), 2, rtol=1e-14)


@pytest.mark.parametrize("name", ["hemisphere", "sphere_surface", "torus_surface"])
def test_surfaces_face_outward(name):
    mesh = shape(name).generate()
    middle = mesh.points[mesh.cells["quad"]].mean(axis=1)
    outward = middle.copy()
    if name == "torus_surface":
        ring = middle * [1, 1, 0]
        outward -= 3 * ring / np.linalg.norm(ring, axis=1, keepdims=True)
    assert ((quad_normals(mesh.points, mesh.cells["quad"]) * outward).sum(axis=1) > 0).all()


def test_hemisphere_has_the_thesis_five_patches():
    assert len(nmgs.shapes.hemisphere()) == 5


def test_caps_close_the_cylinder():
    mesh = nmgs.shapes.cylinder_surface(caps=True).generate()
    assert euler_of_surface(mesh.cells["quad"]) == 2
    assert edge_counts(mesh.cells["quad"])[1].min() == 2


def test_divisions_each():
    model = nmgs.shapes.cylinder(divisions=(2, 3, 4))
    assert len(model.generate().cells["hexahedron"]) == (2 * 2 + 4 * 2 * 3) * 4


@pytest.mark.parametrize(
    "call, argument",
    [
        (lambda: nmgs.shapes.disc(radius=0), "radius"),
        (lambda: nmgs.shapes.disc(radius=float("nan")), "radius"),
        (lambda: nmgs.shapes.ball(radius=-1), "radius"),
        (lambda: nmgs.shapes.tube(radius=1, inner_radius=1), "inner_radius"),
        (lambda: nmgs.shapes.torus(radius=1, tube_radius=2), "tube_radius"),
        (lambda: nmgs.shapes.cube(divisions=0), "divisions"),
        (lambda: nmgs.shapes.cube(divisions=(1, 2)), "divisions"),
        (lambda: nmgs.shapes.cube(divisions=1.5), "divisions"),
        (lambda: nmgs.shapes.cube(pieces=0), "pieces"),
    ],
)
def test_bad_arguments_are_named(call, argument):
    with pytest.raises(ValueError, match=argument):
        call()
