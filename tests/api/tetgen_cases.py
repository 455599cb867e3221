# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inputs for TetGen, and what must hold for every mesh that comes back."""

import os
import pathlib
import shutil
import subprocess
from fractions import Fraction

import numpy as np

from freecad.NMGSWorkbench import nmgs

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPUS = pathlib.Path(os.environ.get("NMGS_CORPUS", ROOT.parent / "shared" / "corpus")) / "tetgen"

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
#: Outwards.
CUBE_FACETS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]

FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]  # of a tetrahedron, outwards


def cube(size=1.0, at=(0, 0, 0), **options):
    """A cube as PLC of six quads."""
    return nmgs.PLC(size * CUBE + np.asarray(at, float), CUBE_FACETS, **options)


def together(*plcs):
    """Several PLCs as one, without holes and regions."""
    points, facets = [], []
    for plc in plcs:
        first = sum(len(p) for p in points)
        points.append(plc.points)
        facets += [[(ring + first).tolist() for ring in plc.facet(f)] for f in range(len(plc))]
    return nmgs.PLC(np.concatenate(points), facets)


def rotation(random):
    """A random rotation matrix."""
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def crossing_plc(seed):
    """Two or three boxes, turned at random, that go through each other."""
    random = np.random.default_rng(seed)
    parts = []
    for _ in range(random.integers(2, 4)):
        part = cube()
        shape = random.uniform(0.6, 1.4, 3)
        part.points = (part.points - 0.5) * shape @ rotation(random).T
        part.points = part.points + random.uniform(-0.2, 0.2, 3)
        parts.append(part)
    return together(*parts)


def corners(mesh):
    """Corner nodes of the tetrahedra."""
    return mesh.cells["tetra"] if "tetra" in mesh.cells else mesh.cells["tetra10"][:, :4]


def volumes(points, tetra):
    a, b, c, d = (points[tetra[:, n]] for n in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6


def exact_volume_sign(points, tetra):
    """Sign of one tetrahedron's volume in rational arithmetic."""
    a, b, c, d = ([Fraction(v) for v in points[n].tolist()] for n in tetra)
    u, v, w = ([x - y for x, y in zip(p, a)] for p in (b, c, d))
    return (
        u[0] * (v[1] * w[2] - v[2] * w[1])
        - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
    )


def surface_volume(plc):
    """Volume inside a closed, consistently oriented PLC of plain polygons (divergence theorem)."""
    total = 0.0
    middle = plc.points.mean(axis=0)
    for f in range(len(plc)):
        for ring in plc.facet(f):
            p = plc.points[ring] - middle
            for k in range(1, len(p) - 1):
                total += np.linalg.det([p[0], p[k], p[k + 1]]) / 6
    return abs(total)


def check_mesh(mesh, volume=None, hull=False):
    """Positive tetrahedra that meet face to face; the mesh's boundary is among its triangles."""
    tetra = corners(mesh)
    volume_of = volumes(mesh.points, tetra)
    for doubtful in np.flatnonzero(volume_of <= 1e-12 * volume_of.max()):
        assert exact_volume_sign(mesh.points, tetra[doubtful]) > 0
    faces = np.sort(np.concatenate([tetra[:, f] for f in FACES]), axis=1)
    unique, counts = np.unique(faces, axis=0, return_counts=True)
    assert counts.max() <= 2
    if not hull:  # -c makes a boundary that is no facet
        _check_boundary(mesh, unique[counts == 1])
    if volume is not None:
        assert abs(volume_of.sum() - volume) <= 1e-9 * volume


def _check_boundary(mesh, outer):
    kind = "triangle" if "triangle" in mesh.cells else "triangle6"
    known = {tuple(t) for t in np.sort(mesh.cells[kind][:, :3], axis=1).tolist()}
    assert {tuple(t) for t in outer.tolist()} <= known


def check_facets_present(mesh, plc):
    """Every facet's area is covered by triangles of the mesh with its marker."""
    kind = "triangle" if "triangle" in mesh.cells else "triangle6"
    triangles = mesh.cells[kind][:, :3]
    p = mesh.points[triangles]
    areas = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2
    for f in range(len(plc)):
        ring = plc.points[plc.facet(f)[0]]
        normal = sum(
            np.cross(ring[k] - ring[0], ring[k + 1] - ring[0]) for k in range(1, len(ring) - 1)
        )
        own = mesh.tetgen.triangle_markers == plc.markers[f]
        assert abs(areas[own].sum() - np.linalg.norm(normal) / 2) <= 1e-9 * np.linalg.norm(normal)


def program(folder, path, switches, timeout=600):
    """Mesh of the tetgen program for a copy of a file, or None when it fails or leaves none."""
    name = pathlib.Path(path).name
    shutil.copy(path, folder)
    node = pathlib.Path(path).with_suffix(".node")
    if name.endswith(".ele") and node.exists():
        shutil.copy(node, folder)
    done = subprocess.run(
        ["tetgen", "-" + switches, name], cwd=folder, capture_output=True, timeout=timeout
    )
    results = sorted(pathlib.Path(folder).glob("*.1.ele"))
    return nmgs.read(results[0]) if done.returncode == 0 and results else None


def same_mesh(ours, program_mesh):
    """Node for node: the program prints 17 digits (16 for some), so coordinates are compared so."""
    kind = "tetra" if "tetra" in program_mesh.cells else "tetra10"
    return (
        kind in ours.cells
        and np.array_equal(ours.cells[kind], program_mesh.cells[kind])
        and ours.points.shape == program_mesh.points.shape
        and np.allclose(ours.points, program_mesh.points, rtol=1e-15, atol=0)
    )


def corpus_files(*extensions):
    """Files of the corpus with these endings; none where it is absent."""
    return sorted(p for p in CORPUS.rglob("*") if p.suffix.lstrip(".") in extensions)
