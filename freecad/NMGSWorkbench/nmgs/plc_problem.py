# SPDX-License-Identifier: LGPL-2.1-or-later
"""What PLC.check() finds, in data and in words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Tuple

#: Faults after which TetGen gives a wrong mesh, none, or crashes; the others it can live with.
FATAL = ("crossing_facets", "open_edge", "hole_outside")

SENTENCES = {
    "duplicate_point": "points {p} are at the same place",
    "degenerate_facet": "facet {f} has no area",
    "duplicate_facet": "facets {f} are the same",
    "nonplanar_facet": "facet {f} is {amount:.3g} off its plane",
    "crossing_facets": "facets {f} intersect",
    "open_edge": "facet {f} has an open edge between points {p}",
    "flipped_facet": "facet {f} is oriented against its neighbours",
    "inside_out": "the surface of {count} facets, facet {first} among them, is inside out",
    "hole_outside": "hole {p} is outside",
    "region_outside": "region {p} is outside",
}


@dataclass(frozen=True)
class PLCProblem:
    """One thing wrong with a PLC.

    fault: a key of SENTENCES. facets, points: 0-based, the ones to blame (for hole_outside and
    region_outside the hole or region). place: where, (x, y, z). amount: how much, in the model's
    unit of length. str() says it in words.
    """

    fault: str
    facets: Tuple[int, ...]
    points: Tuple[int, ...]
    place: Tuple[float, float, float]
    amount: float

    @property
    def fatal(self) -> bool:
        """True when meshing will fail or go wrong."""
        return self.fault in FATAL

    def __str__(self) -> str:
        sentence = SENTENCES[self.fault].format(
            f=" and ".join(map(str, self.facets)),
            p=" and ".join(map(str, self.points)),
            first=self.facets[0] if self.facets else "",
            count=len(self.facets),
            amount=self.amount,
        )
        x, y, z = self.place
        return f"{sentence} at ({x:.6g}, {y:.6g}, {z:.6g})"


def problems_of(rows: List[tuple]) -> List[PLCProblem]:
    """The kernel's rows as problems."""
    return [PLCProblem(f, tuple(a), tuple(b), tuple(c), d) for f, a, b, c, d in rows]
