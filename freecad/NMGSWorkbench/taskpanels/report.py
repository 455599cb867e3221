# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh report: counts, bounds, size, and quality as a histogram whose bars mark their elements."""

from __future__ import annotations

from typing import Any, Dict, List

import FreeCADGui
import numpy as np
from PySide import QtGui

from ..nmgs import _kernel
from ..nmgs.mesh import CELL_TYPES
from ..nmgs.report import MetricSummary, Report
from ..objects.run import run
from ..resources import icon, ui
from ..texts import tr
from . import tables
from .base import flags_value
from .histogram import Histogram


class ReportPanel:
    """Changes nothing in the document. A row of the first table picks the histogram below it."""

    def __init__(self, obj: Any):
        self.obj = obj
        self.mesh = obj.Proxy.mesh(obj)
        self.report: Report = run(
            lambda progress: self.mesh.report(bins=12, worst=20, progress=progress),
            tr("Measuring the mesh"),
        )
        self.rows: List[MetricSummary] = [
            summary
            for cell_type, of_type in self.report.metrics.items()
            if CELL_TYPES[cell_type][1] == self._dimension()
            for summary in of_type.values()
        ]
        self._row = -1
        # What is picked is drawn in the colour of the selection, not in its own.
        FreeCADGui.Selection.clearSelection()
        self._values: Dict[str, np.ndarray] = {}
        self._coloured_before = obj.ViewObject.ColourBy if self._view else ""
        self.form = FreeCADGui.PySideUic.loadUi(ui("report"))
        self.form.setWindowTitle(tr("Report of {name}").format(name=obj.Label))
        self.form.setWindowIcon(QtGui.QIcon(icon("nmgs_mesh_report")))
        self.form.summary.setText(summary_text(self.report))
        layout = QtGui.QVBoxLayout(self.form.histogram)
        layout.setContentsMargins(0, 0, 0, 0)
        self.histogram = Histogram(self.form.histogram, self.take_bar)
        layout.addWidget(self.histogram)
        self._fill_metrics()
        self.form.metrics.currentCellChanged.connect(lambda row, *_: self._show(row))
        self.form.worst.cellClicked.connect(lambda row, *_: self.take_worst(row))
        self.form.colours.toggled.connect(self._colour)
        if self.rows:
            self.form.metrics.setCurrentCell(0, 0)
            self._show(0)

    @property
    def _view(self) -> Any:
        """The view provider's proxy, where there is one that can mark."""
        view = getattr(self.obj.ViewObject, "Proxy", None)
        return view if hasattr(view, "mark") else None

    def _dimension(self) -> int:
        # The faces on a volume mesh's boundary are not its elements.
        return max((CELL_TYPES[name][1] for name in self.report.metrics), default=0)

    def _fill_metrics(self) -> None:
        table = self.form.metrics
        titles = [tr("Metric"), tr("Worst"), tr("Mean"), tr("Best")]
        tables.prepare(table, titles, len(self.rows))
        many = len({summary.cell_type for summary in self.rows}) > 1
        for row, summary in enumerate(self.rows):
            name = summary.metric.replace("_", " ")
            title = f"{name} ({summary.cell_type})" if many else name
            values = [f"{v:.4g}" for v in (summary.worst, summary.mean, summary.best)]
            for column, text in enumerate([title, *values]):
                tables.put(table, row, column, text, False)
        tables.fit_columns(table)

    def _show(self, row: int) -> None:
        if not 0 <= row < len(self.rows) or row == self._row:
            return
        self._row = row
        summary = self.rows[row]
        self.form.histogram_title.setText(
            tr("{type} by {metric}; a click on a bar marks its elements").format(
                type=summary.cell_type, metric=summary.metric.replace("_", " ")
            )
        )
        self.histogram.show_counts(summary.histogram, summary.edges, _colours(summary))
        table = self.form.worst
        titles = [tr("Worst elements"), tr("Value"), "x", "y", "z"]
        tables.prepare(table, titles, len(summary.worst_cells))
        for at, cell in enumerate(summary.worst_cells.tolist()):
            texts = [str(cell + 1), f"{summary.worst_values[at]:.4g}"]
            texts += [f"{c:.5g}" for c in summary.worst_places[at]]
            for column, text in enumerate(texts):
                tables.put(table, at, column, text, False)
        tables.fit_columns(table)
        self._mark({}, "")
        self._colour(self.form.colours.isChecked())

    def take_bar(self, number: int) -> None:
        """Marks the elements of a bar; -1: none."""
        summary = self.rows[self._row]
        if number < 0:
            self._mark({}, "")
            return
        low, high = summary.edges[number], summary.edges[number + 1]
        values = self._values_of(summary)
        last = number == len(summary.histogram) - 1
        inside = (values >= low) & ((values <= high) if last else (values < high))
        found = np.flatnonzero(inside)
        text = tr("{count} elements from {low} to {high} are marked").format(
            count=len(found), low=f"{low:.4g}", high=f"{high:.4g}"
        )
        self._mark({summary.cell_type: found}, text)

    def take_worst(self, row: int) -> None:
        """Marks one of the worst elements and zooms to it."""
        summary = self.rows[self._row]
        cell = int(summary.worst_cells[row])
        text = tr("Element {number} is marked").format(number=cell + 1)
        self._mark({summary.cell_type: np.array([cell])}, text)
        from ..viewproviders import camera  # only here: Coin takes a while to import

        places = self.mesh.points[self.mesh.cells[summary.cell_type][cell]]
        camera.zoom_to(places, self.obj.Document)

    def _values_of(self, summary: MetricSummary) -> np.ndarray:
        if summary.metric not in self._values:
            self._values = {summary.metric: self.mesh.quality(summary.metric)}
        return self._values[summary.metric][summary.cell_type]

    def _mark(self, cells: Dict[str, np.ndarray], text: str) -> None:
        self.form.marked.setText(text)
        if self._view is not None:
            self._view.mark(cells)

    def _colour(self, wanted: bool) -> None:
        if self._view is None:
            return
        metric = self.rows[self._row].metric if wanted and self.rows else self._coloured_before
        if self.obj.ViewObject.ColourBy != metric:
            self.obj.ViewObject.ColourBy = metric

    def getStandardButtons(self) -> int:
        return flags_value(QtGui.QDialogButtonBox.Close)

    def reject(self) -> bool:
        if self._view is not None:
            self._view.mark(None)
            self._colour(False)
        FreeCADGui.Control.closeDialog()
        return True


def _colours(summary: MetricSummary) -> np.ndarray:
    from ..viewproviders import legend  # only here: Coin takes a while to import

    middle = 0.5 * (summary.edges[:-1] + summary.edges[1:])
    larger = bool(_kernel.core().metrics()[summary.metric])
    return legend.colours(middle, summary.edges[0], summary.edges[-1], larger)


def summary_text(report: Report) -> str:
    """Counts, bounds and size as lines to read."""
    lines = [", ".join(f"{name}: {count}" for name, count in report.counts.items())]
    low, high = report.bounds
    for axis, a, b in zip("xyz", low, high):
        lines.append(
            tr("{axis}: {low} to {high} mm").format(axis=axis, low=f"{a:.6g}", high=f"{b:.6g}")
        )
    for name, title, unit in (
        ("length", tr("length"), "mm"),
        ("area", tr("area"), "mm²"),
        ("volume", tr("volume"), "mm³"),
    ):
        value = getattr(report, name)
        if value:
            lines.append(f"{title}: {value:.9g} {unit}")
    return "\n".join(lines)
