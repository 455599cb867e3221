# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot options of a mesh or of blocks; the view follows each click. Cancel puts all back."""

from __future__ import annotations

from typing import Any, Dict

import FreeCADGui
from PySide import QtGui

from ..nmgs.report import METRICS
from ..resources import icon, ui
from ..texts import tr
from .base import ok_cancel

_CHECKS = {"xi": "FacesXi", "eta": "FacesEta", "zeta": "FacesZeta", "cut_flip": "CutFlip"}
_COMBOS = {"plot_as": "PlotAs", "cut": "Cut"}
_SLIDERS = {"cut_at": ("CutAt", 10.0), "shrink": ("Shrink", 100.0)}


class PlotPanel:
    """obj: a mesh object, or blocks."""

    def __init__(self, obj: Any):
        self.obj = obj
        self.view = view = obj.ViewObject
        # What is picked is drawn in the colour of the selection, not in its own.
        FreeCADGui.Selection.clearSelection()
        self.form = form = FreeCADGui.PySideUic.loadUi(ui("plot"))
        form.setWindowTitle(tr("Plot of {name}").format(name=obj.Label))
        form.setWindowIcon(QtGui.QIcon(icon("nmgs_plot")))
        is_mesh = hasattr(view, "PlotAs")
        names = [*_CHECKS.values(), *_COMBOS.values(), *(p for p, _ in _SLIDERS.values())]
        names = [*names, "ColourBy"] if is_mesh else ["ShowCounts"]
        self._before: Dict[str, Any] = {name: getattr(view, name) for name in names}
        if is_mesh:
            self._connect_mesh()
        else:
            form.counts.setChecked(view.ShowCounts)
            form.counts.toggled.connect(lambda on: self._set("ShowCounts", on))
        for name in ("xi", "eta", "zeta", "cut_flip", "plot_as", "cut", "cut_at", "shrink"):
            getattr(form, name).setVisible(is_mesh)
        for name in ("plot_as", "directions", "colour_by", "cut", "cut_at", "shrink"):
            getattr(form, f"{name}_label").setVisible(is_mesh)
        form.colour_by.setVisible(is_mesh)
        form.counts.setVisible(not is_mesh)

    def _connect_mesh(self) -> None:
        form, view = self.form, self.view
        for name, prop in _CHECKS.items():
            box = getattr(form, name)
            box.setChecked(getattr(view, prop))
            box.toggled.connect(lambda on, prop=prop: self._set(prop, on))
        for name, prop in _COMBOS.items():
            combo = getattr(form, name)
            values = view.getEnumerationsOfProperty(prop)
            combo.setCurrentIndex(values.index(getattr(view, prop)))
            combo.currentIndexChanged[int].connect(
                lambda n, prop=prop, values=values: self._set(prop, values[n])
            )
        metrics = view.getEnumerationsOfProperty("ColourBy")
        form.colour_by.addItems([tr("Plain"), *(name.replace("_", " ") for name in METRICS)])
        form.colour_by.setCurrentIndex(metrics.index(view.ColourBy))
        form.colour_by.currentIndexChanged[int].connect(lambda n: self._set("ColourBy", metrics[n]))
        for name, (prop, factor) in _SLIDERS.items():
            slider = getattr(form, name)
            slider.setValue(int(round(factor * getattr(view, prop))))
            slider.valueChanged.connect(
                lambda n, prop=prop, factor=factor: self._set(prop, n / factor)
            )

    def _set(self, prop: str, value: Any) -> None:
        setattr(self.view, prop, value)

    def getStandardButtons(self) -> int:
        return ok_cancel()

    def accept(self) -> bool:
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self) -> bool:
        for name, value in self._before.items():
            if getattr(self.view, name) != value:
                setattr(self.view, name, value)
        FreeCADGui.Control.closeDialog()
        return True
