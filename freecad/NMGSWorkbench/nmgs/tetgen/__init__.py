# SPDX-License-Identifier: LGPL-2.1-or-later
"""NMGS-QTMG: TetGen, in a process of its own."""

from .options import TetOptions
from .tetrahedralize import tetrahedralize

__all__ = ["TetOptions", "tetrahedralize"]
