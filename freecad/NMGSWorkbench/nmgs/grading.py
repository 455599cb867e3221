# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gradings: how the elements of a block are spaced along a direction.

A Grading says how, for any number of elements: BlockModel.set_grading puts it onto a direction of a
block and onto the directions that must agree with it. Sizes are in the model's unit, on the mean
arc length of the block's edges along the direction, unless `length` is given.
"""

from __future__ import annotations

import dataclasses
from typing import Optional, Sequence, Tuple

import numpy as np

from . import _kernel

KINDS = ("uniform", "geometric", "two_sided", "tanh", "positions")


@dataclasses.dataclass(frozen=True)
class Grading:
    """kind: one of KINDS. Make one with the functions below, which say what else each needs."""

    kind: str = "uniform"
    ratio: Optional[float] = None
    first: Optional[float] = None
    last: Optional[float] = None
    values: Tuple[float, ...] = ()
    #: Arc length that first and last are parts of; set_grading fills it in.
    length: Optional[float] = None
    #: Seen from the other end of the direction.
    reverse: bool = False

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ValueError(f"kind: expected one of {', '.join(KINDS)}, got {self.kind!r}")
        for name in ("ratio", "first", "last", "length"):
            value = getattr(self, name)
            if value is not None and not (np.isfinite(value) and value > 0):
                raise ValueError(f"{name}: expected a positive number, got {value!r}")

    @property
    def needs_length(self) -> bool:
        """True where sizes are given and the length that they belong to is not."""
        sizes = self.first is not None or self.last is not None
        return sizes and self.length is None

    def reversed(self) -> "Grading":
        """The same spacing seen from the other end."""
        return dataclasses.replace(self, reverse=not self.reverse)

    def positions(self, count: int) -> Optional[np.ndarray]:
        """The count + 1 ascending positions from 0 to 1; None where uniform.

        Raises ValueError when no spacing of that many elements has the sizes asked for.
        """
        if self.kind == "uniform":
            return None
        if self.kind == "positions" and len(self.values) != count + 1:
            raise ValueError(
                f"positions: {count} elements need {count + 1} positions, got {len(self.values)}"
            )
        if self.needs_length:
            raise ValueError(
                f"length: {self.kind} by size needs a length; BlockModel.set_grading gives it"
            )
        length = self.length or 1.0
        return _kernel.core().grading_positions(
            self.kind,
            count,
            self.ratio,
            None if self.first is None else self.first / length,
            None if self.last is None else self.last / length,
            np.asarray(self.values, dtype=np.float64),
            self.reverse,
        )


def uniform() -> Grading:
    """All elements alike (in natural coordinates), as in the thesis."""
    return Grading()


def geometric(
    ratio: Optional[float] = None, first: Optional[float] = None, last: Optional[float] = None
) -> Grading:
    """Each element `ratio` times as long as the one before; or by the first or the last size."""
    if sum(value is not None for value in (ratio, first, last)) != 1:
        raise ValueError("geometric: expected one of ratio, first, last")
    return Grading("geometric", ratio=ratio, first=first, last=last)


def two_sided(
    ratio: Optional[float] = None, first: Optional[float] = None, last: Optional[float] = None
) -> Grading:
    """Geometric from both ends to the middle: by ratio, or by the first and last sizes.

    Of the two sizes one may be left out: then both are alike.
    """
    if (ratio is None) == (first is None and last is None):
        raise ValueError("two_sided: expected either ratio, or first and last")
    if ratio is not None:
        return Grading("two_sided", ratio=ratio)
    return Grading(
        "two_sided", first=last if first is None else first, last=first if last is None else last
    )


def tanh(first: Optional[float] = None, last: Optional[float] = None) -> Grading:
    """Hyperbolic tangent (Vinokur 1983) with the first and last sizes; one alone: from that end."""
    if first is None and last is None:
        raise ValueError("tanh: expected first, last, or both")
    return Grading("tanh", first=first, last=last)


def positions(values: Sequence[float]) -> Grading:
    """Lattice planes at these ascending values, scaled so that they run from 0 to 1."""
    array = np.asarray(values, dtype=np.float64)
    if array.ndim != 1 or len(array) < 2 or not np.isfinite(array).all():
        raise ValueError(f"positions: expected 2 or more finite numbers, got {values!r}")
    if not (np.diff(array) > 0).all():
        at = int(np.argmin(np.diff(array) > 0)) + 1
        raise ValueError(
            f"positions: expected ascending numbers, but {array[at]!r} follows {array[at - 1]!r}"
        )
    return Grading("positions", values=tuple(array.tolist()))
