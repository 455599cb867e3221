# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voids that several solids enclose together: they show as regions that are no solid's."""

from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np


def voids_of(arrays: Dict[str, np.ndarray], source: Any) -> Optional[np.ndarray]:
    """(V, 3), a point in each void of a mesh of solids; None where there are none.

    arrays: the worker's answer, with attributes of regions. source: what was meshed; only a PLC of
    CAD whose faces all belong to solids has voids: a closed shell that is no solid is meant.
    """
    part = getattr(source, "part", None)
    values = arrays.get("tetra_attributes")
    if part is None or values is None or not len(values) or not _only_solids(part):
        return None
    attribute = values.reshape(len(values), -1)[:, -1]
    solids = [number for group in source.region_groups.values() for number in group]
    outside = np.flatnonzero(~np.isin(attribute, solids))
    if not len(solids) or not len(outside):
        return None
    corners = arrays["points"][arrays["tetra"][outside, :4]]
    volume = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1]))
    places = []
    for value in np.unique(attribute[outside]):
        own = np.flatnonzero(attribute[outside] == value)
        places.append(corners[own[np.argmax(volume[own])]].mean(axis=0))
    return np.array(places)


def _only_solids(part: Any) -> bool:
    of_solids = {face.hashCode() for solid in part.Solids for face in solid.Faces}
    return all(face.hashCode() in of_solids for face in part.Faces)
