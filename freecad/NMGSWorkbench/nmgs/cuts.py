# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids cut into pieces that blocks fill: where to cut, and the cut itself.

Cutting is FreeCAD's general fuse: pieces that touch share their faces, so that blocks in them share
nodes.
"""

from __future__ import annotations

import math
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _kernel
from .cad import as_shape, brep_bytes, check_valid, picked
from .errors import GeometryError

Triple = Tuple[float, float, float]


class Cut(NamedTuple):
    """A plane (radius 0) through origin, or a cylinder about the axis through origin.

    direction: the plane's normal or the axis. name, entities: in words and as names of the shape,
    what it is made from. resolves: how many of the edges and vertices that stand in the way of
    blocks lie on it.
    """

    origin: Triple
    direction: Triple
    radius: float = 0.0
    name: str = ""
    entities: Tuple[str, ...] = ()
    resolves: int = 0


def propose_cuts(shape: Any, entities: Optional[Sequence[str]] = None) -> List[Cut]:
    """Planes and cylinders that may cut solids into pieces that blocks fill, each once, the most
    promising first.

    shape: as nmgs.fit takes it. entities: only these solids ("Solid1", ...).
    A solid without concave edges, closed edges or the like in the way has none.
    Raises GeometryError when the shape is empty, not valid or has no solid, ValueError.
    """
    part = as_shape(shape)
    solids = _solids(part, entities)
    kernel = _kernel.cad()
    cad_shape = kernel.CadShape(brep_bytes(part))
    found: List[Cut] = []
    for solid in solids:
        for name, made_from, resolves, origin, direction, radius in kernel.cut_list(
            cad_shape, solid
        ):
            new = Cut(origin, direction, radius, name, tuple(made_from), resolves)
            same = [n for n, known in enumerate(found) if _same(known, new, cad_shape.diagonal)]
            if same:
                known = found[same[0]]
                found[same[0]] = known._replace(resolves=known.resolves + resolves)
            else:
                found.append(new)
    return sorted(found, key=lambda cut: -cut.resolves)


def _same(a: Cut, b: Cut, size: float) -> bool:
    """Whether both are one plane or cylinder, in a shape of this size."""
    u, v = np.array(a.direction), np.array(b.direction)
    apart = np.array(b.origin) - np.array(a.origin)
    off = np.cross(apart, u) if a.radius else np.dot(apart, u)
    return bool(
        np.abs(np.cross(u, v)).max() < 1e-6
        and abs(a.radius - b.radius) < 1e-6 * size
        and np.abs(off).max() < 1e-6 * size
    )


def cut(
    shape: Any,
    tools: Union[Any, Sequence[Any]],
    entities: Optional[Sequence[str]] = None,
) -> Any:
    """The solids of a shape, cut into pieces that share faces: a Part.Shape, a compound of solids.

    shape: as nmgs.fit takes it. tools: one or several; Cuts, and faces or objects that have some:
    planes, cylinders, cones, spheres and tori go through the whole shape, other faces cut as far as
    they reach. entities: only these solids are cut and returned ("Solid1", ...).
    Raises GeometryError when the shape is empty, not valid or has no solid, or no tool divides
    anything, TypeError, ValueError.
    """
    part = as_shape(shape)
    solids = [part.Solids[n - 1] for n in _solids(part, entities)]
    single = isinstance(tools, Cut) or not isinstance(tools, (list, tuple))
    given = [tools] if single else list(tools)
    faces = [face for tool in given for face in tool_faces(tool, part.BoundBox)]
    if not faces:
        raise ValueError("tools: expected a Cut or a face at least, got none")
    pieces = _pieces(solids, faces)
    if len(pieces) <= len(solids):
        names = "; ".join(_words(tool) for tool in given)
        raise GeometryError(f"no solid is divided by the cuts: {names}")
    volume, wanted = (sum(s.Volume for s in list_) for list_ in (pieces, solids))
    if abs(volume - wanted) > 1e-6 * wanted:
        raise GeometryError(
            f"the pieces have the volume {volume:.6g}, the solids {wanted:.6g}: OpenCASCADE could "
            "not cut them"
        )
    import Part  # only here: importing this module needs no FreeCAD

    return Part.makeCompound(pieces)


def tool_faces(tool: Any, box: Any) -> List[Any]:
    """The Part faces that a tool cuts with, in a shape of this bounding box."""
    import Part  # only here: importing this module needs no FreeCAD
    from FreeCAD import Vector

    reach = 1.1 * box.DiagonalLength
    if isinstance(tool, Cut):
        if not all(map(math.isfinite, (*tool.origin, *tool.direction, tool.radius))):
            raise ValueError(f"tools: expected finite numbers, got {tool}")
        if not any(tool.direction):
            raise ValueError(f"tools: expected a direction other than zero, got {tool}")
        place = Vector(*tool.origin)
        if tool.radius:
            surface: Any = Part.Cylinder()
            surface.Center = place
            surface.Axis = Vector(*tool.direction)
            surface.Radius = tool.radius
        else:
            surface = Part.Plane(place, Vector(*tool.direction))
        return [_extended(surface, box.Center, reach)]
    faces = as_shape(tool).Faces
    if not faces:
        raise ValueError(f"tools: expected faces, got {tool!r} without any")
    return [_extended(face.Surface, box.Center, reach) or face for face in faces]


def _extended(surface: Any, centre: Any, reach: float) -> Optional[Any]:
    """The whole surface, as far as `reach` from the centre; None for kinds that cannot be."""
    import Part  # only here: importing this module needs no FreeCAD

    turn = 2 * math.pi
    if isinstance(surface, Part.Plane):
        u, v = surface.parameter(centre)
        return surface.toShape(u - reach, u + reach, v - reach, v + reach)
    if isinstance(surface, Part.Cylinder):
        _, v = surface.parameter(centre)
        return surface.toShape(0, turn, v - reach, v + reach)
    if isinstance(surface, Part.Cone):
        # Up to its apex: beyond it the surface comes back to the same side.
        slope = math.sin(surface.SemiAngle)
        apex = -surface.Radius / slope
        _, v = surface.parameter(centre)
        low, high = v - reach, v + reach
        low, high = (max(low, apex), high) if slope > 0 else (low, min(high, apex))
        return surface.toShape(0, turn, low, high) if low < high else None
    if isinstance(surface, Part.Sphere):
        return surface.toShape(0, turn, -math.pi / 2, math.pi / 2)
    if isinstance(surface, Part.Toroid):
        return surface.toShape(0, turn, 0, turn)
    return None


def _pieces(solids: Sequence[Any], faces: Sequence[Any]) -> List[Any]:
    arguments = [*solids[1:], *faces]
    try:
        _, origins = solids[0].generalFuse(arguments)
    except Exception as error:  # Part's own type, which cannot be imported without FreeCAD
        raise GeometryError(f"OpenCASCADE could not cut the solids: {error}") from error
    pieces: List[Any] = []
    for shapes in origins[: len(solids)]:
        for shape in shapes:
            for solid in shape.Solids:
                if not any(solid.isSame(known) for known in pieces):
                    pieces.append(solid)
    return pieces


def _solids(part: Any, entities: Optional[Sequence[str]]) -> List[int]:
    if not part.Solids:
        raise GeometryError("shape: it has no solid to cut")
    dimension, numbers = picked(part, entities)
    if dimension != 3:
        raise ValueError(f"entities: expected solids, got {list(entities or ())!r}")
    check_valid(part, dimension, numbers)
    return numbers


def _words(tool: Any) -> str:
    if isinstance(tool, Cut):
        kind = f"cylinder of radius {tool.radius:.6g} about" if tool.radius else "plane at"
        return tool.name or f"{kind} {tool.origin}, direction {tool.direction}"
    return getattr(tool, "Label", None) or f"{len(as_shape(tool).Faces)} faces"
