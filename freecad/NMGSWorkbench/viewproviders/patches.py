# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches in the tree and the 3D view."""

from __future__ import annotations

from .blocking_view import BlockingView


class PatchesView(BlockingView):
    icon_name = "nmgs_patches"
