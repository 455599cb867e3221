# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames on the pipes between this process and the worker: a header of 32 bytes, then scalars.

A request is hello, arrays, go; an answer is hello, arrays, done or error. Byte order is the
machine's own: both ends run on one machine. Array numbers are those of the worker's headers.
"""

from __future__ import annotations

import struct
from typing import BinaryIO, Dict, Iterator, NamedTuple, Tuple, Union

import numpy as np

MAGIC = 0x54474D4E
VERSION = 1
HEADER = struct.Struct("=IIIiQQ")

HELLO, GO, ERROR, DONE = 1, 2, 3, 4

SCALARS = (np.dtype(np.uint8), np.dtype(np.int32), np.dtype(np.int64), np.dtype(np.float64))

#: Arrays of a request: name -> (number, scalar).
REQUEST: Dict[str, Tuple[int, np.dtype]] = {
    "switches": (100, SCALARS[0]),
    "points": (101, SCALARS[3]),
    "point_attributes": (102, SCALARS[3]),
    "point_markers": (103, SCALARS[1]),
    "point_sizes": (104, SCALARS[3]),
    "polygon_nodes": (110, SCALARS[1]),
    "polygon_offsets": (111, SCALARS[2]),
    "facet_offsets": (112, SCALARS[2]),
    "facet_markers": (113, SCALARS[1]),
    "facet_holes": (114, SCALARS[3]),
    "facet_hole_offsets": (115, SCALARS[2]),
    "facet_constraints": (116, SCALARS[3]),
    "segment_constraints": (117, SCALARS[3]),
    "edges": (118, SCALARS[1]),
    "edge_markers": (119, SCALARS[1]),
    "holes": (120, SCALARS[3]),
    "regions": (121, SCALARS[3]),
    "stl": (122, SCALARS[1]),
    "tetra": (130, SCALARS[1]),
    "tetra_attributes": (131, SCALARS[3]),
    "tetra_volumes": (132, SCALARS[3]),
    "triangles": (133, SCALARS[1]),
    "triangle_markers": (134, SCALARS[1]),
    "added_points": (140, SCALARS[3]),
    "background_points": (150, SCALARS[3]),
    "background_tetra": (151, SCALARS[1]),
    "background_sizes": (152, SCALARS[3]),
}

#: Arrays of an answer: number -> name.
ANSWER: Dict[int, str] = {
    200: "points",
    201: "point_attributes",
    202: "point_markers",
    203: "point_sizes",
    210: "tetra",
    211: "tetra_attributes",
    212: "neighbours",
    220: "triangles",
    221: "triangle_markers",
    222: "triangle_tetra",
    230: "edges",
    231: "edge_markers",
    240: "voronoi_points",
    241: "voronoi_edges",
    242: "voronoi_rays",
    243: "voronoi_facet_cells",
    244: "voronoi_facet_edges",
    245: "voronoi_facet_offsets",
    246: "voronoi_cell_facets",
    247: "voronoi_cell_offsets",
}

Buffer = Union[bytes, memoryview]


class Frame(NamedTuple):
    """One frame of an answer."""

    kind: int
    code: int
    array: np.ndarray  # (rows,) or (rows, columns)


class BrokenAnswer(Exception):
    """The answer ended early or is no answer."""


def _frame(kind: int, array: np.ndarray) -> Iterator[Buffer]:
    rows, columns = (len(array), 1) if array.ndim == 1 else array.shape
    yield HEADER.pack(MAGIC, kind, SCALARS.index(array.dtype), 0, rows, columns)
    if array.size:
        yield memoryview(array).cast("B")


def encode(arrays: Dict[str, np.ndarray], memory_limit: int = 0) -> Iterator[Buffer]:
    """Buffers of a request, viewing the arrays' own memory where their type fits already."""
    yield from _frame(HELLO, np.array([VERSION, memory_limit], np.int64))
    for name, values in arrays.items():
        number, scalar = REQUEST[name]
        yield from _frame(number, np.ascontiguousarray(values, dtype=scalar))
    yield HEADER.pack(MAGIC, GO, 0, 0, 0, 0)


def _fill(stream: BinaryIO, view: memoryview) -> None:
    while len(view):
        count = stream.readinto(view)  # type: ignore[attr-defined]
        if not count:
            raise BrokenAnswer("the worker's answer broke off")
        view = view[count:]


def read_frame(stream: BinaryIO) -> Frame:
    """The next frame of an answer; blocks. Raises BrokenAnswer."""
    head = bytearray(HEADER.size)
    _fill(stream, memoryview(head))
    magic, kind, scalar, code, rows, columns = HEADER.unpack(head)
    if magic != MAGIC or scalar >= len(SCALARS):
        raise BrokenAnswer("the worker does not speak this protocol")
    array = np.empty(rows if columns == 1 else (rows, columns), SCALARS[scalar])
    if array.size:
        _fill(stream, memoryview(array).cast("B"))
    return Frame(kind, code, array)
