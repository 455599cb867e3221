# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fem.FemMesh of every cell type: counts, numbers, order of nodes, boundary, groups, cancelling."""

import FreeCAD
import numpy as np
import pytest
from element_meshes import KINDS, MIXED_VOLUME, mixed, unit

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem.fem_mesh import NODE_ORDER, fem_mesh
from freecad.NMGSWorkbench.fem.from_fem_mesh import mesh_of
from freecad.NMGSWorkbench.nmgs.mesh import CELL_TYPES

COUNTS = ("HexaCount", "PyramidCount", "PrismCount", "TetraCount")
#: Mid-side node k of an element in a FemMesh halves the edge of these corners, 0-based: the order
#: of MED's elements, which FemMesh keeps.
MIDDLES = {
    "hexahedron20": "01 12 23 30 45 56 67 74 04 15 26 37",
    "wedge15": "01 12 20 34 45 53 03 14 25",
    "pyramid13": "01 12 23 30 04 14 24 34",
    "tetra10": "01 12 20 03 13 23",
    "quad8": "01 12 23 30",
    "triangle6": "01 12 20",
}


@pytest.mark.parametrize("kind", KINDS)
def test_there_and_back(document, kind):
    mesh = unit(kind)
    fem = nmgs.to_fem(mesh, document).FemMesh
    assert fem.NodeCount == len(mesh.points)
    assert fem.FaceCount == (len(mesh.cells[kind]) if CELL_TYPES[kind][1] == 2 else outer(mesh))
    assert sum(getattr(fem, c) for c in COUNTS) == fem.VolumeCount
    back = mesh_of(fem)
    assert np.array_equal(back.points, mesh.points)
    assert set(back.cells) == {kind} and np.array_equal(back.cells[kind], mesh.cells[kind])


def outer(mesh):
    return sum(len(nodes) for nodes in mesh.boundary().cells.values())


@pytest.mark.parametrize("kind", KINDS)
def test_order_of_nodes(kind):
    """SMESH's convention, that of MED: the base of a volume is seen from outside; CalculiX (in the
    verification suite) and Jacobian signs say the same of all that FEM writes."""
    mesh = unit(kind)
    fem = fem_mesh(mesh)
    dimension = CELL_TYPES[kind][1]
    elements = fem.Volumes if dimension == 3 else fem.Faces
    points = np.array([tuple(fem.Nodes[n]) for n in range(1, fem.NodeCount + 1)])
    for number in elements:
        p = points[np.array(fem.getElementNodes(number)) - 1]
        if dimension == 3:
            base = 3 if kind.startswith(("tetra", "wedge")) else 4
            inside = p.mean(axis=0) - p[:base].mean(axis=0)
            assert np.cross(p[1] - p[0], p[2] - p[0]) @ inside < 0
        pairs = MIDDLES.get(kind, "").split()
        for k, (a, b) in enumerate(pairs, len(p) - len(pairs)):
            assert p[k] == pytest.approx((p[int(a)] + p[int(b)]) / 2)


@pytest.mark.parametrize("order", (1, 2))
def test_mixed_cells(document, order):
    mesh = mixed(order)
    fem = nmgs.to_fem(mesh, document).FemMesh
    assert [getattr(fem, c) for c in COUNTS] == [2, 7, 2, 10]
    assert fem.FaceCount == outer(mesh) and fem.EdgeCount == 2
    back = mesh_of(fem)
    assert sum(v.sum() for v in back.quality("volume").values()) == pytest.approx(MIXED_VOLUME)
    assert set(back.groups) == set(mesh.groups)
    for name, (kind, indices) in mesh.groups.items():
        found_kind, found = back.groups[name]
        assert found_kind == kind
        if kind == "node":
            assert found.tolist() == indices.tolist()
        else:
            assert np.array_equal(back.cells[kind][found], mesh.cells[kind][indices])


def test_order_table_has_every_volume_and_permutes():
    volumes = {name for name, (_, dimension) in CELL_TYPES.items() if dimension == 3}
    assert set(NODE_ORDER) == volumes
    for name, order in NODE_ORDER.items():
        assert sorted(order) == list(range(CELL_TYPES[name][0]))


def test_cancelled_leaves_the_document_as_it_was(document):
    mesh = nmgs.shapes.cube(divisions=30).generate()
    seen = []

    def stop(fraction):
        seen.append(fraction)
        return len(seen) < 3

    with pytest.raises(nmgs.Cancelled):
        nmgs.to_fem(mesh, document, progress=stop)
    assert document.Objects == [] and len(seen) == 3


def test_progress_comes_in_small_slices(document):
    mesh = nmgs.shapes.cube(divisions=30).generate()
    seen = []
    nmgs.to_fem(mesh, document, progress=seen.append)
    total = len(mesh.points) + len(mesh.cells["hexahedron"]) + 6 * 30 * 30
    assert seen[-1] == 1 and (np.diff([0, *seen]) * total <= 1 << 14).all()


def test_an_empty_group_and_an_empty_mesh(document):
    mesh = nmgs.Mesh(np.zeros((0, 3)), {"tetra": np.zeros((0, 4))}, {"none": ("tetra", [])})
    fem = nmgs.to_fem(mesh, document).FemMesh
    assert fem.NodeCount == 0 and fem.VolumeCount == 0
    assert FreeCAD.ActiveDocument.Objects
