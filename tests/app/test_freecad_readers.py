# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our MED and UNV files, read by FreeCAD's own readers: cells, orientation, groups."""

import Fem
import numpy as np
import pytest
from element_meshes import mixed

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem.from_fem_mesh import mesh_of


@pytest.mark.parametrize("order", (1, 2))
@pytest.mark.parametrize("format", ("med", "unv"))
def test_freecad_reads_it(format, order, tmp_path):
    mesh = mixed(order)
    if format == "unv":
        cells = {k: v for k, v in mesh.cells.items() if not k.startswith("pyramid")}
        mesh = nmgs.Mesh(mesh.points, cells, mesh.groups)
    path = tmp_path / f"mesh.{format}"
    nmgs.write(path, mesh)
    fem = Fem.read(str(path))
    assert [fem.HexaCount, fem.PrismCount, fem.TetraCount] == [2, 2, 10]
    assert fem.PyramidCount == (7 if format == "med" else 0)
    assert (fem.NodeCount, fem.FaceCount, fem.EdgeCount) == (len(mesh.points), 1, 2)
    back = mesh_of(fem)
    for kind, cells in mesh.cells.items():
        if kind.startswith(("hexa", "wedge", "pyramid", "tetra")):
            assert (back.quality("scaled_jacobian")[kind] > 0.5).all()
            ours, theirs = sorted(map(set, cells.tolist()), key=sorted), back.cells[kind].tolist()
            assert ours == sorted(map(set, theirs), key=sorted)
    assert set(back.groups) == set(mesh.groups)


def test_we_read_freecads_own_med(tmp_path):
    from freecad.NMGSWorkbench.fem.fem_mesh import fem_mesh

    mesh = mixed(2)
    path = tmp_path / "mesh.med"
    fem_mesh(mesh).write(str(path))
    back = nmgs.read(path)
    assert np.array_equal(back.points, mesh.points)
    for kind, cells in mesh.cells.items():
        if kind.startswith(("hexa", "wedge", "pyramid", "tetra")):
            assert (back.quality()[kind] > 0.5).all() and len(back.cells[kind]) == len(cells)
    assert set(back.groups) == set(mesh.groups)
