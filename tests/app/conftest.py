# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD without a window: a new document for each test."""

import FreeCAD
import pytest


@pytest.fixture
def document():
    made = FreeCAD.newDocument("Test")
    yield made
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


@pytest.fixture
def box(document):
    """A box of 10 x 20 x 30."""
    part = document.addObject("Part::Box", "Box")
    part.Length, part.Width, part.Height = 10, 20, 30
    document.recompute()
    return part
