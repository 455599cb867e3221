# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches: 8-node patches, on picked faces or given by their nodes (NMGS-SSMG)."""

from __future__ import annotations

from typing import Any

from .blocking import Blocking


class Patches(Blocking):
    """Proxy of a Part::FeaturePython; its Shape is the curved edges of the elements."""

    nodes_per_element = 8
    text = "Fitting patches"
    view = ("patches", "PatchesView")


def make(document: Any, name: str = "Patches") -> Any:
    """A new, empty Patches object of the document."""
    obj = document.addObject("Part::FeaturePython", name)
    Patches(obj)
    return obj
