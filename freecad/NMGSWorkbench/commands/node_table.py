# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks by nodes."""

from __future__ import annotations

from .panel import NewCommand


class NodeTable(NewCommand):
    icon_name = "nmgs_node_table"
    menu_text = "Blocks by nodes"
    tooltip = (
        "Type in patches of 8 nodes or blocks of 20 nodes, with a preview of their curved edges"
    )
    accel = "N, N"
    panel_name = ("node_table", "NodeTablePanel")
