# SPDX-License-Identifier: LGPL-2.1-or-later
"""A PLC of CAD: the triangulated faces of a shape, its solids as regions, its cavities as holes."""

from __future__ import annotations

from typing import Any, Callable, Optional

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
        plc = plc.mend()
    plc.part = part  # type: ignore[attr-defined]
    return plc
