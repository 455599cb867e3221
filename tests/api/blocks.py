# SPDX-License-Identifier: LGPL-2.1-or-later
"""Block models that the tests of meshes share."""

import numpy as np

from freecad.NMGSWorkbench import nmgs

_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0)]
CORNERS_2D = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float)
NATURAL_2D = np.array(list(CORNERS_2D) + [(CORNERS_2D[a] + CORNERS_2D[b]) / 2 for a, b in _EDGES])
CORNERS_3D = np.array([[x, y, z] for z in (-1, 1) for x, y in CORNERS_2D], dtype=float)
_EDGES_3D = _EDGES + [(a + 4, b + 4) for a, b in _EDGES] + [(i, i + 4) for i in range(4)]
NATURAL_3D = np.array(
    list(CORNERS_3D) + [(CORNERS_3D[a] + CORNERS_3D[b]) / 2 for a, b in _EDGES_3D]
)


def bent_patches(divisions=(3, 4)) -> nmgs.BlockModel:
    """Two patches side by side on a saddle."""
    nodes = []
    for shift in (0, 2):
        x, y = NATURAL_2D[:, 0] + shift, NATURAL_2D[:, 1]
        nodes.append(np.stack([x + 0.2 * y * y, y, 0.3 * x * x * 0.5 - 0.2 * y * y], axis=1))
    return nmgs.BlockModel(np.array(nodes), [divisions] * 2)


def bent_blocks(divisions=(3, 2, 4)) -> nmgs.BlockModel:
    """Two curved blocks side by side."""
    nodes = []
    for shift in (0, 2):
        x, y, z = NATURAL_3D[:, 0] + shift, NATURAL_3D[:, 1], NATURAL_3D[:, 2]
        nodes.append(
            np.stack([x + 0.2 * y * y, y + 0.15 * z * z, z + 0.1 * x * x - 0.1 * y * y], axis=1)
        )
    return nmgs.BlockModel(np.array(nodes), [divisions] * 2)


def cube(divisions=(3, 3, 3)) -> nmgs.BlockModel:
    """The cube [0, 1]^3: its faces have nothing but equal diagonals when divided evenly."""
    return nmgs.BlockModel((NATURAL_3D[None] + 1) / 2, [divisions])
