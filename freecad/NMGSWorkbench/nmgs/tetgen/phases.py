# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far TetGen is, from the lines it prints: an estimate, since it names steps only."""

from __future__ import annotations

import math
import time
from typing import Tuple

#: Beginning of a line of TetGen 1.5 or 1.6 -> fraction when it appears, and when its step ends.
STEPS: Tuple[Tuple[str, float, float], ...] = (
    ("Delaunizing vertices", 0.02, 0.15),
    ("Reconstructing mesh", 0.02, 0.15),
    ("Creating surface mesh", 0.15, 0.25),
    ("Constrained Delaunay...", 0.25, 0.45),
    ("Recovering boundaries", 0.25, 0.45),
    ("Recovering Delaunayness", 0.40, 0.45),
    ("Removing exterior tetrahedra", 0.45, 0.47),
    ("Suppressing Steiner points", 0.47, 0.50),
    ("Coarsening mesh", 0.47, 0.52),
    ("Refining mesh", 0.50, 0.90),
    ("Optimizing mesh", 0.90, 0.95),
    ("Improving mesh", 0.90, 0.95),
    ("Jettisoning redundant points", 0.95, 0.95),
    ("Writing nodes", 0.96, 0.99),
)


class Phases:
    """Hears lines and tells a fraction in [0, 1) that never falls."""

    def __init__(self) -> None:
        self._started = time.monotonic()
        self._step = (self._started, 0.0, 0.02)
        self._fraction = 0.0

    def hear(self, line: str) -> None:
        """One line of TetGen's."""
        for beginning, first, last in STEPS:
            if line.startswith(beginning):
                self._step = (time.monotonic(), first, last)

    @property
    def fraction(self) -> float:
        """Inside a step the fraction nears the step's end, at the pace of the steps before it."""
        now = time.monotonic()
        since, first, last = self._step
        pace = max(0.5, 3.0 * (since - self._started))
        here = first + (last - first) * (1.0 - math.exp(-(now - since) / pace))
        self._fraction = max(self._fraction, here)
        return self._fraction
