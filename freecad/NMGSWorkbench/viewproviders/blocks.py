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
        vobj.PointColor = (0.60, 0.10, 0.05)
        vobj.LineWidth = 4.0
        vobj.PointSize = 8.0
