# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut solids: solids cut into pieces that share faces, for blocks to fill."""

from __future__ import annotations

import json
from typing import Any, List

import FreeCAD
import Part

from .. import nmgs
from . import sources
from .base import DocumentObject
from .run import run


class CutSolids(DocumentObject):
    """Proxy of a Part::FeaturePython; its Shape is a compound of the pieces.

    Faces that cut follow the CAD; proposed cuts stay where they were proposed.
    """

    view = ("cut_solids", "CutSolidsView")
    properties = (
        ("App::PropertyLinkSubList", "Source", "Geometry", "Solids that are cut", None, 0),
        (
            "App::PropertyLinkSubList",
            "Tools",
            "Geometry",
            "Faces and planes that cut; planes and round faces go through the whole solid",
            None,
            0,
        ),
        (
            "App::PropertyStringList",
            "Cuts",
            "Geometry",
            "Planes and cylinders that cut, one a line, as JSON",
            None,
            0,
        ),
        ("App::PropertyInteger", "PieceCount", "Figures", "Number of pieces", None, 1),
    )

    def compute(self, obj: Any) -> None:
        shape = pieces_of(obj.Source, obj.Tools, [cut_of(line) for line in obj.Cuts])
        obj.Shape = shape
        obj.PieceCount = len(shape.Solids)


def pieces_of(source: Any, tools: Any, cuts: List[nmgs.Cut]) -> Part.Shape:
    """Solids cut by faces (values of LinkSubLists) and cuts; the solids themselves without either.
    Raises nmgs.Error."""
    solids = sources.picked_shape(source)
    cutters = [*cuts, *(tool_of(target, name) for target, name in sources.entities(tools))]
    if not cutters:
        return Part.makeCompound(solids.Solids)
    return run(lambda progress: nmgs.cut(solids, cutters), "Cutting solids")


def tool_of(obj: Any, name: str) -> Any:
    """What nmgs.cut takes for a face of an object, or for a whole object or plane."""
    if obj.isDerivedFrom("App::Plane"):
        place = obj.getGlobalPlacement()
        normal = place.Rotation.multVec(FreeCAD.Vector(0, 0, 1))
        return nmgs.Cut(tuple(place.Base), tuple(normal), name=f"plane {obj.Label}")
    shape = sources.shape_of(obj)
    if not name:
        return shape
    kind, number = sources.split_name(name)
    if kind != "Face" or not 1 <= number <= len(shape.Faces):
        raise nmgs.GeometryError(f"{obj.Label}.{name}: expected a face that is there.", [name])
    return shape.Faces[number - 1]


def cut_of(line: str) -> nmgs.Cut:
    """The cut of a line of Cuts. Raises ValueError that quotes it."""
    try:
        data = json.loads(line)
        origin, direction = (tuple(float(x) for x in data[key]) for key in ("origin", "direction"))
        if len(origin) != 3 or len(direction) != 3:
            raise ValueError
        radius = float(data.get("radius", 0.0))
        return nmgs.Cut(origin, direction, radius, str(data.get("name", "")))
    except (ValueError, TypeError, KeyError, AttributeError):
        raise ValueError(
            f'Cuts: expected a line like {{"origin": [0, 0, 5], "direction": [0, 0, 1]}}, '
            f"got {line!r}"
        ) from None


def line_of(cut: nmgs.Cut) -> str:
    """A line of Cuts."""
    return json.dumps(
        dict(origin=cut.origin, direction=cut.direction, radius=cut.radius, name=cut.name)
    )


def make(document: Any, name: str = "CutSolids") -> Any:
    """A new, empty CutSolids object of the document."""
    obj = document.addObject("Part::FeaturePython", name)
    CutSolids(obj)
    return obj
