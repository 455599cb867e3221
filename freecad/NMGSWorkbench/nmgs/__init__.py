# SPDX-License-Identifier: LGPL-2.1-or-later
"""The console API of the NMGS Workbench. Needs NumPy and the compiled kernel, no FreeCAD."""

from . import grading, shapes
from .block_model import BlockModel
from .cad import fit
from .errors import (
    BlockingError,
    Cancelled,
    Error,
    FormatError,
    GeometryError,
    KernelMissing,
    TetGenError,
)
from .io import read, write
from .mesh import Mesh

__all__ = [
    "BlockModel",
    "BlockingError",
    "Cancelled",
    "Error",
    "FormatError",
    "GeometryError",
    "KernelMissing",
    "Mesh",
    "TetGenError",
    "fit",
    "grading",
    "read",
    "shapes",
    "write",
]
