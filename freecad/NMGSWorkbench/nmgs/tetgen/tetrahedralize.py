# SPDX-License-Identifier: LGPL-2.1-or-later
"""tetrahedralize: a source and switches in, a Mesh of tetrahedra out."""

from __future__ import annotations

from typing import Any, Callable, Dict, Optional, Tuple, Union

import numpy as np

from ..cad_snap import snap_to_shape
from ..cad_voids import voids_of
from ..errors import TetGenError
from ..mesh import Mesh
from ..plc import PLC
from . import worker
from .failures import error_of, no_tetrahedra
from .options import TetOptions
from .results import TetGenData, cells_of, mesh_of
from .sources import extra_arrays, request_of, to_source
from .validity import fault_of


def tetrahedralize(
    source: Any,
    switches: Union[str, TetOptions] = "pq",
    timeout: Optional[float] = None,
    progress: Optional[Callable[[float], Any]] = None,
    *,
    sizes: Any = None,
    volumes: Any = None,
    added_points: Any = None,
    background: Optional[Tuple[Mesh, Any]] = None,
    deviation: float = 0.0,
    snap: bool = False,
    memory_limit: int = 0,
    log: Optional[Callable[[str], Any]] = None,
) -> Mesh:
    """Tetrahedra of a source by TetGen (Si, ACM TOMS 41(2), 2015), in a process of its own.

    source: (N, 3) points, PLC, path, Mesh (a surface, or tetrahedra for -r), BlockModel, or a
    FreeCAD shape, mesh or document object. switches: TetGen's, or TetOptions; what the arguments
    below and a source's regions need is added. timeout: seconds. progress: called with a fraction
    at least every 50 ms from this thread; False cancels. sizes: (N,) wanted edge length at each
    point of the source (-m). volumes: (M,) largest volume for each tetrahedron of the source (-ra).
    added_points: (A, 3), inserted into the mesh (-i). background: a Mesh of tetrahedra and the edge
    length at each of its points (-m). deviation: for CAD, how far a facet may be from its face; 0
    for a thousandth of the size. snap: put the nodes on CAD faces onto them, mid-nodes of a second
    order too, as far as no tetrahedron turns inside out. memory_limit: bytes that TetGen may use;
    0 for no limit. log: called with TetGen's lines.

    The Mesh has "tetra" or "tetra10" cells (positive volume), and as "triangle" or "triangle6" the
    facets of the boundary, normals outwards; groups of facets and regions; and mesh.tetgen with
    all else that TetGen returned. Every answer is looked over before it is used: numbers in range,
    positive tetrahedra. Its volume is that of the facets to rounding, but where facets meet at more
    than 179.9 degrees: TetGen takes such for one plane, unless -M keeps them apart (or p/180, the
    option facet_angle). Raises TetGenError, Cancelled, ValueError, TypeError.
    """
    options = switches.copy() if isinstance(switches, TetOptions) else TetOptions.parse(switches)
    if timeout is not None and not timeout > 0:
        raise ValueError(f"timeout: expected more than 0 seconds, got {timeout!r}")
    if memory_limit < 0:
        raise ValueError(f"memory_limit: expected 0 or more bytes, got {memory_limit!r}")
    thing = to_source(source, _needs_facets(options), deviation, progress)
    if snap and not hasattr(thing, "part"):
        raise ValueError("snap: the source is no CAD shape")
    arrays = request_of(thing)
    arrays.update(extra_arrays(arrays, options, sizes, volumes, added_points, background))
    if isinstance(thing, PLC) and thing.region_groups and options.plc:
        options.region_attributes = True
    _check(thing, arrays, options)
    # TetGen 1.6.0 frees its mid-nodes before it writes them: they are added here instead.
    raise_order = options.order == 2 and options.version == "1.6"
    if raise_order:
        options.order = 1
    arrays["switches"] = np.frombuffer(str(options).encode("ascii"), np.uint8)
    outcome = worker.run(arrays, timeout, progress, log, memory_limit)
    voids = voids_of(outcome.arrays, thing) if outcome.whole else None
    if voids is not None:
        arrays["holes"] = np.concatenate([thing.holes, voids])
        outcome = worker.run(arrays, timeout, progress, log, memory_limit)
    if not outcome.whole:
        raise error_of(outcome, thing, timeout, progress)
    data = TetGenData(outcome.version, str(options), outcome.log)
    reverse = options.version != "1.5" and options.reverse
    fault = fault_of(outcome.arrays, -1 if reverse else 1)
    if fault:
        raise TetGenError(f"TetGen's mesh is not valid: {fault}", log=outcome.log)
    mesh = mesh_of(outcome.arrays, thing, data)
    if not (options.diagnose or options.no_tetrahedra or cells_of(mesh, "tetra", "tetra10")):
        raise no_tetrahedra(thing, data, progress)
    if raise_order:
        mesh = mesh.to_order(2)
        mesh.tetgen = data  # type: ignore[attr-defined]
    if snap:
        snap_to_shape(mesh, thing.part, progress)
    return mesh


def _needs_facets(options: TetOptions) -> bool:
    return bool(
        options.plc
        or options.quality
        or options.keep_boundary
        or options.diagnose
        or options.volumes
        or options.max_volume is not None
    )


def _check(source: Any, arrays: Dict[str, np.ndarray], options: TetOptions) -> None:
    """What TetGen would not survive, or would take for something else."""
    if options.refine:
        if "tetra" not in arrays:
            raise ValueError(f"switches: -r refines tetrahedra, and {source!r} has none")
    elif "tetra" in arrays:
        raise ValueError(
            "source: it has tetrahedra already; -r refines them, boundary() frees them"
        )
    elif _needs_facets(options) and "facet_offsets" not in arrays:
        raise ValueError(f"switches: -{options} needs facets, and the source has points only")
    if options.weighted and "point_attributes" not in arrays:
        raise ValueError("switches: -w needs a weight as first attribute of each point")
    count = len(arrays["points"])
    if count < 4:
        raise ValueError(f"source: a tetrahedron has four points, the source {count}")
