# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes on CAD faces; distances against the shapes' equations, volumes against closed forms."""

import FreeCAD  # noqa: F401
import numpy as np
import Part
import pytest
from tetgen_cases import check_mesh, cube

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.cad_snap import _smallest_jacobian


def on_face(mesh, name):
    kind, cells = mesh.groups[name]
    return mesh.points[np.unique(mesh.cells[kind][cells])]


@pytest.mark.parametrize("switches", ["pqa5", "pqo2a5"])
def test_sphere(switches):
    mesh = nmgs.tetrahedralize(Part.makeSphere(5), switches, deviation=0.1, snap=True)
    off = np.abs(np.linalg.norm(on_face(mesh, "Face1"), axis=1) - 5)
    corners_of = np.unique(
        mesh.cells["triangle" if "triangle" in mesh.cells else "triangle6"][:, :3]
    )
    assert np.abs(np.linalg.norm(mesh.points[corners_of], axis=1) - 5).max() < 1e-9
    # Mid-nodes of a sliver at the boundary may have to stay: a few, and no farther than before.
    assert (off < 1e-9).mean() > 0.95
    assert off.max() < 0.15
    kind = "tetra" if "tetra" in mesh.cells else "tetra10"
    assert _smallest_jacobian(mesh.points, mesh.cells[kind]).min() > 0
    check_mesh(mesh)


def test_nodes_of_slivers_get_there_too():
    """Where facets are coarse, tetrahedra of four boundary nodes turn inside out on the way."""
    mesh = nmgs.tetrahedralize(Part.makeSphere(5), "pq", deviation=0.3, snap=True)
    assert np.abs(np.linalg.norm(on_face(mesh, "Face1"), axis=1) - 5).max() < 1e-9
    check_mesh(mesh)


def test_cylinder_and_its_rims():
    shape = Part.makeCylinder(2, 3)
    mesh = nmgs.tetrahedralize(shape, "pqo2a0.1", deviation=0.05, snap=True)
    for number, face in enumerate(shape.Faces, 1):
        points = on_face(mesh, f"Face{number}")
        if "Cylinder" in face.Surface.TypeId:
            assert np.abs(np.hypot(points[:, 0], points[:, 1]) - 2).max() < 1e-9
        else:
            height = face.CenterOfMass.z
            assert np.abs(points[:, 2] - height).max() < 1e-9
            assert np.hypot(points[:, 0], points[:, 1]).max() < 2 + 1e-9
    assert _smallest_jacobian(mesh.points, mesh.cells["tetra10"]).min() > 0


def test_snapping_comes_nearer_in_volume():
    shape = Part.makeTorus(5, 1.5)
    plain = nmgs.tetrahedralize(shape, "pq", deviation=0.1)
    snapped = nmgs.tetrahedralize(shape, "pq", deviation=0.1, snap=True)
    errors = [
        abs(mesh.quality("volume")["tetra"].sum() / shape.Volume - 1) for mesh in (plain, snapped)
    ]
    assert errors[1] < errors[0]


def test_jacobian_of_straight_and_of_folded_tetrahedra():
    straight = nmgs.tetrahedralize(cube(), "pqo2a0.1")
    corners = nmgs.Mesh(straight.points, {"tetra": straight.cells["tetra10"][:, :4]})
    bounds = _smallest_jacobian(straight.points, straight.cells["tetra10"])
    exact = _smallest_jacobian(corners.points, corners.cells["tetra"])
    assert np.allclose(bounds, exact, rtol=1e-9)
    folded = straight.points.copy()
    cell = straight.cells["tetra10"][0]
    folded[cell[4]] = folded[cell[2]]
    assert _smallest_jacobian(folded, cell[None])[0] < 0


def test_only_cad_can_be_snapped_to():
    with pytest.raises(ValueError, match="snap"):
        nmgs.tetrahedralize(cube(), "pq", snap=True)
