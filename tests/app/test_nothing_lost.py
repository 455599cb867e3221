# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copy, paste, save, reopen, and a FreeCAD without the workbench in between: nothing is lost."""

import os
import shutil
import subprocess

import FreeCAD
import pytest
from random_steps import build, content

WITHOUT = """
import sys
import FreeCAD
try:
    import freecad.NMGSWorkbench
    print("THERE")
except ImportError:
    print("MISSING")
document = FreeCAD.openDocument({path!r})
document.Comment = "Seen elsewhere"
document.save()
print("SAVED", len(document.Objects))
"""


@pytest.fixture
def built(document):
    build(document)
    return document


def names(document):
    return sorted(obj.Name for obj in document.Objects)


def test_save_and_reopen(built, tmp_path):
    before = content(built)
    path = str(tmp_path / "kept.FCStd")
    built.saveAs(path)
    FreeCAD.closeDocument(built.Name)
    again = FreeCAD.openDocument(path)
    assert content(again) == before
    assert not [obj.Name for obj in again.Objects if "Touched" in obj.State]
    again.getObject("Box").Length = 15
    again.recompute()
    mesh = again.getObject("Hexes")
    assert mesh.Proxy.mesh(mesh).report().volume == pytest.approx(15 * 10 * 10)


def test_copy_and_paste(built):
    wanted = [built.getObject(name) for name in ("Box", "Blocks", "Hexes", "Tets")]
    other = FreeCAD.newDocument("Other")
    other.copyObject(wanted, False)
    other.recompute()
    mine, theirs = content(built), content(other)
    assert set(theirs) == {"Blocks", "Hexes", "Tets"}
    for name in theirs:
        assert theirs[name] == mine[name]
    # They are copies: the first ones follow their own box.
    other.getObject("Box").Length = 20
    other.recompute()
    mesh = other.getObject("Hexes")
    assert mesh.Proxy.mesh(mesh).report().volume == pytest.approx(2000)
    assert content(built) == mine


def test_copy_within_a_document(built):
    copy = built.copyObject(built.getObject("Hexes"), False)
    built.recompute()
    assert copy.Blocks == built.getObject("Blocks")
    assert copy.ElementCount == built.getObject("Hexes").ElementCount
    copy.Order = 2
    built.recompute()
    assert built.getObject("Hexes").Order == 1
    assert copy.NodeCount > built.getObject("Hexes").NodeCount


def test_opened_and_saved_where_the_workbench_is_missing(built, tmp_path):
    before, objects = content(built), names(built)
    path = str(tmp_path / "travelled.FCStd")
    built.saveAs(path)
    FreeCAD.closeDocument(built.Name)
    home = tmp_path / "home"
    home.mkdir()
    done = subprocess.run(
        [shutil.which("freecadcmd"), "-c", WITHOUT.format(path=path)],
        env={**os.environ, "FREECAD_USER_HOME": str(home), "PYTHONPATH": ""},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert "MISSING" in done.stdout and f"SAVED {len(objects)}" in done.stdout, done.stdout
    again = FreeCAD.openDocument(path)
    assert again.Comment == "Seen elsewhere" and names(again) == objects
    for obj in again.Objects:
        assert obj.isDerivedFrom("Part::Box") or obj.Proxy is not None, obj.Name
    assert content(again) == before
    again.getObject("Box").Length = 15
    again.recompute()
    mesh = again.getObject("Hexes")
    assert mesh.Proxy.mesh(mesh).report().volume == pytest.approx(1500)
