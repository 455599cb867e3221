# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLC in the tree and the 3D view."""

from __future__ import annotations

from typing import Any

from .base import ViewProvider


class PlcView(ViewProvider):
    icon_name = "nmgs_plc"
    panel = ("", "")

    def dress(self, vobj: Any) -> None:
        vobj.LineColor = (0.35, 0.35, 0.60)
        vobj.PointColor = vobj.LineColor
        vobj.PointSize = 4.0
        vobj.Transparency = 50
