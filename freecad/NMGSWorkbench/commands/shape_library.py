# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shape library."""

from __future__ import annotations

from .panel import NewCommand


class ShapeLibrary(NewCommand):
    icon_name = "nmgs_shape_library"
    menu_text = "Shape library"
    tooltip = "Ready-made blocks and patches: cylinders, balls, tori and others, chosen by picture"
    accel = "N, S"
    panel_name = ("shape_library", "ShapeLibraryPanel")
