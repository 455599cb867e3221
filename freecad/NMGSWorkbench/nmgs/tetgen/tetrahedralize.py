# SPDX-License-Identifier: LGPL-2.1-or-later
"""tetrahedralize: a source and switches in, a Mesh of tetrahedra out."""

from __future__ import annotations

from typing import Any, Callable, Optional

import numpy as np

from ..errors import TetGenError
from ..mesh import Mesh
from ..plc import PLC
from . import worker
from .failures import error_of
from .results import TetGenData, mesh_of
from .sources import request_of, to_source


def tetrahedralize(
    source: Any,
    switches: Any = "pq",
    timeout: Optional[float] = None,
    progress: Optional[Callable[[float], Any]] = None,
    *,
    memory_limit: int = 0,
    log: Optional[Callable[[str], Any]] = None,
    deviation: float = 0.0,
) -> Mesh:
    """Tetrahedra of a source by TetGen (Si, ACM TOMS 41(2), 2015), in a process of its own.

    source: (N, 3) points, PLC, path, Mesh (a surface, or tetrahedra for -r), BlockModel, or a
    FreeCAD shape, mesh or document object. switches: TetGen's, or TetOptions. timeout: seconds.
    progress: called with a fraction at least every 50 ms from this thread; False cancels.
    memory_limit: bytes that TetGen may use; 0 for no limit. log: called with TetGen's lines.
    deviation: for CAD, how far a facet may be from its face; 0 for a thousandth of the size.

    The Mesh has "tetra" or "tetra10" cells (positive volume), and as "triangle" or "triangle6" the
    facets of the boundary, normals outwards; groups of facets and regions; and mesh.tetgen with
    all else that TetGen returned. Raises TetGenError, Cancelled, ValueError, TypeError.
    """
    text = str(switches)
    if timeout is not None and not timeout > 0:
        raise ValueError(f"timeout: expected more than 0 seconds, got {timeout!r}")
    surface = any(letter in text for letter in "pqYda")
    thing = to_source(source, surface, deviation)
    arrays = request_of(thing)
    if isinstance(thing, PLC) and thing.region_groups and "A" not in text and "p" in text:
        text = "A" + text
    arrays["switches"] = np.frombuffer(text.encode("ascii"), np.uint8)
    outcome = worker.run(arrays, timeout, progress, log, memory_limit)
    if not outcome.whole:
        raise error_of(outcome, thing, timeout)
    mesh = mesh_of(outcome.arrays, thing, TetGenData(outcome.version, text, outcome.log))
    if not ("tetra" in mesh.cells or "tetra10" in mesh.cells or "d" in text or "E" in text):
        raise TetGenError("TetGen: no tetrahedra", code=0, log=outcome.log)
    return mesh
