# SPDX-License-Identifier: LGPL-2.1-or-later
"""Metrics of quadratic cells, against sampled shape functions and closed forms."""

import itertools

import numpy as np
import pytest
from blocks import CORNERS_2D, NATURAL_2D, NATURAL_3D, bent_blocks

from freecad.NMGSWorkbench import nmgs

TRIANGLE = np.array([[0, 0], [1, 0], [0, 1]], dtype=float)
TETRA = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
TETRA_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]


def monomials(name: str) -> np.ndarray:
    """Exponents that span the shape functions of the type, and thus define them."""
    if name == "triangle6":
        return np.array([e for e in itertools.product(range(3), repeat=2) if sum(e) <= 2])
    if name == "tetra10":
        return np.array([e for e in itertools.product(range(3), repeat=3) if sum(e) <= 2])
    d = 2 if name == "quad8" else 3
    # Serendipity: degree above the linear ones at most 2.
    return np.array(
        [e for e in itertools.product(range(3), repeat=d) if sum(x for x in e if x > 1) <= 2]
    )


NODES = {
    "triangle6": np.vstack(
        [TRIANGLE, [(TRIANGLE[i] + TRIANGLE[(i + 1) % 3]) / 2 for i in range(3)]]
    ),
    "tetra10": np.vstack([TETRA, [(TETRA[a] + TETRA[b]) / 2 for a, b in TETRA_EDGES]]),
    "quad8": NATURAL_2D,
    "hexahedron20": NATURAL_3D,
}
REFERENCE = {"triangle6": 1 / 2, "quad8": 4, "tetra10": 1 / 6, "hexahedron20": 8}


def samples(name: str, n: int = 13) -> np.ndarray:
    d = NODES[name].shape[1]
    if name in ("quad8", "hexahedron20"):
        return np.array(list(itertools.product(np.linspace(-1, 1, n), repeat=d)))
    grid = np.array(list(itertools.product(np.linspace(0, 1, n), repeat=d)))
    return grid[grid.sum(axis=1) <= 1 + 1e-12]


def tangents(name: str, points: np.ndarray) -> np.ndarray:
    """(cell, sample, direction, xyz): derivatives of the interpolation, from its monomials."""
    exponents = monomials(name)
    at = samples(name)
    vandermonde = np.prod(NODES[name][:, None] ** exponents, axis=2)
    coefficients = np.linalg.inv(vandermonde)  # (monomial, node)
    out = []
    for d in range(at.shape[1]):
        lower = exponents.copy()
        lower[:, d] = np.maximum(lower[:, d] - 1, 0)
        slope = exponents[:, d] * np.prod(at[:, None] ** lower, axis=2)
        out.append(np.einsum("sm,mn,cnx->csx", slope, coefficients, points))
    return np.stack(out, axis=2)


def random_cells(name: str, amplitude: float, count: int = 40) -> np.ndarray:
    rng = np.random.default_rng(3)
    nodes = np.zeros((len(NODES[name]), 3))
    nodes[:, : NODES[name].shape[1]] = NODES[name]
    size = 2.0 if name in ("quad8", "hexahedron20") else 1.0
    moves = rng.uniform(-amplitude, amplitude, (count, *nodes.shape)) * size
    if NODES[name].shape[1] == 2:
        moves[:, :, 2] *= 0.3
    return nodes * rng.uniform(0.5, 2, (count, 1, 3)) + moves


def mesh_of(name: str, points: np.ndarray) -> nmgs.Mesh:
    cells = np.arange(points.shape[0] * points.shape[1]).reshape(points.shape[:2])
    return nmgs.Mesh(points.reshape(-1, 3), {name: cells})


def sampled(name: str, points: np.ndarray):
    """Jacobian and Verdict's scaled Jacobian of the tangents at the samples."""
    t = tangents(name, points)
    if t.shape[2] == 2:
        normal = np.cross(t[:, :, 0], t[:, :, 1])
        # Gauss points of the mean are not needed: the boundary alone fixes the vector area.
        mean = vector_area(name, points)
        j = np.einsum("csx,cx->cs", normal, mean / np.linalg.norm(mean, axis=1)[:, None])
    else:
        j = np.linalg.det(t)
    length = np.linalg.norm(t, axis=3)
    if name == "triangle6":
        third = np.linalg.norm(t[:, :, 1] - t[:, :, 0], axis=2)
        a, b = length[:, :, 0], length[:, :, 1]
        return j, 2 / 3**0.5 * j / np.max([a * b, b * third, third * a], axis=0)
    if name == "tetra10":
        x = [np.zeros_like(t[:, :, 0]), t[:, :, 0], t[:, :, 1], t[:, :, 2]]
        products = [
            np.prod([np.linalg.norm(x[a] - x[b], axis=2) for b in range(4) if b != a], axis=0)
            for a in range(4)
        ]
        return j, 2**0.5 * j / np.max(products, axis=0)
    return j, j / length.prod(axis=2)


def vector_area(name: str, points: np.ndarray) -> np.ndarray:
    """Half the integral of x cross dx round a boundary of parabolas (degree 3: Simpson's rule)."""
    corners = 3 if name == "triangle6" else 4
    area = np.zeros((len(points), 3))
    for i in range(corners):
        a, b, m = points[:, i], points[:, (i + 1) % corners], points[:, corners + i]
        for t, w in ((0, 1 / 6), (0.5, 4 / 6), (1, 1 / 6)):
            x = (1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * m + t * (2 * t - 1) * b
            dx = (4 * t - 3) * a + (4 - 8 * t) * m + (4 * t - 1) * b
            area += 0.5 * w * np.cross(x, dx)
    return area


@pytest.mark.parametrize("name", NODES)
@pytest.mark.parametrize("amplitude", [0.03, 0.08, 0.25])
def test_bounds_hold_over_the_whole_cell_and_are_tight(name, amplitude):
    points = random_cells(name, amplitude)
    mesh = mesh_of(name, points)
    jacobian, scaled = sampled(name, points)
    least = REFERENCE[name] * jacobian.min(axis=1)
    size = REFERENCE[name] * np.abs(jacobian).max(axis=1)
    ours = mesh.quality("min_jacobian")[name]
    assert (ours <= least + 1e-12).all()
    # The samples are 1/12 of the cell apart: near the minimum they can miss little.
    assert (ours - least) / size == pytest.approx(0, abs=0.04)
    scaled_bound = mesh.quality("scaled_jacobian")[name]
    assert (scaled_bound <= scaled.min(axis=1) + 1e-12).all()
    if amplitude < 0.1:
        assert scaled_bound == pytest.approx(scaled.min(axis=1), abs=0.08)
    ratio = mesh.quality("jacobian_ratio")[name]
    good = least > 0
    assert (ratio <= jacobian.min(axis=1) / jacobian.max(axis=1) + 1e-12)[good].all()
    assert (ratio[~good] <= 0).all()


@pytest.mark.parametrize("name, corners", [("triangle6", 3), ("tetra10", 4)])
def test_straight_simplices_have_verdicts_value(name, corners):
    points = random_cells(name, 0.1)[:, :corners]
    linear = mesh_of({"triangle6": "triangle", "tetra10": "tetra"}[name], points)
    raised = linear.to_order(2)
    assert raised.quality()[name] == pytest.approx(list(linear.quality().values())[0])
    assert raised.quality("jacobian_ratio")[name] == pytest.approx(1)


def test_undistorted_cells():
    for name, natural in (("quad8", NATURAL_2D), ("hexahedron20", NATURAL_3D)):
        points = np.zeros((1, len(natural), 3))
        points[0, :, : natural.shape[1]] = natural * [3, 2, 5][: natural.shape[1]]
        mesh = mesh_of(name, points)
        assert mesh.quality()[name] == pytest.approx([1])
        size = 8 * 30 if name == "hexahedron20" else 4 * 6
        assert mesh.quality("min_jacobian")[name] == pytest.approx([size])
        assert mesh.quality("jacobian_ratio")[name] == pytest.approx([1])


def test_fold_between_the_nodes_is_found():
    """The Jacobian is positive at all eight nodes, and negative on the side between two of them."""
    nodes = np.zeros((1, 8, 3))
    nodes[0, :, :2] = NATURAL_2D
    nodes[0, 4, 0] = 0.45
    j, _ = sampled("quad8", nodes)
    at_nodes = []
    for node in NATURAL_2D:
        nearest = np.argmin(np.abs(samples("quad8") - node).sum(axis=1))
        at_nodes.append(j[0, nearest])
    nodes[0, 4, 0] = 0.55
    mesh = mesh_of("quad8", nodes)
    assert mesh.quality()["quad8"][0] < 0
    assert min(at_nodes) > 0


def test_volume_is_exact():
    """A map of total degree 2 is in the space of the hexahedron20, its determinant integrable."""
    model = bent_blocks((1, 1, 1))
    mesh = model.generate().to_order(2)
    assert (np.sort(mesh.cells["hexahedron20"], axis=1)[:, -1] < len(mesh.points)).all()
    # x + 0.2 y^2, y + 0.15 z^2, z + 0.1 (x^2 - y^2) at x = X + shift, in [-1, 1]^3: determinant
    # 1 + 0.3 z * 0.2 y + 0.3 z * (0.04 x y + 0.2 y), of which only the 1 has a mean.
    assert mesh.quality("volume")["hexahedron20"] == pytest.approx([8, 8])


def test_area_and_length_of_a_parabola():
    nodes = np.zeros((1, 8, 3))
    nodes[0, :, :2] = NATURAL_2D
    nodes[0, :, 2] = nodes[0, :, 0] ** 2
    arc = 2 * (5**0.5 / 2 + np.arcsinh(2) / 4)  # of z = x^2 from -1 to 1
    assert mesh_of("quad8", nodes).quality("area")["quad8"] == pytest.approx([2 * arc], rel=5e-4)
    line = nmgs.Mesh([[-1, 0, 1], [1, 0, 1], [0, 0, 0]], {"line3": [[0, 1, 2]]})
    assert line.quality("length")["line3"] == pytest.approx([arc], rel=5e-4)
    assert len(CORNERS_2D) == 4
