# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fit patches to faces."""

from __future__ import annotations

from typing import Any

from . import selection
from ..taskpanels.messages import report_left_out
from .base import Command


class FitPatches(Command):
    accel = "N, P"
    icon_name = "nmgs_fit_patches"
    menu_text = "Fit patches to faces"
    tooltip = "Lay 8-node patches over the picked faces, or over all faces of the picked objects"

    def ready(self) -> bool:
        return selection.can_pick("Face")

    def act(self, document: Any) -> Any:
        from ..objects import patches  # only here: it imports NumPy and Part

        source = selection.picked_faces()
        if not source:
            raise ValueError("Pick one or more faces, or an object that has faces.")
        obj = patches.make(document)
        obj.Source = source
        self.computed(obj)
        report_left_out(self.menu_text, obj)
        return obj
