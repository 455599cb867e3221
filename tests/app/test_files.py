# SPDX-License-Identifier: LGPL-2.1-or-later
"""File types in FreeCAD: opened, inserted, exported, refused; the document keeps what it read."""

import importlib

import FreeCAD
import numpy as np
import pytest

from freecad.NMGSWorkbench import nmgs

NODES = np.array(
    [[[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0], [1, 0, 0.1], [2, 0.5, 0], [1, 1, 0], [0, 0.5, 0]]]
)
TETRA = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
FACETS = np.array([[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


def opened(path):
    """As File > Open finds and calls it."""
    extension = str(path).rpartition(".")[2]
    modules = [m for m in FreeCAD.getImportType(extension) if "NMGSWorkbench" in m]
    assert modules
    importlib.import_module(modules[0]).open(str(path))
    return FreeCAD.ActiveDocument


@pytest.fixture
def n2s(tmp_path):
    path = tmp_path / "arch.n2s"
    nmgs.write(path, nmgs.BlockModel(NODES, [4, 3], "an arch"))
    return path


def test_all_types_are_known():
    imports = {"n2s", "n3s", "n2r", "n3r", "node", "poly", "smesh", "ele"}
    for extension in imports:
        assert any("NMGSWorkbench" in m for m in FreeCAD.getImportType(extension)), extension
        assert any("NMGSWorkbench" in m for m in FreeCAD.getExportType(extension)), extension


def test_n2s(document, n2s):
    made = opened(n2s)
    (obj,) = made.Objects
    assert obj.Label == "arch" and obj.Reference == "an arch" and obj.File == str(n2s)
    assert np.array_equal([tuple(n) for n in obj.Nodes], NODES[0])
    assert obj.Divisions == [4, 3]
    assert len(obj.Shape.Edges) == 4 and "Touched" not in obj.State


def test_inserted_is_one_undo_step(document, n2s):
    document.UndoMode = 1
    from freecad.NMGSWorkbench import import_blocks

    import_blocks.insert(str(n2s), document.Name)
    assert [obj.Label for obj in document.Objects] == ["arch"]
    assert document.UndoNames == ["Import arch.n2s"]
    document.undo()
    assert document.Objects == []


def test_n2s_to_mesh_to_n2r_and_back(document, n2s, tmp_path):
    from freecad.NMGSWorkbench import import_mesh
    from freecad.NMGSWorkbench.objects import structured_mesh

    made = opened(n2s)
    mesh = structured_mesh.make(made)
    mesh.Blocks = made.Objects[0]
    made.recompute()
    path = tmp_path / "arch.n2r"
    import_mesh.export([mesh], str(path))
    again = opened(path)
    back = next(obj for obj in again.Objects if obj.Label == "arch")
    assert back.ElementCount == 12
    assert np.array_equal(back.Proxy.mesh(back).points, mesh.Proxy.mesh(mesh).points)
    assert np.array_equal([tuple(n) for n in back.Blocks.Nodes], NODES[0])


def test_poly_is_kept_by_the_document(document, tmp_path):
    path = tmp_path / "corner.poly"
    nmgs.write(
        path, nmgs.PLC(TETRA, FACETS, regions=[[0.1, 0.1, 0.1, 7, 0.5]], markers=[1, 2, 3, 4])
    )
    made = opened(path)
    (obj,) = made.Objects
    assert (obj.PointCount, obj.FacetCount, obj.RegionCount) == (4, 4, 1)
    assert len(obj.Shape.Faces) == 4
    kept = str(tmp_path / "kept.FCStd")
    made.saveAs(kept)
    FreeCAD.closeDocument(made.Name)
    path.unlink()
    (obj,) = FreeCAD.openDocument(kept).Objects
    plc = obj.Proxy.plc(obj)
    assert np.array_equal(plc.points, TETRA)
    assert [plc.facet(n)[0].tolist() for n in range(4)] == FACETS.tolist()
    assert plc.regions.tolist() == [[0.1, 0.1, 0.1, 7, 0.5]] and plc.markers.tolist() == [
        1,
        2,
        3,
        4,
    ]


def test_node(document, tmp_path):
    path = tmp_path / "points.node"
    nmgs.write(path, nmgs.PLC(TETRA, ()))
    (obj,) = opened(path).Objects
    assert obj.PointCount == 4 and obj.FacetCount == 0
    assert len(obj.Shape.Vertexes) == 4


def test_ele(document, tmp_path):
    path = tmp_path / "one.ele"
    nmgs.write(path, nmgs.Mesh(TETRA, {"tetra": np.array([[0, 1, 2, 3]])}))
    (obj,) = opened(path).Objects
    assert obj.FemMesh.TetraCount == 1 and obj.ElementCount == 1


@pytest.mark.parametrize("extension", ["n2s", "n3s", "n2r", "n3r", "node", "poly", "smesh", "ele"])
def test_nonsense_is_an_error_and_leaves_no_document(document, tmp_path, extension):
    path = tmp_path / f"nonsense.{extension}"
    path.write_text("this is no such file\nnot at all\n")
    if extension == "ele":
        (tmp_path / "nonsense.node").write_text("1 3 0 0\n1 0 0 0\n")
    before = set(FreeCAD.listDocuments())
    with pytest.raises(nmgs.FormatError, match="nonsense"):
        opened(path)
    assert set(FreeCAD.listDocuments()) == before


def test_export_of_what_is_no_such_thing(document, box, tmp_path):
    from freecad.NMGSWorkbench import import_blocks

    with pytest.raises(TypeError, match="Box"):
        import_blocks.export([box], str(tmp_path / "box.n3s"))
    with pytest.raises(ValueError, match="2 are picked"):
        import_blocks.export([box, box], str(tmp_path / "box.n3s"))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "extension", ["msh", "med", "unv", "inp", "vtu", "vtk", "bdf", "nas", "su2", "gid"]
)
def test_meshes_of_other_programs(document, tmp_path, extension):
    from freecad.NMGSWorkbench import import_mesh

    mesh = nmgs.shapes.cube(divisions=2).generate()
    mesh.groups["Left"] = ("hexahedron", np.arange(4, dtype=np.int32))
    path = tmp_path / f"cube.{extension}"
    nmgs.write(path, mesh)
    made = opened(path)
    (obj,) = made.Objects
    assert obj.FemMesh.HexaCount == 8 and obj.ElementCount == 8
    assert obj.WorstScaledJacobian == pytest.approx(1)
    again = tmp_path / f"again.{extension}"
    import_mesh.export([obj], str(again))
    back = nmgs.read(again)
    assert len(back.cells["hexahedron"]) == 8
    if extension != "su2":
        assert "Left" in back.groups
