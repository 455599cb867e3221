# SPDX-License-Identifier: LGPL-2.1-or-later
"""The console API of the NMGS Workbench. Needs NumPy and the compiled kernel, no FreeCAD."""

from . import grading, shapes, sizing
from .block_model import BlockModel
from .cad import fit
from .cuts import Cut, cut, propose_cuts
from .errors import (
    BlockingError,
    Cancelled,
    Error,
    FormatError,
    GeometryError,
    KernelMissing,
    TetGenError,
)
from .fem import to_fem
from .io import read, write
from .mesh import Mesh
from .plc import PLC
from .plc_problem import PLCProblem
from .refit import refit
from .tetgen import TetOptions, tetrahedralize

__all__ = [
    "BlockModel",
    "BlockingError",
    "Cancelled",
    "Cut",
    "Error",
    "FormatError",
    "GeometryError",
    "KernelMissing",
    "Mesh",
    "PLC",
    "PLCProblem",
    "TetGenError",
    "TetOptions",
    "cut",
    "fit",
    "grading",
    "propose_cuts",
    "read",
    "refit",
    "to_fem",
    "tetrahedralize",
    "shapes",
    "sizing",
    "write",
]
