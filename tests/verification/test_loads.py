# SPDX-License-Identifier: LGPL-2.1-or-later
"""The suite's own forces: a pressure's resultant is the area's, a twist's moment the torque."""

import numpy as np
import pytest
from element_meshes import unit
from loads import faces_where, forces, nodes_of


@pytest.mark.parametrize("kind", ("hexahedron20", "tetra10"))
def test_resultants(kind):
    mesh = unit(kind, amount=0.05)
    top = faces_where(mesh, lambda p: p[:, 2] > 1 - 1e-9)
    assert (mesh.points[nodes_of(top), 2] > 1 - 1e-9).all()
    pressed = forces(mesh, top, lambda p, n: -n)
    assert pressed.sum(axis=0) == pytest.approx([0, 0, -1])
    arm = mesh.points - [0.5, 0.5, 0]
    turned = forces(mesh, top, lambda p, n: np.cross([0, 0, 1], p - [0.5, 0.5, 0]))
    # The polar moment of the unit square is 1/6.
    assert np.cross(arm, turned).sum(axis=0)[2] == pytest.approx(1 / 6)
    assert turned.sum(axis=0) == pytest.approx([0, 0, 0], abs=1e-12)


@pytest.mark.parametrize("kind", ("hexahedron20", "tetra10"))
def test_a_closed_surface_has_no_resultant(kind):
    mesh = unit(kind)
    every = faces_where(mesh, lambda p: np.full(len(p), True))
    pressed = forces(mesh, every, lambda p, n: n)
    assert pressed.sum(axis=0) == pytest.approx([0, 0, 0], abs=1e-12)
    assert (mesh.points * pressed).sum() == pytest.approx(3)
