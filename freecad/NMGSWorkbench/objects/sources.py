# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picked faces, solids and whole objects as one shape, where the user sees them."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Sequence, Tuple

import Part

from ..nmgs.errors import GeometryError

#: A document object and one sub-element's name, "" for the whole.
Entity = Tuple[Any, str]


class Picked(NamedTuple):
    """shape: of the object, or of several as a compound. names: its picked elements.
    owners: the document's element of each of those names."""

    shape: Part.Shape
    names: List[str]
    owners: Dict[str, Entity]


def entities(source: Sequence[Tuple[Any, Any]]) -> List[Entity]:
    """A LinkSubList's value, one entry an element: [(obj, ("Face1", "Face2"))] gives two."""
    result = []
    for obj, names in source or ():
        if isinstance(names, str):
            names = (names,)
        result.extend((obj, name) for name in (names or ("",)))
    return result


def gather(source: Sequence[Tuple[Any, Any]]) -> Picked:
    """Faces or solids of a LinkSubList's value. Raises GeometryError that names what is missing."""
    wanted: Dict[Any, List[str]] = {}
    for obj, name in entities(source):
        wanted.setdefault(obj, []).append(name)
    shapes: List[Part.Shape] = []
    names: List[str] = []
    owners: Dict[str, Entity] = {}
    before = {"Face": 0, "Solid": 0}
    for obj, picked in wanted.items():
        shape = shape_of(obj)
        counts = {"Face": len(shape.Faces), "Solid": len(shape.Solids)}
        if "" in picked:
            kind = "Solid" if counts["Solid"] else "Face"
            picked = [f"{kind}{n + 1}" for n in range(counts[kind])]
        for name in picked:
            kind, number = _split(obj, name, counts)
            numbered = f"{kind}{before[kind] + number}"
            names.append(numbered)
            owners[numbered] = (obj, name)
        for kind in before:
            before[kind] += counts[kind]
        shapes.append(shape)
    shape = shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)
    return Picked(shape, names, owners)


def shape_of(obj: Any) -> Part.Shape:
    """The object's shape in the document's coordinates. Raises GeometryError."""
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        raise GeometryError(f"{obj.Label} has no shape.", [obj.Name])
    # Objects inside a Part container are drawn where the container puts them.
    moved = obj.getGlobalPlacement().multiply(obj.Placement.inverse())
    if not moved.isIdentity():
        shape = shape.copy()
        shape.Placement = moved.multiply(shape.Placement)
    return shape


def picked_shape(source: Sequence[Tuple[Any, Any]]) -> Part.Shape:
    """The picked faces and solids alone, as one shape. Raises as gather does."""
    picked = gather(source)
    parts = {"Face": picked.shape.Faces, "Solid": picked.shape.Solids}
    shapes = []
    for name in picked.names:
        kind = name.rstrip("0123456789")
        shapes.append(parts[kind][int(name[len(kind) :]) - 1])
    return shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)


def _split(obj: Any, name: str, counts: Dict[str, int]) -> Tuple[str, int]:
    kind = name.rstrip("0123456789")
    number = int(name[len(kind) :] or 0)
    if kind not in counts:
        raise GeometryError(f"{obj.Label}.{name}: expected a face or a solid.", [name])
    if not 1 <= number <= counts[kind]:
        raise GeometryError(
            f"{obj.Label}.{name} is not there: {obj.Label} has {counts[kind]} of its kind.", [name]
        )
    return kind, number
