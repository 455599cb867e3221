# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of a metric's values, and their legend at the 3D view's left edge."""

from __future__ import annotations

from typing import Any, List, Tuple

import numpy as np
from pivy import coin

from . import scene_nodes as nodes

#: From bad to good, told apart by people who see no red or no green as well.
_STOPS = np.array(
    [
        (0.65, 0.00, 0.15),
        (0.93, 0.43, 0.25),
        (1.00, 0.88, 0.55),
        (0.60, 0.82, 0.90),
        (0.19, 0.33, 0.66),
    ]
)
_NOTHING = np.array((0.6, 0.6, 0.6))
_INK: nodes.Colour = (0.05, 0.05, 0.05)
_BANDS = 40
#: Height of the legend, its widths and place, in halves of the view's height.
_BOTTOM, _TOP, _LEFT, _WIDTH = -0.6, 0.6, 0.06, 0.06


def colours(values: np.ndarray, low: float, high: float, larger_is_better: bool) -> np.ndarray:
    """(K, 3) for the values, low to high; grey where a value is not finite."""
    span = high - low if high > low else 1.0
    share = np.clip((values - low) / span, 0.0, 1.0)
    if not larger_is_better:
        share = 1.0 - share
    finite = np.isfinite(values)
    share = np.where(finite, share, 0.0) * (len(_STOPS) - 1)
    at = np.minimum(share.astype(int), len(_STOPS) - 2)
    rest = (share - at)[:, None]
    result = (1 - rest) * _STOPS[at] + rest * _STOPS[at + 1]
    result[~finite] = _NOTHING
    return result


def ticks(low: float, high: float, count: int = 5) -> List[Tuple[float, str]]:
    """(value, text) evenly from low to high."""
    return [(float(v), f"{v:.3g}") for v in np.linspace(low, high, count)]


def legend(title: str, low: float, high: float, larger_is_better: bool) -> Any:
    """A node that draws the legend over the 3D view, wherever its camera is."""
    root = nodes.outside_bounds()
    overlay = coin.SoAnnotation()
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.position.setValue(1.0, 0.0, 1.0)
    camera.height = 2.0
    camera.nearDistance = 0.1
    camera.farDistance = 2.0
    heights = np.linspace(_BOTTOM, _TOP, _BANDS + 1)
    left, right = _LEFT, _LEFT + _WIDTH
    places = np.array([(x, y, 0.0) for y in heights for x in (left, right)])
    first = 2 * np.arange(_BANDS)
    bands = np.column_stack([first, first + 1, first + 3, first + 2])
    middle = 0.5 * (heights[:-1] + heights[1:])
    values = low + (middle - _BOTTOM) / (_TOP - _BOTTOM) * (high - low)
    binding, packed = nodes.face_colours(colours(values, low, high, larger_is_better))
    bar = coin.SoSeparator()
    for child in (nodes.flat(), binding, packed, nodes.coordinates(places), nodes.faces(bands)):
        bar.addChild(child)
    for child in (camera, nodes.unpickable(), bar):
        overlay.addChild(child)
    # On plates, to be read before a dark view as well as on white paper.
    for value, words in ticks(low, high):
        height = _BOTTOM + (value - low) / ((high - low) or 1.0) * (_TOP - _BOTTOM)
        overlay.addChild(nodes.label((right + 0.02, height - 0.025, 0.0), words, _INK))
    overlay.addChild(nodes.label((left, _TOP + 0.06, 0.0), title, _INK))
    root.addChild(overlay)
    return root
