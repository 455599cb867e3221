# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of the console API. Wrong arguments are ValueError or TypeError instead."""

from __future__ import annotations

from typing import Any, List, Sequence


class Error(Exception):
    """Base of all errors that are not a wrong argument."""


class FormatError(Error):
    """A file is not what its format says. path: the file; line: 1-based, 0 for the whole file."""

    def __init__(self, message: str, path: str = "", line: int = 0):
        super().__init__(message)
        self.path = path
        self.line = line


class GeometryError(Error):
    """A shape cannot be used. entities: FreeCAD's names of the parts, e.g. ["Solid1.Face7"]."""

    def __init__(self, message: str, entities: Sequence[str] = ()):
        super().__init__(message)
        self.entities = list(entities)


class BlockingError(Error):
    """Blocks cannot be made or meshed. reasons[i] says in words why, for entities[i]."""

    def __init__(self, message: str, entities: Sequence[str] = (), reasons: Sequence[str] = ()):
        super().__init__(message)
        self.entities = list(entities)
        self.reasons = list(reasons)


class TetGenError(Error):
    """TetGen failed. code: its exit code; facets: 0-based facets to blame; log: its own words;
    outlines: (n, 3) points of the polygons of the first of these facets; timed_out: it did not end
    within its time."""

    def __init__(
        self,
        message: str,
        code: int = 0,
        facets: Sequence[int] = (),
        log: str = "",
        timed_out: bool = False,
    ):
        super().__init__(message)
        self.code = code
        self.timed_out = timed_out
        self.facets = list(facets)
        self.log = log
        self.outlines: List[Any] = []


class Cancelled(Error):
    """The progress callback, or the user, asked to stop. Nothing was changed."""


class KernelMissing(Error, ImportError):
    """The compiled kernel is not installed for this Python."""
