# SPDX-License-Identifier: LGPL-2.1-or-later
"""The PLC of a CAD shape, for TetGen."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _kernel
from .cad import as_shape, brep_bytes
from .errors import GeometryError
from .plc import PLC


def plc_of_shape(shape: Any, deviation: float = 0.0) -> PLC:
    """Triangles of a Part.Shape's faces, with shared nodes; groups FaceN and, by region, SolidN.

    deviation: how far a triangle may be from its face; 0 for a thousandth of the shape's diagonal.
    Faces between solids are kept; a cavity that nothing fills is a hole. Raises GeometryError when
    the shape has no solid or is not valid, ValueError.
    """
    if not deviation >= 0:
        raise ValueError(f"deviation: expected 0 or more, got {deviation!r}")
    part = as_shape(shape)
    if not part.Solids:
        raise GeometryError("shape: it has no solid for TetGen to fill")
    bad = [f"Solid{n}" for n, solid in enumerate(part.Solids, 1) if not solid.isValid()]
    if bad:
        raise GeometryError(f"shape: {', '.join(bad)} is not valid geometry", bad)
    kernel = _kernel.cad()
    cad_shape = kernel.CadShape(brep_bytes(part))
    raw = kernel.facets(cad_shape, deviation or 1e-3 * cad_shape.diagonal)
    count = len(raw["solid_points"])
    regions = np.hstack(
        [raw["solid_points"], np.arange(1.0, count + 1)[:, None], np.full((count, 1), -1.0)]
    )
    return PLC(
        raw["points"],
        raw["triangles"],
        raw["hole_points"],
        regions,
        markers=raw["faces"],
        groups={f"Face{n}": [int(n)] for n in np.unique(raw["faces"])},
        region_groups={f"Solid{n}": [float(n)] for n in range(1, count + 1)},
    )
