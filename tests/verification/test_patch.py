# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch test and rigid body modes of every element type in distorted meshes, by CalculiX.

A linear displacement on the boundary of the unit cube must come out linear inside, with its one
stress everywhere (Irons; MacNeal and Harder 1985). A free body has six modes of no energy, a plane
one three, and no others: a seventh would be an element that resists nothing.
"""

import calculix
import numpy as np
import pytest
from element_meshes import KINDS, mixed, unit

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.mesh import CELL_TYPES

pytestmark = pytest.mark.skipif(bool(calculix.MISSING), reason=calculix.MISSING)

YOUNG, POISSON = 1000.0, 0.25
#: Gradient of MacNeal and Harder's field, all components at once.
GRADIENT = 1e-3 * np.array([[1, 0.5, 0.3], [0.5, 1, 0.2], [0.1, 0.6, 1]])


def stress_of(gradient, plane):
    strain = (gradient + gradient.T) / 2
    shear = YOUNG / (2 * (1 + POISSON))
    lame = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    if plane:
        strain = strain.copy()
        strain[2, :] = strain[:, 2] = 0
        # No stress across the plane.
        strain[2, 2] = -POISSON / (1 - POISSON) * (strain[0, 0] + strain[1, 1])
    s = 2 * shear * strain + lame * np.trace(strain) * np.eye(3)
    return np.array([s[0, 0], s[1, 1], s[2, 2], s[0, 1], s[1, 2], s[0, 2]])


def boundary_nodes(mesh):
    faces = mesh.boundary()
    places = {tuple(p) for p in faces.points}
    return [n for n, p in enumerate(mesh.points) if tuple(p) in places]


def meshes(kind):
    if kind.startswith("mixed"):
        whole = mixed(2 if kind == "mixed quadratic" else 1)
        cells = {k: v for k, v in whole.cells.items() if CELL_TYPES[k][1] == 3}
        return nmgs.Mesh(whole.points, cells)
    return unit(kind)


@pytest.mark.parametrize("kind", KINDS + ("mixed linear", "mixed quadratic"))
def test_patch(kind):
    mesh = meshes(kind)
    plane = "stress" if CELL_TYPES[next(iter(mesh.cells))][1] == 2 else None
    wanted = mesh.points @ GRADIENT.T
    free = set(range(len(mesh.points))) - set(boundary_nodes(mesh))
    assert free or kind == "mixed linear" or kind == "triangle6"
    directions = 2 if plane else 3
    held = [
        (n, d, wanted[n, d]) for n in range(len(wanted)) if n not in free for d in range(directions)
    ]
    result = calculix.solve(mesh, YOUNG, POISSON, held, plane=plane)
    scale = np.abs(wanted).max()
    # CalculiX prints seven digits of displacements, six of stresses.
    error = np.abs(result.displacement - wanted)[:, :directions].max() / scale
    assert error < 1e-5
    stress = stress_of(GRADIENT, plane)
    checked = [0, 1, 3] if plane else list(range(6))
    assert np.abs(result.stress - stress)[:, checked].max() < 1e-4 * np.abs(stress).max()


@pytest.mark.parametrize("kind", KINDS)
def test_rigid_body_modes(kind):
    mesh = unit(kind)
    plane = "stress" if CELL_TYPES[kind][1] == 2 else None
    rigid = 3 if plane else 6
    modes = rigid + 2
    f = calculix.solve(mesh, YOUNG, POISSON, [], density=1.0, modes=modes, plane=plane).frequencies
    assert len(f) == modes
    assert (f[:rigid] < 1e-3 * f[rigid]).all() and f[rigid] > 0.1 * np.sqrt(YOUNG) / (2 * np.pi)
