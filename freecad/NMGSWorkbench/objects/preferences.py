# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the preferences page sets; the defaults are those of resources/preferences.ui."""

from __future__ import annotations

from typing import Any

import FreeCAD

PATH = "User parameter:BaseApp/Preferences/Mod/NMGS"


def _group() -> Any:
    return FreeCAD.ParamGet(PATH)


def recompute_at_once() -> bool:
    """Whether a recompute of the document computes blocks and meshes."""
    return _group().GetBool("RecomputeAtOnce", True)


def show_counts() -> bool:
    """Whether new blocks show the number of elements on their edges."""
    return _group().GetBool("ShowCounts", True)


def warn_below() -> float:
    """Worst scaled Jacobian below which a new mesh is warned of."""
    return _group().GetFloat("WarnBelow", 0.2)


def most_filled() -> int:
    """Elements of the largest mesh that FreeCAD's own view is given at once."""
    return _group().GetInt("MostFilled", 50_000)


def time_limit() -> float:
    """Of new TetGen meshes, in seconds; 0 for none."""
    return float(_group().GetInt("TimeLimit", 0))
