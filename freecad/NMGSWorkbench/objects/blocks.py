# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks: 20-node blocks, in picked solids or given by their nodes (NMGS-SVMG)."""

from __future__ import annotations

from typing import Any

from .blocking import Blocking


class Blocks(Blocking):
    """Proxy of a Part::FeaturePython; its Shape is the curved edges of the elements."""

    nodes_per_element = 20
    text = "Fitting blocks"
    view = ("blocks", "BlocksView")


def make(document: Any, name: str = "Blocks") -> Any:
    """A new, empty Blocks object of the document."""
    obj = document.addObject("Part::FeaturePython", name)
    Blocks(obj)
    return obj
