# SPDX-License-Identifier: LGPL-2.1-or-later
"""A round bar bent by 90 degrees."""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import nmgs
from ..objects import structured_mesh
from ..objects.make import blocks_from_model

RADIUS, BEND = 8.0, 30.0  # mm, of the bar and of its bent axis
PIECES = 3  # blocks along the bend
RATIO = 1.25  # of an element's length to that of the one before, from both ends


def model() -> nmgs.BlockModel:
    """Cylinders one behind the other, their axis bent to a quarter of a circle."""
    straight = nmgs.shapes.cylinder(RADIUS, 1.0, (4, 3, 6))
    parts = [straight.nodes + (0.0, 0.0, n) for n in range(PIECES)]
    nodes = np.concatenate(parts)
    angle = 0.5 * np.pi / PIECES * nodes[..., 2]
    outward = BEND + nodes[..., 0]
    bent = np.stack([outward * np.cos(angle), nodes[..., 1], outward * np.sin(angle)], axis=-1)
    result = nmgs.BlockModel(bent, np.tile(straight.divisions, (PIECES, 1)), "elbow")
    radial = _ring_direction(result)
    result.set_grading(*radial, nmgs.grading.two_sided(ratio=RATIO))
    return result


def _ring_direction(model: nmgs.BlockModel) -> tuple:
    """The direction along the bend, of the first block: the one with 6 elements."""
    return 0, int(np.flatnonzero(model.divisions[0] == 6)[0])


def make(document: Any) -> None:
    """Blocks by nodes and their hexahedra."""
    mesh = structured_mesh.make(document, "Hexahedra")
    mesh.Blocks = blocks_from_model(document, model(), "Elbow")
