# SPDX-License-Identifier: LGPL-2.1-or-later
"""StructuredMesh in a document: counts, quality, file and recompute give the same mesh."""

import FreeCAD
import numpy as np
import pytest

from freecad.NMGSWorkbench.fem.fem_mesh import fem_mesh
from freecad.NMGSWorkbench.fem.from_fem_mesh import mesh_of
from freecad.NMGSWorkbench.objects import blocks, patches, structured_mesh


@pytest.fixture
def meshed(document, box):
    """Blocks in the box with elements of 5, and their mesh: 2 x 4 x 6 hexahedra."""
    laid = blocks.make(document)
    laid.Source = [(box, ("Solid1",))]
    laid.Size = 5
    made = structured_mesh.make(document)
    made.Blocks = laid
    document.recompute()
    assert laid.isValid() and made.isValid()
    return made


def content(obj):
    """The FEM mesh as plain values, to compare node for node."""
    mesh = obj.FemMesh
    nodes = {number: tuple(place) for number, place in mesh.Nodes.items()}
    elements = {
        number: mesh.getElementNodes(number) for number in (*mesh.Volumes, *mesh.Faces, *mesh.Edges)
    }
    groups = {
        (mesh.getGroupName(g), mesh.getGroupElementType(g)): tuple(sorted(mesh.getGroupElements(g)))
        for g in mesh.Groups
    }
    return nodes, elements, groups


def reopened(document, folder):
    path = str(folder / "kept.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    return FreeCAD.openDocument(path)


def test_box_of_hexahedra(meshed):
    assert meshed.NodeCount == 3 * 5 * 7
    assert meshed.ElementCount == 2 * 4 * 6
    assert meshed.Elements == ["hexahedron: 48"]
    assert meshed.WorstScaledJacobian == pytest.approx(1.0, abs=1e-12)
    assert meshed.FemMesh.NodeCount == 105 and meshed.FemMesh.HexaCount == 48
    # The boundary: 2 (2 x 4 + 4 x 6 + 2 x 6) quads.
    assert meshed.FemMesh.QuadrangleCount == 88
    box = meshed.FemMesh.BoundBox
    assert (box.XLength, box.YLength, box.ZLength) == pytest.approx((10, 20, 30))


def test_quadratic(meshed):
    meshed.Order = 2
    meshed.Document.recompute()
    assert meshed.isValid()
    assert meshed.Elements == ["hexahedron20: 48"]
    # Corners and one node an edge of the lattice.
    edges = 2 * 5 * 7 + 3 * 4 * 7 + 3 * 5 * 6
    assert meshed.NodeCount == 105 + edges


@pytest.mark.parametrize("order, name", [(1, "tetra"), (2, "tetra10")])
def test_split(meshed, order, name):
    meshed.Split = True
    meshed.Order = order
    meshed.Document.recompute()
    assert meshed.isValid(), meshed.getStatusString()
    assert meshed.Elements == [f"{name}: {12 * 48}"]
    volume = meshed.Proxy.mesh(meshed).report().volume
    assert volume == pytest.approx(6000)


def test_patches_give_quads(document, box):
    laid = patches.make(document)
    laid.Source = [(box, ("Face1",))]
    laid.Size = 5
    made = structured_mesh.make(document)
    made.Blocks = laid
    document.recompute()
    assert made.Elements == ["quad: 24"] and made.NodeCount == 35


@pytest.mark.parametrize("order", [1, 2])
def test_the_same_mesh_after_a_file_and_after_a_recompute(meshed, tmp_path, order):
    meshed.Order = order
    meshed.Document.recompute()
    before = content(meshed)
    figures = meshed.NodeCount, meshed.ElementCount, meshed.WorstScaledJacobian
    again = reopened(meshed.Document, tmp_path).getObject("StructuredMesh")
    assert "Touched" not in again.State
    assert content(again) == before
    assert (again.NodeCount, again.ElementCount, again.WorstScaledJacobian) == figures
    again.Blocks.touch()
    again.Document.recompute()
    assert content(again) == before


def test_a_mesh_follows_its_part(meshed):
    meshed.Document.getObject("Box").Height = 60
    meshed.Document.recompute()
    assert meshed.ElementCount == 2 * 4 * 12


def test_no_blocks_is_an_error_and_keeps_the_mesh(meshed):
    meshed.Blocks = None
    meshed.Document.recompute()
    assert not meshed.isValid() and "choose the blocks" in meshed.getStatusString()
    assert meshed.FemMesh.HexaCount == 48


def test_order_out_of_range(meshed, tmp_path):
    # The limits of the property are not saved; the mesh still says what it wants.
    again = reopened(meshed.Document, tmp_path).getObject("StructuredMesh")
    again.Order = 3
    again.Document.recompute()
    assert again.Order == 2 or "expected 1 or 2" in again.getStatusString()


@pytest.mark.parametrize("order, split", [(1, False), (2, False), (1, True), (2, True)])
def test_there_and_back(meshed, order, split):
    meshed.Order, meshed.Split = order, split
    meshed.Document.recompute()
    mesh = meshed.Proxy.mesh(meshed)
    back = mesh_of(fem_mesh(mesh))
    assert np.array_equal(back.points, mesh.points)
    assert sorted(back.cells) == sorted(mesh.cells)
    for name in mesh.cells:
        assert np.array_equal(back.cells[name], mesh.cells[name]), name
    assert sorted(back.groups) == sorted(mesh.groups)
    for name, (kind, indices) in mesh.groups.items():
        assert back.groups[name][0] == kind
        assert np.array_equal(np.sort(back.groups[name][1]), np.sort(indices)), name


def test_a_reopened_mesh_knows_its_blocks(meshed, tmp_path):
    again = reopened(meshed.Document, tmp_path).getObject("StructuredMesh")
    mesh = again.Proxy.mesh(again)
    assert mesh.model is not None and len(mesh.model) == 1
    assert len(mesh.cells["hexahedron"]) == 48
