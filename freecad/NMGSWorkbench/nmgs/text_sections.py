# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text file line by line, with blocks of numbers as arrays, and errors that name the line."""

from __future__ import annotations

import functools
from typing import Any, Callable, Iterator, List

import numpy as np

from .errors import FormatError


def reader(function: Callable[..., Any]) -> Callable[..., Any]:
    """A reader whose stumbles over nonsense are FormatErrors that name the file."""

    @functools.wraps(function)
    def read(path: str, *arguments: Any, **options: Any) -> Any:
        try:
            return function(path, *arguments, **options)
        except FormatError:
            raise
        except (ValueError, IndexError, KeyError, TypeError, OverflowError) as error:
            raise FormatError(f"{path}: not what the format says: {error}", path) from error

    return read


class Lines:
    """The lines of a file. Raises FileNotFoundError."""

    def __init__(self, path: str):
        self.path = path
        with open(path, encoding="utf-8", errors="replace") as file:
            self._lines = file.read().splitlines()
        self.at = 0

    def more(self) -> bool:
        """Whether there are lines left that are not blank; blank ones are passed over."""
        while self.at < len(self._lines) and not self._lines[self.at].strip():
            self.at += 1
        return self.at < len(self._lines)

    def peek(self) -> str:
        """The next line, which stays; "" at the end."""
        return self._lines[self.at] if self.at < len(self._lines) else ""

    def next(self, wanted: str) -> str:
        """The next line. Raises FormatError at the end of the file."""
        if self.at >= len(self._lines):
            raise self.error(f"expected {wanted}, found the end of the file")
        self.at += 1
        return self._lines[self.at - 1]

    def error(self, text: str) -> FormatError:
        """A FormatError at the line that was read last."""
        return FormatError(f"{self.path}:{max(self.at, 1)}: {text}", self.path, max(self.at, 1))

    def integers(self, wanted: str, count: int) -> List[int]:
        """The first count numbers of the next line."""
        line = self.next(wanted)
        try:
            numbers = [int(word) for word in line.split()[:count]]
        except ValueError:
            numbers = []
        if len(numbers) < count or (wanted.startswith("the number") and numbers[0] < 0):
            raise self.error(f"expected {wanted}, found {line.strip()[:60]!r}")
        return numbers

    def block(self, rows: int, columns: int, dtype: Any, what: str) -> np.ndarray:
        """rows lines of so many numbers each."""
        first = self.at
        if rows < 0 or first + rows > len(self._lines):
            self.at = len(self._lines)
            raise self.error(f"expected {rows} lines of {what}, found the end of the file")
        self.at += rows
        return self._numbers(first, self.at, columns, dtype, what)

    def _numbers(self, first: int, last: int, columns: int, dtype: Any, what: str) -> np.ndarray:
        words = " ".join(self._lines[first:last]).split()
        try:
            if len(words) != (last - first) * columns:
                raise ValueError
            # By way of numpy's own parser, which is as exact as Python's.
            return np.array(words, dtype=np.str_).astype(dtype).reshape(-1, columns)
        except ValueError:
            for line in range(first, last):
                row = self._lines[line].split()
                self.at = line + 1
                try:
                    good = len(np.array(row, dtype=np.str_).astype(dtype)) == columns
                except ValueError:
                    good = False
                if not good:
                    found = self._lines[line].strip()[:60]
                    raise self.error(
                        f"expected {columns} numbers ({what}), found {found!r}"
                    ) from None
            raise

    def ragged(self, rows: int, what: str) -> Iterator[np.ndarray]:
        """rows lines of integers: arrays of lines that follow each other and agree in their second
        and third number and their count."""
        first = self.at
        if rows < 0 or first + rows > len(self._lines):
            self.at = len(self._lines)
            raise self.error(f"expected {rows} lines of {what}, found the end of the file")
        self.at += rows
        start, key = first, None
        for line in range(first, first + rows + 1):
            words = self._lines[line].split() if line < first + rows else []
            now = (len(words), words[1:3])
            if line == first:
                key = now
            if now != key or line == first + rows:
                if line > start:
                    if key is None or key[0] < 4:
                        self.at = start + 1
                        raise self.error(
                            f"expected {what}, found {self._lines[start].strip()[:60]!r}"
                        )
                    yield self._numbers(start, line, key[0], np.int64, what)
                start, key = line, now
        self.at = first + rows
