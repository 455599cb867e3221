# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks in the tree and the 3D view."""

from __future__ import annotations

from .blocking_view import BlockingView


class BlocksView(BlockingView):
    icon_name = "nmgs_blocks"
