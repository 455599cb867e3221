# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plc: a piecewise linear complex or a set of points, what TetGen starts from."""

from __future__ import annotations

import os
import tempfile
from typing import Any, Optional

from .. import nmgs
from .base import DocumentObject
from .plc_shape import plc_shape


class Plc(DocumentObject):
    """Proxy of a Part::FeaturePython; its Shape is the facets, or the points where there are none.

    The complex itself is in Data, a .poly file inside the document.
    """

    view = ("plc", "PlcView")
    properties = (
        ("App::PropertyString", "File", "PLC", "File that it was read from", None, 1),
        ("App::PropertyFileIncluded", "Data", "PLC", "The complex as a .poly file", None, 2),
        ("App::PropertyInteger", "PointCount", "Figures", "Number of points", None, 1),
        ("App::PropertyInteger", "FacetCount", "Figures", "Number of facets", None, 1),
        ("App::PropertyInteger", "HoleCount", "Figures", "Number of holes", None, 1),
        ("App::PropertyInteger", "RegionCount", "Figures", "Number of regions", None, 1),
    )
    _plc: Optional[nmgs.PLC] = None

    def put(self, obj: Any, plc: nmgs.PLC) -> None:
        """Makes the complex obj's own."""
        shape = plc_shape(plc)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "plc.poly")
            nmgs.write(path, plc)
            obj.Data = path
        obj.Shape = shape
        obj.PointCount = len(plc.points)
        obj.FacetCount = len(plc)
        obj.HoleCount = len(plc.holes)
        obj.RegionCount = len(plc.regions)
        self._plc = plc

    def plc(self, obj: Any) -> nmgs.PLC:
        """The complex that the document holds."""
        if self._plc is None:
            self._plc = nmgs.read(obj.Data, format="poly")
        return self._plc

    def onChanged(self, obj: Any, prop: str) -> None:
        if prop == "Data":
            self._plc = None

    def compute(self, obj: Any) -> None:
        """Nothing to follow, nothing to do."""


def make(document: Any, plc: nmgs.PLC, name: str = "PLC") -> Any:
    """A new Plc object that holds the complex."""
    obj = document.addObject("Part::FeaturePython", name)
    Plc(obj).put(obj, plc)
    return obj
