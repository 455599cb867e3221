# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGenMesh in a document: follows its source, survives a file, keeps the mesh on an error."""

import FreeCAD
import pytest
from tetgen_bounds import volume_bound

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.objects import tetgen_mesh


@pytest.fixture
def meshed(document, box):
    made = tetgen_mesh.make(document)
    made.Source = [(box, ("Solid1",))]
    made.Switches = "pq1.4a200"
    document.recompute()
    assert made.isValid(), made.getStatusString()
    return made


def content(obj):
    mesh = obj.FemMesh
    elements = {n: mesh.getElementNodes(n) for n in (*mesh.Volumes, *mesh.Faces)}
    return {n: tuple(place) for n, place in mesh.Nodes.items()}, elements


def test_volume_and_limit(meshed):
    volumes = meshed.Proxy.mesh(meshed).quality("volume")["tetra"]
    assert volumes.sum() == pytest.approx(6000) and 0 < volumes.max() <= volume_bound(200)
    assert meshed.ElementCount == len(volumes) == meshed.FemMesh.TetraCount
    assert meshed.NodeCount == meshed.FemMesh.NodeCount


def test_the_same_after_a_file_and_after_a_recompute(meshed, tmp_path):
    before = content(meshed)
    path = str(tmp_path / "kept.FCStd")
    meshed.Document.saveAs(path)
    FreeCAD.closeDocument(meshed.Document.Name)
    again = FreeCAD.openDocument(path).getObject("TetGenMesh")
    assert content(again) == before
    again.touch()
    again.Document.recompute()
    assert content(again) == before


def test_quadratic(meshed):
    meshed.Switches = "pq1.4a200o2"
    meshed.Document.recompute()
    assert meshed.Elements[0].startswith("tetra10")
    assert meshed.Proxy.mesh(meshed).report().volume == pytest.approx(6000)


@pytest.mark.parametrize(
    "change, kind",
    [
        ({"Switches": "p?"}, ValueError),
        ({"Source": []}, ValueError),
        ({"Switches": "pqa0.00000001", "TimeLimit": 0.5}, nmgs.TetGenError),
    ],
)
def test_an_error_says_why_and_keeps_the_mesh(meshed, change, kind):
    before = content(meshed)
    for name, value in change.items():
        setattr(meshed, name, value)
    meshed.Document.recompute()
    assert not meshed.isValid() and isinstance(meshed.Proxy.failure, kind)
    assert content(meshed) == before
