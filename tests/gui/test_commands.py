# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main job by the toolbar: pick as a click does, run the commands, find the results."""

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from conftest import message_boxes, process_events, screenshot, tree_labels

select = FreeCADGui.Selection


def pick(obj, *names):
    select.clearSelection()
    for name in names or ("",):
        select.addSelection(obj.Document.Name, obj.Name, name)


def run(command):
    FreeCADGui.runCommand(command)
    process_events()


def test_face_to_patches(document, box):
    pick(box, "Face1")
    run("NMGS_FitPatches")
    made = document.getObject("Patches")
    assert made is not None
    assert made.ElementCount == 1 and len(made.Nodes) == 8
    # Face1 of a box is its side x = 0.
    nodes = np.array([tuple(node) for node in made.Nodes])
    assert np.array_equal(np.ptp(nodes, axis=0), [0, 20, 30]) and nodes[0, 0] == 0
    assert "Patches" in tree_labels()
    assert select.getSelection() == [made]
    screenshot("patches")
