# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user guide's "Five minutes", step by step as it is written, so that it stays true."""

import re

import numpy as np
import pytest
from conftest import open_panel, pick, press, process_events, run, screenshot, widget
from PySide import QtGui

from freecad.NMGSWorkbench import nmgs, resources
from freecad.NMGSWorkbench.commands import COMMANDS

COMMAND_OF = {command.menu_text: name for name, command in COMMANDS.items()}


def steps():
    """The numbered steps of the guide, in one line each."""
    with open(resources.guide(), encoding="utf-8") as file:
        text = file.read().partition("## Five minutes")[2].partition("\n## ")[0]
    found = re.findall(r"^\d\. (.*?)(?=^\d\. |\n\n|\Z)", text, re.S | re.M)
    return [" ".join(step.split()) for step in found]


def command_in(step):
    """The command that a step names, as *NMGS > Name* or *Name*."""
    for name in re.findall(r"\*(?:NMGS > )?([^*]+)\*", step):
        if name in COMMAND_OF:
            return COMMAND_OF[name]
    raise AssertionError(f"no command in: {step}")


def test_five_minutes(document, tmp_path):
    box, fit, size, mesh, divide, report, export = steps()

    assert "Part > Box" in box
    part = document.addObject("Part::Box", "Box")
    document.recompute()
    pick(part)

    run(command_in(fit))
    blocks = document.getObject("Blocks")
    assert "one block of 20 nodes" in fit and blocks.ElementCount == 1

    assert "Double click" in size
    open_panel(blocks)
    wanted = float(re.search(r"to ([\d.]+) mm", size).group(1))
    widget(QtGui.QWidget, "element_size").setProperty("rawValue", wanted)
    press("OK")
    assert list(blocks.Divisions) == [2, 2, 2]

    pick(blocks)
    run(command_in(mesh))
    made = document.getObject("StructuredMesh")
    assert made.FemMesh.HexaCount == 8

    pick(blocks, "Edge1")
    run(command_in(divide))
    count = int(re.search(r"\*Elements\* to (\d+)", divide).group(1))
    widget(QtGui.QSpinBox, "count").setValue(count)
    grading = widget(QtGui.QComboBox, "grading")
    name = re.search(r"\*Grading\* to \*([^*]+)\*", divide).group(1)
    assert grading.findText(name) > 0
    grading.setCurrentText(name)
    press("OK")
    assert made.ElementCount == count * 4

    pick(made)
    run(command_in(report))
    (bars,) = [w for w in _all("bars") if w.isVisible()]
    assert bars.width() > 100
    press("Close")
    screenshot("tutorial")

    pick(made)
    run(command_in(export))
    path = tmp_path / "tutorial.vtu"
    widget(QtGui.QLineEdit, "path").setText(str(path))
    press("OK")
    process_events()
    written = nmgs.read(path)
    assert len(written.cells["hexahedron"]) == count * 4
    assert np.ptp(written.points, axis=0) == pytest.approx([10, 10, 10])


def _all(name):
    import FreeCADGui

    return FreeCADGui.getMainWindow().findChildren(QtGui.QWidget, name)
