# SPDX-License-Identifier: LGPL-2.1-or-later
"""A PLC of CAD: the triangulated faces of a shape, its solids as regions, its cavities as holes."""

from __future__ import annotations

from typing import Any, Callable, Dict, FrozenSet, Optional

import numpy as np

from . import _kernel
from .cad import as_shape, brep_bytes
from .errors import GeometryError
from .plc import PLC

#: Deviation of the triangles from the faces, as a share of the shape's diagonal.
DEVIATION = 1e-3
#: Faults of a triangulation that are mended at once.
MENDED = ("duplicate_point", "duplicate_facet", "degenerate_facet")
#: Largest angle between neighbouring triangles, in radians.
ANGLE = 0.5


def plc_of_shape(
    source: Any, deviation: float = 0.0, progress: Optional[Callable[[float], Any]] = None
) -> PLC:
    """Facets of the faces, with n of FaceN as marker; a region with attribute n inside SolidN.
    Where faces of different solids lie on each other there are facets once, with a marker of their
    own that belongs to the groups of both.

    source: a Part.Shape, a list of them, or a document object. A face between two solids is there
    once. deviation: largest distance of a facet from its face; 0 for a thousandth of the diagonal.
    The PLC's part is the shape. Raises GeometryError that names faces or solids, TypeError,
    ValueError, Cancelled.
    """
    if not 0 <= deviation < float("inf"):
        raise ValueError(f"deviation: expected 0 or more, got {deviation!r}")
    part = as_shape(source)
    shape = _kernel.cad().CadShape(brep_bytes(part))
    if not shape.faces:
        raise GeometryError("shape: it has no faces")
    wanted = deviation or DEVIATION * shape.diagonal
    raw = _kernel.cad().tessellate(shape, wanted, ANGLE, progress)
    numbers = np.arange(1, shape.solids + 1, dtype=np.float64)
    plc = PLC(
        raw["points"],
        raw["triangles"],
        holes=raw["void_points"],
        regions=np.column_stack([raw["solid_points"], numbers]) if len(numbers) else (),
        markers=raw["faces"],
        groups={f"Face{n}": [n] for n in range(1, shape.faces + 1)},
        region_groups={f"Solid{n}": [float(n)] for n in range(1, shape.solids + 1)},
    )
    # Solids that touch without sharing a face, and slivers of the triangulation.
    if any(p.fault in MENDED for p in plc.check(limit=1)):
        plc = _mended(plc, shape.faces)
    plc.part = part  # type: ignore[attr-defined]
    return plc


def _mended(plc: PLC, faces: int) -> PLC:
    """plc.mend(), and a facet that stands for those of several faces has the names of all: a marker
    of its own, above those of the faces, that is in the groups of each."""
    mended = plc.mend()
    kept = mended.old_facets  # type: ignore[attr-defined]
    gone = np.setdiff1d(np.arange(len(plc)), kept)
    if not len(gone):
        return mended
    corners = plc.points[plc.polygon_nodes.reshape(-1, 3)]
    middle = corners.mean(axis=1)
    near = 1e-7 * float(np.linalg.norm(np.ptp(plc.points, axis=0)))
    order = np.argsort(middle[kept, 0], kind="stable")
    ranked = middle[kept[order]]
    names = [{int(marker)} for marker in mended.markers]
    for facet in gone.tolist():
        low, high = np.searchsorted(ranked[:, 0], middle[facet, 0] + np.array([-near, near]))
        if low < high:
            distance = np.linalg.norm(ranked[low:high] - middle[facet], axis=1)
            best = int(np.argmin(distance))
            if distance[best] <= near:
                names[order[low + best]].add(int(plc.markers[facet]))
    together: Dict[FrozenSet[int], int] = {}
    for facet, own in enumerate(names):
        if len(own) > 1:
            marker = together.setdefault(frozenset(own), faces + 1 + len(together))
            mended.markers[facet] = marker
    for own, marker in together.items():
        for face in own:
            mended.groups[f"Face{face}"].append(marker)
    return mended
