# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh out of a file of another program can be split, reported, raised and refined."""

import numpy as np
import pytest
from element_meshes import unit
from tetgen_bounds import volume_bound

from freecad.NMGSWorkbench import nmgs


@pytest.mark.parametrize("format", ("msh", "msh22", "med", "unv", "vtu", "vtk", "inp", "bdf", "su2",
                                    "gid", "elmer", "polyMesh"))  # fmt: skip
def test_hexahedra(format, tmp_path):
    path = tmp_path / (format if format == "polyMesh" else f"mesh.{format}")
    nmgs.write(path, unit("hexahedron", amount=0), format=format)
    mesh = nmgs.read(path, format=format)
    report = mesh.report()
    assert report.volume == pytest.approx(1)
    tets = nmgs.Mesh(mesh.points, {"hexahedron": mesh.cells["hexahedron"]}).split()
    assert len(tets.cells["tetra"]) == 12 * 8
    assert tets.quality("volume")["tetra"].sum() == pytest.approx(1)
    raised = mesh.to_order(2)
    assert len(raised.cells["hexahedron20"]) == 8


@pytest.mark.parametrize(
    "format", ("msh", "med", "unv", "vtu", "inp", "bdf", "su2", "gid", "elmer")
)
def test_tetrahedra_are_refined_by_tetgen(format, tmp_path):
    path = tmp_path / f"mesh.{format}"
    nmgs.write(path, unit("tetra", amount=0), format=format)
    mesh = nmgs.read(path, format=format)
    fine = nmgs.tetrahedralize(nmgs.Mesh(mesh.points, {"tetra": mesh.cells["tetra"]}), "rqa0.002")
    assert len(fine.cells["tetra"]) > 400
    volumes = fine.quality("volume")["tetra"]
    assert volumes.sum() == pytest.approx(1) and volumes.max() <= volume_bound(0.002)


def test_surfaces_become_volumes(tmp_path):
    for format in ("stl", "ply", "obj", "msh"):
        path = tmp_path / f"mesh.{format}"
        nmgs.write(path, unit("tetra", amount=0).boundary(), format=format)
        mesh = nmgs.tetrahedralize(nmgs.read(path), "pq")
        assert mesh.quality("volume")["tetra"].sum() == pytest.approx(1)
        assert np.isfinite(mesh.points).all()
