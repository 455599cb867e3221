# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolbar and menu entries. Each is one undo step and acts on what is picked."""

from __future__ import annotations

from typing import List

import FreeCADGui

from ..taskpanels import progress
from .export import Export
from .fit_blocks import FitBlocks
from .fit_patches import FitPatches
from .generate_mesh import GenerateMesh
from .mesh_report import MeshReport
from .tetgen_mesh import TetGenMesh

#: In the order of the toolbar.
COMMANDS = {
    "NMGS_FitPatches": FitPatches,
    "NMGS_FitBlocks": FitBlocks,
    "NMGS_GenerateMesh": GenerateMesh,
    "NMGS_TetGenMesh": TetGenMesh,
    "NMGS_MeshReport": MeshReport,
    "NMGS_Export": Export,
}


def register() -> List[str]:
    """Makes the commands known to FreeCAD; their names in the order of the toolbar."""
    progress.install()
    for name, command in COMMANDS.items():
        FreeCADGui.addCommand(name, command())
    return list(COMMANDS)


def names_for_context_menu() -> List[str]:
    """The commands that can act on what is picked."""
    return [name for name, command in COMMANDS.items() if command().IsActive()]
