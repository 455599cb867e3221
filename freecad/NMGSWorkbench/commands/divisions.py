# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divisions and grading."""

from __future__ import annotations

from typing import Any

from . import selection
from .panel import PanelCommand


class Divisions(PanelCommand):
    icon_name = "nmgs_divisions"
    menu_text = "Divisions and grading"
    tooltip = (
        "Number and spacing of the elements along picked edges of blocks, and along their chains"
    )
    accel = "N, D"
    panel_name = ("divisions", "DivisionsPanel")

    def ready(self) -> bool:
        return len(selection.picked(selection.BLOCKS)) == 1

    def argument(self) -> Any:
        found = selection.picked(selection.BLOCKS)
        if len(found) != 1:
            raise ValueError("Pick a Blocks or Patches object, or edges of one.")
        return found[0]
