# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document made by freecadcmd is opened in the window: its objects have icons and are seen."""

import os
import shutil
import subprocess

import FreeCAD
from conftest import process_events, tree_labels, wait_until

MAKE = """
import sys
import FreeCAD
from freecad.NMGSWorkbench.objects import blocks, structured_mesh
document = FreeCAD.newDocument("Made")
box = document.addObject("Part::Box", "Box")
document.recompute()
laid = blocks.make(document)
laid.Source = [(box, ("Solid1",))]
mesh = structured_mesh.make(document)
mesh.Blocks = laid
document.recompute()
document.saveAs({path!r})
sys.exit(0)  # without, FreeCAD 1.1 waits for a console
"""


def test_all_is_seen(document, tmp_path):
    path = str(tmp_path / "made.FCStd")
    script = tmp_path / "make.py"
    script.write_text(MAKE.format(path=path))
    subprocess.run(
        [shutil.which("freecadcmd"), str(script)],
        env=dict(os.environ),
        check=True,
        timeout=120,
        capture_output=True,
    )
    opened = FreeCAD.openDocument(path)
    process_events()
    wait_until(lambda: {"Blocks", "StructuredMesh"} <= set(tree_labels()))
    for name in ("Blocks", "StructuredMesh"):
        view = opened.getObject(name).ViewObject
        assert view.Proxy is not None and view.isVisible()
        assert view.Proxy.getIcon().endswith(".svg") and os.path.isfile(view.Proxy.getIcon())
    mesh = opened.getObject("StructuredMesh").ViewObject
    assert mesh.DisplayMode == "Elements"
    wait_until(lambda: mesh.Proxy.scene.plot is not None)
    assert len(mesh.Proxy.scene.plot.points)
