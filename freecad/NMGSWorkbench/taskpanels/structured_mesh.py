# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panel of StructuredMesh."""

from __future__ import annotations

from ..texts import tr
from . import figures
from .base import Panel


class StructuredMeshPanel(Panel):
    ui_name = "structured_mesh"
    icon_name = "nmgs_structured_mesh"

    def fill(self) -> None:
        form, obj = self.form, self.obj
        form.order.clear()
        form.order.addItems([tr("1: linear elements"), tr("2: quadratic elements")])
        form.order.setCurrentIndex(obj.Order - 1)
        form.split.setChecked(obj.Split)
        form.snap.setChecked(obj.Snap)
        form.tolerance.setProperty("rawValue", obj.Tolerance.Value)
        form.figures.setText(figures.text(obj))

    def store(self) -> None:
        form, obj = self.form, self.obj
        obj.Order = form.order.currentIndex() + 1
        obj.Split = form.split.isChecked()
        obj.Snap = form.snap.isChecked()
        obj.Tolerance = form.tolerance.property("rawValue")
