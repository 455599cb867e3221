# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh's numbers and node orders of cells (reference manual, "Node ordering")."""

from __future__ import annotations

from typing import Any, Dict, Tuple

#: Gmsh's number of a cell type, and its nodes as indices into ours (None: the same order).
_HEX = (0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14)
_WEDGE = (0, 1, 2, 3, 4, 5, 6, 8, 12, 7, 13, 14, 9, 11, 10)
_PYRAMID = (0, 1, 2, 3, 4, 5, 8, 9, 6, 10, 7, 11, 12)
_TET = (0, 1, 2, 3, 4, 5, 6, 7, 9, 8)
TYPES: Dict[str, Tuple[int, Any]] = {
    "line": (1, None),
    "triangle": (2, None),
    "quad": (3, None),
    "tetra": (4, None),
    "hexahedron": (5, None),
    "wedge": (6, None),
    "pyramid": (7, None),
    "line3": (8, None),
    "triangle6": (9, None),
    "tetra10": (11, _TET),
    "quad8": (16, None),
    "hexahedron20": (17, _HEX),
    "wedge15": (18, _WEDGE),
    "pyramid13": (19, _PYRAMID),
}
#: The type of a cell that is one node.
POINT = 15
