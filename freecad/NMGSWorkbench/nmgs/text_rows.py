# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of arrays as text, a slice at a time: writing never holds a second copy of a mesh."""

from __future__ import annotations

from typing import Any, Callable, Iterator, Sequence, TextIO

import numpy as np

#: Rows that are text at one time: some megabytes.
SLICE = 1 << 13


def slices(count: int) -> Iterator[slice]:
    """Slices that cover 0 to count."""
    for start in range(0, count, SLICE):
        yield slice(start, min(start + SLICE, count))


def write_rows(
    file: TextIO,
    template: str,
    rows: np.ndarray,
    first: "int | None" = None,
    convert: "Callable[[Any], Any] | None" = None,
    order: "Sequence[int] | None" = None,
    add: int = 0,
) -> None:
    """template.format(number, *row) for each row of a 2-D array; no number when first is None.

    convert: applied to each value. order: columns to take. add: added to each value. Floats are
    written in the shortest form that reads back alike.
    """
    for part in slices(len(rows)):
        taken = rows[part] if order is None else rows[part][:, list(order)]
        columns = (taken + add if add else taken).T.tolist()
        if convert is not None:
            columns = [list(map(convert, column)) for column in columns]
        if first is not None:
            columns.insert(0, range(first + part.start, first + part.stop))
        file.write("".join(map(template.format, *columns)))


def write_wrapped(
    file: TextIO, values: np.ndarray, a_line: int, between: str = ", ", end: str = "\n"
) -> None:
    """The values of a 1-D array, so many a line."""
    for part in slices((len(values) + a_line - 1) // a_line):
        numbers = values[part.start * a_line : part.stop * a_line].tolist()
        file.writelines(
            between.join(map(str, numbers[at : at + a_line])) + end
            for at in range(0, len(numbers), a_line)
        )
