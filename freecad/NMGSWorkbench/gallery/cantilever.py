# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bar held at one end and pressed at the other, ready for CalculiX."""

from __future__ import annotations

from typing import Any

from ..fem.analysis import static_analysis
from ..objects import blocks, structured_mesh


def make(document: Any) -> None:
    """Bar, block, quadratic hexahedra, analysis."""
    bar = document.addObject("Part::Box", "Bar")
    bar.Length, bar.Width, bar.Height = 100, 10, 10
    document.recompute()
    laid = blocks.make(document)
    laid.Source = [(bar, ("Solid1",))]
    laid.Size = 4
    mesh = structured_mesh.make(document, "Hexahedra")
    mesh.Blocks = laid
    mesh.Order = 2
    document.recompute()
    # Of a Part::Box, Face1 and Face2 are its ends along x, Face6 its top.
    static_analysis(bar, mesh, ["Face1"], ["Face2"], 100.0, direction=(bar, ["Face6"]))
    bar.Visibility = False
