# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has picked, as the commands understand it."""

from __future__ import annotations

from typing import Any, List, Tuple

import FreeCADGui

#: A LinkSubList's value: [(object, ("Face1", "Face2")), ...].
Source = List[Tuple[Any, Tuple[str, ...]]]


#: Kinds of NMGS objects, by the name of a class of their proxy.
BLOCKS, MESH, CUTS, ANY = "Blocking", "MeshObject", "CutSolids", "DocumentObject"
_PACKAGE = __package__.rpartition(".")[0]


def is_kind(obj: Any, kind: str) -> bool:
    """Whether obj is an NMGS object of a kind. By name: the classes themselves would have to be
    imported, with all that they need, as soon as the workbench is chosen."""
    return any(
        base.__name__ == kind and base.__module__.startswith(_PACKAGE)
        for base in type(getattr(obj, "Proxy", None)).__mro__
    )


def picked(kind: str) -> List[Any]:
    """The picked objects of a kind of NMGS object, in the order they were picked."""
    return [
        pick.Object for pick in FreeCADGui.Selection.getSelectionEx() if is_kind(pick.Object, kind)
    ]


def picked_faces() -> Source:
    """Picked faces; all faces of objects that were picked as a whole."""
    return _picked_elements("Face", _all_faces)


def picked_solids() -> Source:
    """Solids: picked in a dialog or script, of picked objects, or those that own picked faces."""
    return _picked_elements("Solid", _all_solids)


def has_cad(obj: Any, element: str) -> bool:
    """Whether obj has CAD geometry with such elements; the edges of blocks are not meant."""
    if not obj.isDerivedFrom("Part::Feature"):
        return False
    if is_kind(obj, ANY) and not is_kind(obj, CUTS):
        return False
    return bool(obj.Shape.countElement(element))


def can_pick(element: str) -> bool:
    """Whether something picked has faces, or solids. Quick, as FreeCAD asks all the time."""
    for pick in FreeCADGui.Selection.getSelectionEx():
        if not has_cad(pick.Object, element):
            continue
        names = pick.SubElementNames
        if not names or any(name.startswith(("Face", element)) for name in names):
            return True
    return False


def _all_faces(obj: Any, names: Tuple[str, ...]) -> List[str]:
    found = [name for name in names if name.startswith("Face")]
    for name in names:
        if name.startswith("Solid"):
            found += _numbered("Face", obj.Shape.Faces, obj.Shape.getElement(name).Faces)
    if not names:
        found = [f"Face{n + 1}" for n in range(len(obj.Shape.Faces))]
    return found


def _all_solids(obj: Any, names: Tuple[str, ...]) -> List[str]:
    solids = obj.Shape.Solids
    if not names:
        return [f"Solid{n + 1}" for n in range(len(solids))]
    found = [name for name in names if name.startswith("Solid")]
    for name in names:
        if name.startswith("Face"):
            face = obj.Shape.getElement(name)
            owners = [s for s in solids if any(face.isSame(f) for f in s.Faces)]
            found += _numbered("Solid", solids, owners)
    return found


def _numbered(kind: str, everything: List[Any], wanted: List[Any]) -> List[str]:
    return [
        f"{kind}{n + 1}"
        for n, shape in enumerate(everything)
        if any(shape.isSame(other) for other in wanted)
    ]


def _picked_elements(element: str, names_of: Any) -> Source:
    source: Source = []
    for pick in FreeCADGui.Selection.getSelectionEx():
        if has_cad(pick.Object, element):
            names = tuple(dict.fromkeys(names_of(pick.Object, pick.SubElementNames)))
            if names:
                source.append((pick.Object, names))
    return source
