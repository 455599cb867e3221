# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picked faces, solids and whole objects as one shape, where the user sees them."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import Part

from ..nmgs.errors import GeometryError

#: A document object and one sub-element's name, "" for the whole.
Entity = Tuple[Any, str]
_KINDS = ("Solid", "Face", "Edge", "Vertex")


class Member(NamedTuple):
    """An object and how many faces, edges, ... come before its own in the shape of all."""

    obj: Any
    before: Dict[str, int]
    counts: Dict[str, int]


class Picked(NamedTuple):
    """shape: of the object, or of several as a compound. names: its picked elements."""

    shape: Part.Shape
    names: List[str]
    parts: List[Member]

    def owner(self, name: str) -> Optional[Entity]:
        """The document's element of a name in the shape of all, None for one that is not in it."""
        kind, number = split_name(name.rpartition(".")[2])
        for part in self.parts:
            local = number - part.before.get(kind, 0)
            if 1 <= local <= part.counts.get(kind, 0):
                return part.obj, f"{kind}{local}"
        return None


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
    parts: List[Member] = []
    before = {kind: 0 for kind in _KINDS}
    for obj, picked in wanted.items():
        shape = shape_of(obj)
        counts = {kind: shape.countElement(kind) for kind in _KINDS}
        if "" in picked:
            kind = "Solid" if counts["Solid"] else "Face"
            picked = [f"{kind}{n + 1}" for n in range(counts[kind])]
        for name in picked:
            kind, number = _checked(obj, name, counts)
            names.append(f"{kind}{before[kind] + number}")
        parts.append(Member(obj, dict(before), counts))
        before = {kind: before[kind] + counts[kind] for kind in _KINDS}
        shapes.append(shape)
    shape = shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)
    return Picked(shape, names, parts)


def split_name(name: str) -> Tuple[str, int]:
    """("Face", 3) of "Face3"."""
    kind = name.rstrip("0123456789")
    return kind, int(name[len(kind) :] or 0)


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
        kind, number = split_name(name)
        shapes.append(parts[kind][number - 1])
    return shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)


def _checked(obj: Any, name: str, counts: Dict[str, int]) -> Tuple[str, int]:
    kind, number = split_name(name)
    if kind not in ("Face", "Solid"):
        raise GeometryError(f"{obj.Label}.{name}: expected a face or a solid.", [name])
    if not 1 <= number <= counts[kind]:
        raise GeometryError(
            f"{obj.Label}.{name} is not there: {obj.Label} has {counts[kind]} of its kind.", [name]
        )
    return kind, number
