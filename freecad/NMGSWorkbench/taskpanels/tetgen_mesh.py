# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panel of TetGenMesh."""

from __future__ import annotations

from . import figures
from .base import Panel


class TetGenMeshPanel(Panel):
    ui_name = "tetgen_mesh"
    icon_name = "nmgs_tetgen_mesh"

    def fill(self) -> None:
        form, obj = self.form, self.obj
        form.switches.setText(obj.Switches)
        form.time_limit.setValue(obj.TimeLimit)
        form.figures.setText(figures.text(obj))

    def store(self) -> None:
        self.obj.Switches = self.form.switches.text()
        self.obj.TimeLimit = self.form.time_limit.value()
