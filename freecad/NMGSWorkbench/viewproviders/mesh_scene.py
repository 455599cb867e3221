# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh in the scene graph: its faces, lines, colours, and elements that are marked."""

from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np
from pivy import coin

from ..nmgs import _kernel
from ..nmgs.mesh import Mesh
from ..nmgs.plot import Plot, PlotOptions, plot
from . import legend
from . import scene_nodes as nodes

MARK: nodes.Colour = (0.92, 0.20, 0.12)
STALE: nodes.Colour = (0.62, 0.60, 0.58)
_FADED = 0.85


class MeshScene:
    """root: the node to put into a view provider. Drawn again by draw(); marks are kept apart."""

    def __init__(self) -> None:
        self.root = coin.SoSeparator()
        self.faces = coin.SoSeparator()
        self.marks = coin.SoSeparator()
        self.legend = coin.SoSeparator()
        for child in (self.faces, self.marks, self.legend):
            self.root.addChild(child)
        #: What is drawn now, for those who want to count it.
        self.plot: Optional[Plot] = None
        self._material: Any = None
        self._colour: nodes.Colour = MARK
        self._transparency = 0.0

    def clear(self) -> None:
        for part in (self.faces, self.marks, self.legend):
            part.removeAllChildren()
        self.plot = None

    def draw(
        self,
        mesh: Mesh,
        options: PlotOptions,
        colour: nodes.Colour,
        metric: str = "",
        transparency: float = 0.0,
        line_width: float = 1.0,
        title: str = "",
    ) -> None:
        """Draws the mesh. metric: colour by it, "" for the one colour. title: of the legend."""
        drawn = plot(mesh, options)
        values = drawn.cell_values(metric) if metric else None
        self.clear()
        self.plot = drawn
        self._material = nodes.material(colour, transparency)
        self._colour, self._transparency = colour, transparency
        for child in (
            nodes.two_sided(),
            nodes.behind_lines(),
            self._material,
            nodes.coordinates(drawn.points),
        ):
            self.faces.addChild(child)
        low, high, larger = (0.0, 1.0, True) if values is None else _range(metric, values)
        for number, polygons in enumerate(drawn.polygons):
            if not len(polygons):
                continue
            group = coin.SoSeparator()
            if values is not None:
                for child in nodes.face_colours(legend.colours(values[number], low, high, larger)):
                    group.addChild(child)
            group.addChild(nodes.faces(polygons))
            self.faces.addChild(group)
        _add_lines(self.faces, drawn, line_width)
        if values is not None:
            self.legend.addChild(legend.legend(title or metric, low, high, larger))

    def fade(self, is_stale: bool) -> None:
        """Grey and thin while the mesh is stale."""
        if self._material is None:
            return
        colour = STALE if is_stale else self._colour
        self._material.diffuseColor.setValue(*colour)
        self._material.transparency.setValue(max(0.6 if is_stale else 0.0, self._transparency))

    def mark(self, mesh: Mesh, cells: Dict[str, np.ndarray]) -> None:
        """Draws cells, by type and index, in full, and fades the others. None: as it was."""
        self.marks.removeAllChildren()
        count = sum(len(ids) for ids in cells.values())
        if self._material is not None:
            self._material.transparency.setValue(_FADED if count else self._transparency)
        if not count:
            return
        drawn = plot(mesh, PlotOptions(), only=cells)
        group = coin.SoSeparator()
        for child in (
            nodes.two_sided(),
            nodes.behind_lines(),
            nodes.material(MARK),
            nodes.coordinates(drawn.points),
            *(nodes.faces(polygons) for polygons in drawn.polygons if len(polygons)),
        ):
            group.addChild(child)
        _add_lines(group, drawn, 2.0)
        self.marks.addChild(group)


def _add_lines(group: Any, drawn: Plot, width: float) -> None:
    outline = coin.SoSeparator()
    for child in (
        nodes.flat(),
        nodes.base_colour(nodes.LINE_COLOUR),
        nodes.pen(width),
        nodes.lines(drawn.lines),
    ):
        outline.addChild(child)
    group.addChild(outline)


def _range(metric: str, values: Any) -> Tuple[float, float, bool]:
    everything = np.concatenate(values) if values else np.zeros(0)
    finite = everything[np.isfinite(everything)]
    low, high = (finite.min(), finite.max()) if len(finite) else (0.0, 1.0)
    # All alike but for rounding is one colour, that of the best.
    if high - low <= 1e-6 * max(abs(low), abs(high)):
        low, high = high - 1.0, high
    return float(low), float(high), bool(_kernel.core().metrics()[metric])
