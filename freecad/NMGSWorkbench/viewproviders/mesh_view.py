# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view providers of meshes share: they draw their mesh themselves, by the plot options.

FreeCAD's own view of a FEM mesh stays as the other display modes; it takes minutes for a million
elements, so that such a mesh is given to it only when FEM asks for it.
"""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import FreeCAD
import numpy as np

from ..nmgs.plot import PlotOptions
from ..nmgs.report import METRICS
from ..objects.base import add_properties
from .base import ViewProvider, face_colour, later, set_face_colour

MODE = "Elements"
PLAIN = "Plain"
KINDS = ["Elements", "Triangles or tetrahedra"]
CUTS = ["None", "X", "Y", "Z"]

PROPERTIES = (
    (
        "App::PropertyEnumeration",
        "PlotAs",
        "Plot",
        "Elements as they are, or split into triangles or tetrahedra",
        KINDS,
        0,
    ),
    ("App::PropertyBool", "FacesXi", "Plot", "Show the faces across ξ of the blocks", True, 0),
    ("App::PropertyBool", "FacesEta", "Plot", "Show the faces across η of the blocks", True, 0),
    ("App::PropertyBool", "FacesZeta", "Plot", "Show the faces across ζ of the blocks", True, 0),
    (
        "App::PropertyEnumeration",
        "ColourBy",
        "Plot",
        "Colour the elements by a metric of their quality",
        [PLAIN, *METRICS],
        0,
    ),
    ("App::PropertyEnumeration", "Cut", "Plot", "Axis across which the mesh is cut open", CUTS, 0),
    (
        "App::PropertyFloatConstraint",
        "CutAt",
        "Plot",
        "Where the cut is, in percent of the mesh's length along the axis",
        (50.0, 0.0, 100.0, 1.0),
        0,
    ),
    ("App::PropertyBool", "CutFlip", "Plot", "Keep the other side of the cut", False, 0),
    (
        "App::PropertyFloatConstraint",
        "Shrink",
        "Plot",
        "How much each element is drawn smaller, from 0 to 0.9",
        (0.0, 0.0, 0.9, 0.05),
        0,
    ),
)
_PLOT = tuple(row[1] for row in PROPERTIES)


class MeshView(ViewProvider):
    """Base; a subclass sets icon_name, panel and colour."""

    colour: Tuple[float, float, float] = (0.7, 0.7, 0.75)
    scene: Any = None

    def dress(self, vobj: Any) -> None:
        set_face_colour(vobj, *self.colour)
        vobj.BackfaceCulling = False
        vobj.DisplayMode = MODE

    def attach(self, vobj: Any) -> None:
        super().attach(vobj)
        add_properties(vobj, PROPERTIES)
        from .mesh_scene import MeshScene  # only here: Coin takes a while to import

        self.scene = MeshScene()
        vobj.addDisplayMode(self.scene.root, MODE)

    def getDisplayModes(self, vobj: Any) -> List[str]:
        return [MODE]

    def getDefaultDisplayMode(self) -> str:
        return MODE

    def setDisplayMode(self, mode: str) -> str:
        return mode

    def claimChildren(self) -> List[Any]:
        blocks = getattr(self.Object, "Blocks", None)
        return [blocks] if blocks else []

    def show_stale(self, vobj: Any) -> None:
        super().show_stale(vobj)
        if self.scene is not None:
            self.scene.fade(vobj.Object.Stale)

    def updateData(self, obj: Any, prop: str) -> None:
        # Set last whenever the mesh changes, by undo as well.
        if prop == "Content":
            self.redraw(obj.ViewObject)

    def onChanged(self, vobj: Any, prop: str) -> None:
        super().onChanged(vobj, prop)
        if prop in _PLOT or prop in ("ShapeColor", "ShapeAppearance", "Transparency", "LineWidth"):
            self.redraw(vobj)
        elif prop in ("Visibility", "DisplayMode") and self._waiting:
            self.redraw(vobj)

    #: Something changed while nobody could see it.
    _waiting = False

    def redraw(self, vobj: Any) -> None:
        """Draws the mesh by the plot options, at once if it is seen, else when it will be."""
        obj = vobj.Object
        if self.scene is None or not hasattr(vobj, "Shrink"):
            return
        proxy = getattr(obj, "Proxy", None)
        if obj.Document.Restoring:
            later(lambda: self.redraw(vobj))
            return
        if not obj.ElementCount or not hasattr(proxy, "mesh"):
            self.scene.clear()
            self._waiting = True
            return
        if not vobj.Visibility or vobj.DisplayMode != MODE:
            self._waiting = True
            return
        self._waiting = False
        metric = "" if vobj.ColourBy == PLAIN else vobj.ColourBy
        try:
            mesh = proxy.mesh(obj)
            self.scene.draw(
                mesh,
                plot_options(vobj, mesh),
                face_colour(vobj),
                metric,
                vobj.Transparency / 100.0,
                getattr(vobj, "LineWidth", 1.0),
                metric.replace("_", " "),
            )
            self.scene.fade(getattr(obj, "Stale", False))
        except Exception as error:
            # A picture that fails must not fail the document.
            FreeCAD.Console.PrintError(f"{obj.Label}: cannot be drawn: {error}\n")

    def mark(self, cells: Optional[Dict[str, np.ndarray]]) -> None:
        """Shows cells, {type: indices}, before all others; None or nothing: as it was."""
        if self.scene is not None:
            self.scene.mark(self.Object.Proxy.mesh(self.Object), cells or {})


def plot_options(vobj: Any, mesh: Any) -> PlotOptions:
    """The view's properties as the console API's options."""
    cut = None
    if vobj.Cut in CUTS[1:] and len(mesh.points):
        axis = CUTS.index(vobj.Cut) - 1
        low, high = mesh.points[:, axis].min(), mesh.points[:, axis].max()
        normal = np.zeros(3)
        normal[axis] = -1.0 if vobj.CutFlip else 1.0
        cut = (normal * normal[axis] * (low + (high - low) * vobj.CutAt / 100.0), normal)
    return PlotOptions(
        simplices=vobj.PlotAs == KINDS[1],
        directions=(vobj.FacesXi, vobj.FacesEta, vobj.FacesZeta),
        cut=cut,
        shrink=vobj.Shrink,
    )
