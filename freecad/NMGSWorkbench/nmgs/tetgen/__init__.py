# SPDX-License-Identifier: LGPL-2.1-or-later
"""NMGS-QTMG: TetGen, in a process of its own."""

from .tetrahedralize import tetrahedralize

__all__ = ["tetrahedralize"]
