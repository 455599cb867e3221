# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes of the 3D view's scene graph (Coin) from arrays: faces, lines, points, texts, arrows."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

import numpy as np
from pivy import coin

Colour = Tuple[float, float, float]

LINE_COLOUR: Colour = (0.10, 0.14, 0.20)


def coordinates(points: np.ndarray) -> Any:
    """SoCoordinate3. points: (N, 3)."""
    node = coin.SoCoordinate3()
    if len(points):
        node.point.setValues(0, len(points), np.ascontiguousarray(points, dtype=np.float32))
    else:
        node.point.setNum(0)
    return node


def _indices(field: Any, rows: np.ndarray) -> None:
    # Each polygon or line ends with -1.
    ended = np.full((len(rows), rows.shape[1] + 1), -1, dtype=np.int32)
    ended[:, :-1] = rows
    if len(rows):
        field.setValues(0, ended.size, ended.ravel())
    else:
        field.setNum(0)


def faces(polygons: np.ndarray) -> Any:
    """SoIndexedFaceSet of (K, n) indices into the coordinates before it."""
    node = coin.SoIndexedFaceSet()
    _indices(node.coordIndex, polygons)
    return node


def lines(rows: np.ndarray) -> Any:
    """SoIndexedLineSet of (K, n) indices: K polylines."""
    node = coin.SoIndexedLineSet()
    _indices(node.coordIndex, rows)
    return node


def material(colour: Colour, transparency: float = 0.0) -> Any:
    node = coin.SoMaterial()
    node.diffuseColor.setValue(*colour)
    node.ambientColor.setValue(*(0.3 * c for c in colour))
    node.transparency.setValue(transparency)
    return node


def face_colours(colours: np.ndarray) -> Tuple[Any, Any]:
    """(SoMaterialBinding, SoPackedColor): one colour a face. colours: (K, 3), 0 to 1."""
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_FACE
    packed = coin.SoPackedColor()
    bytes_ = np.round(255 * np.clip(colours, 0, 1)).astype(np.uint32)
    values = (bytes_[:, 0] << 24) | (bytes_[:, 1] << 16) | (bytes_[:, 2] << 8) | 255
    packed.orderedRGBA.setValues(0, len(values), values.astype(np.uint32).tolist())
    return binding, packed


def flat() -> Any:
    """Colours as they are, no light."""
    node = coin.SoLightModel()
    node.model = coin.SoLightModel.BASE_COLOR
    return node


def pen(width: float) -> Any:
    node = coin.SoDrawStyle()
    node.lineWidth = width
    node.pointSize = width
    return node


def two_sided() -> Any:
    node = coin.SoShapeHints()
    node.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    node.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    node.faceType = coin.SoShapeHints.CONVEX
    return node


def behind_lines() -> Any:
    """Puts the faces that follow a little back, so that lines on them are whole."""
    node = coin.SoPolygonOffset()
    node.factor = 1.0
    node.units = 1.0
    return node


def unpickable() -> Any:
    node = coin.SoPickStyle()
    node.style = coin.SoPickStyle.UNPICKABLE
    return node


def outside_bounds() -> Any:
    """A group that View > Fit all does not see; a plain one where FreeCAD has no such node."""
    kind = coin.SoType.fromName("SoSkipBoundingGroup")
    node = kind.createInstance() if not kind.isBad() else None
    return node if node is not None else coin.SoSeparator()


def text(place: Sequence[float], words: str, colour: Colour, size: float = 14.0) -> Any:
    """Words at a place, turned to the viewer, of a size in pixels."""
    node = coin.SoSeparator()
    move = coin.SoTranslation()
    move.translation.setValue(*(float(c) for c in place))
    font = coin.SoFont()
    font.size = size
    font.name = "Sans:bold"
    shown = coin.SoText2()
    shown.string = words
    shown.justification = coin.SoText2.CENTER
    for child in (flat(), base_colour(colour), move, font, shown):
        node.addChild(child)
    return node


def label(place: Sequence[float], words: str, colour: Colour) -> Any:
    """Words on a light plate at a place, where FreeCAD has its node for that; else plain text."""
    kind = coin.SoType.fromName("SoFrameLabel")
    if kind.isBad():
        return text(place, words, colour)
    node = coin.SoSeparator()
    move = coin.SoTranslation()
    move.translation.setValue(*(float(c) for c in place))
    plate = kind.createInstance()
    # Its class is FreeCAD's own, so that pivy knows its fields by name alone.
    for field, value in (
        ("string", f'"{words}"'),
        ("textColor", "{} {} {}".format(*colour)),
        ("backgroundColor", "1 1 0.92"),
        ("size", "13"),
        ("frame", "TRUE"),
    ):
        if plate.getField(field) is not None:
            plate.getField(field).set(value)
    node.addChild(move)
    node.addChild(plate)
    return node


def base_colour(colour: Colour) -> Any:
    node = coin.SoBaseColor()
    node.rgb.setValue(*colour)
    return node


def polylines(curves: np.ndarray, colour: Colour, width: float) -> Any:
    """Curves (K, n, 3) of one colour."""
    node = coin.SoSeparator()
    count, length = curves.shape[:2]
    for child in (
        flat(),
        base_colour(colour),
        pen(width),
        coordinates(curves.reshape(-1, 3)),
        lines(np.arange(count * length).reshape(count, length)),
    ):
        node.addChild(child)
    return node


def dots(points: np.ndarray, colour: Colour, size: float) -> Any:
    node = coin.SoSeparator()
    for child in (flat(), base_colour(colour), pen(size), coordinates(points), coin.SoPointSet()):
        node.addChild(child)
    return node


def arrow(tip: Sequence[float], direction: Sequence[float], length: float, colour: Colour) -> Any:
    """A cone of a length that points along a direction, its middle at tip."""
    node = coin.SoSeparator()
    turn = coin.SoTransform()
    turn.translation.setValue(*(float(c) for c in tip))
    way = coin.SbVec3f(*(float(c) for c in direction))
    turn.rotation.setValue(coin.SbRotation(coin.SbVec3f(0, 1, 0), way))
    cone = coin.SoCone()
    cone.height = length
    cone.bottomRadius = 0.28 * length
    for child in (flat(), base_colour(colour), turn, cone):
        node.addChild(child)
    return node


def on_top() -> Any:
    """A separator that is drawn over what is before it."""
    return coin.SoAnnotation()


def switch(child: Any, shown: bool = True) -> Any:
    node = coin.SoSwitch()
    node.addChild(child)
    node.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE
    return node


def remove(parent: Any, child: Optional[Any]) -> None:
    """Takes a child away if it is there."""
    if child is not None and parent is not None:
        at = parent.findChild(child)
        if at >= 0:
            parent.removeChild(at)
