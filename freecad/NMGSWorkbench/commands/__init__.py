# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolbar and menu entries. Each is one undo step and acts on what is picked."""

from __future__ import annotations

from typing import List

import FreeCADGui

from ..taskpanels import progress
from .about import About
from .analysis import Analysis
from .cut_solids import CutSolids
from .divisions import Divisions
from .examples import Examples
from .export import Export
from .fit_blocks import FitBlocks
from .fit_patches import FitPatches
from .generate_mesh import GenerateMesh
from .help import Help
from .mesh_report import MeshReport
from .node_table import NodeTable
from .picture import Picture
from .plot_options import PlotOptions
from .shape_library import ShapeLibrary
from .tetgen_mesh import TetGenMesh
from .update import Update

#: In the order of the toolbar.
COMMANDS = {
    "NMGS_FitPatches": FitPatches,
    "NMGS_FitBlocks": FitBlocks,
    "NMGS_CutSolids": CutSolids,
    "NMGS_ShapeLibrary": ShapeLibrary,
    "NMGS_NodeTable": NodeTable,
    "NMGS_Divisions": Divisions,
    "NMGS_GenerateMesh": GenerateMesh,
    "NMGS_TetGenMesh": TetGenMesh,
    "NMGS_Update": Update,
    "NMGS_MeshReport": MeshReport,
    "NMGS_PlotOptions": PlotOptions,
    "NMGS_Analysis": Analysis,
    "NMGS_Picture": Picture,
    "NMGS_Export": Export,
    "NMGS_Examples": Examples,
    "NMGS_Help": Help,
    "NMGS_About": About,
}
#: Behind these the toolbar and the menu have a line.
_GROUP_ENDS = ("NMGS_Divisions", "NMGS_Update", "NMGS_Export")
#: In the menu only.
_MENU_ONLY = ("NMGS_Help", "NMGS_About")


def register() -> List[str]:
    """Makes the commands known to FreeCAD; their names in the order of the menu."""
    progress.install()
    for name, command in COMMANDS.items():
        FreeCADGui.addCommand(name, command())
    return _grouped(list(COMMANDS))


def toolbar() -> List[str]:
    """The names for the toolbar."""
    return _grouped([name for name in COMMANDS if name not in _MENU_ONLY])


def _grouped(names: List[str]) -> List[str]:
    result = []
    for name in names:
        result.append(name)
        if name in _GROUP_ENDS:
            result.append("Separator")
    return result


#: What stands in the context menu whatever is picked would be in the way there.
_NOT_IN_CONTEXT = (
    "NMGS_ShapeLibrary",
    "NMGS_NodeTable",
    "NMGS_Examples",
    "NMGS_Help",
    "NMGS_About",
) + ("NMGS_Picture",)


def names_for_context_menu() -> List[str]:
    """The commands that can act on what is picked."""
    return [
        name
        for name, command in COMMANDS.items()
        if name not in _NOT_IN_CONTEXT and command().IsActive()
    ]
