# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks in the tree and the 3D view."""

from __future__ import annotations

from typing import Any

from .base import ViewProvider


class BlocksView(ViewProvider):
    icon_name = "nmgs_blocks"
    panel = ("blocking", "BlockingPanel")

    def dress(self, vobj: Any) -> None:
        vobj.LineColor = (0.90, 0.45, 0.10)
        vobj.PointColor = vobj.LineColor
        vobj.LineWidth = 3.0
        vobj.PointSize = 5.0
