# SPDX-License-Identifier: LGPL-2.1-or-later
"""A blind flange with a hub, as an O-grid."""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import nmgs
from ..objects import structured_mesh
from ..objects.make import blocks_from_model

HUB, RIM = 20.0, 40.0  # mm, radii
PLATE, TALL = 8.0, 24.0  # mm, heights of the plate and of the hub above it


def model() -> nmgs.BlockModel:
    """Core and ring of the plate, and the hub on its core: 14 blocks."""
    core = nmgs.shapes.cylinder(HUB, PLATE, (4, 3, 3))
    ring = nmgs.shapes.tube(RIM, HUB, PLATE, (4, 5, 3))
    hub = nmgs.shapes.cylinder(HUB, TALL, (4, 3, 8))
    return nmgs.BlockModel(
        np.concatenate([core.nodes, ring.nodes, hub.nodes + (0.0, 0.0, PLATE)]),
        np.concatenate([core.divisions, ring.divisions, hub.divisions]),
        "O-grid flange",
    )


def make(document: Any) -> None:
    """Blocks by nodes and their hexahedra."""
    mesh = structured_mesh.make(document, "Hexahedra")
    mesh.Blocks = blocks_from_model(document, model(), "Flange")
