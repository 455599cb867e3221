# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view providers of Blocks and Patches share: curved edges with the counts on them."""

from __future__ import annotations

from typing import Any, Tuple

import FreeCAD

from ..objects import preferences
from ..objects.base import add_properties
from .base import ViewProvider, later

PROPERTIES = (
    (
        "App::PropertyBool",
        "ShowCounts",
        "Plot",
        "Show the number of elements along each edge",
        True,
        0,
    ),
)


#: Width of lines and size of points, of a few elements and of so many that they would cover all.
WIDE, FINE = (4.0, 8.0), (2.0, 3.0)
MANY = 100


class BlockingView(ViewProvider):
    """Base; a subclass sets icon_name."""

    _counts: Any = None

    @property
    def panel(self) -> Tuple[str, str]:  # type: ignore[override]
        """Fitted elements, those of the library and those by nodes have a panel each."""
        if self.Object.Source:
            return "blocking", "BlockingPanel"
        if self.Object.Library:
            return "shape_library", "ShapeLibraryPanel"
        return "node_table", "NodeTablePanel"

    def dress(self, vobj: Any) -> None:
        vobj.LineColor = (0.90, 0.45, 0.10)
        vobj.PointColor = (0.60, 0.10, 0.05)
        vobj.LineWidth, vobj.PointSize = WIDE
        vobj.ShowCounts = preferences.show_counts()

    def attach(self, vobj: Any) -> None:
        super().attach(vobj)
        add_properties(vobj, PROPERTIES)
        from .block_scene import separator  # only here: Coin takes a while to import

        self._counts = separator()
        vobj.RootNode.addChild(self._counts)

    def updateData(self, obj: Any, prop: str) -> None:
        if prop in ("ElementCount", "Divisions", "Shape"):
            later(lambda: self.write_counts(obj.ViewObject))
        if prop == "ElementCount":
            later(lambda: self.fit_widths(obj.ViewObject))

    def fit_widths(self, vobj: Any) -> None:
        """Lines and points for as many elements as there are, unless the user has chosen others."""
        wanted = FINE if vobj.Object.ElementCount > MANY else WIDE
        if (vobj.LineWidth, vobj.PointSize) in (WIDE, FINE):
            vobj.LineWidth, vobj.PointSize = wanted

    def onChanged(self, vobj: Any, prop: str) -> None:
        super().onChanged(vobj, prop)
        if prop in ("ShowCounts", "Visibility"):
            later(lambda: self.write_counts(vobj))

    def write_counts(self, vobj: Any) -> None:
        """The texts as the model is now."""
        if self._counts is None:
            return
        self._counts.removeAllChildren()
        if not (vobj.Visibility and vobj.ShowCounts and vobj.Object.ElementCount):
            return
        from .block_scene import counts

        try:
            model = vobj.Object.Proxy.shown(vobj.Object)
        except Exception as error:  # a half-restored or broken object has no counts to show
            FreeCAD.Console.PrintLog(f"{vobj.Object.Label}: {error}\n")
            return
        if model is not None:
            self._counts.addChild(counts(model))
