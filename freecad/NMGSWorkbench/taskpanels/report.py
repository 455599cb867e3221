# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh report: counts, bounds, size, quality, and the worst elements shown in the 3D view."""

from __future__ import annotations

from typing import Any, List

import FreeCADGui
from PySide import QtCore, QtGui

from ..nmgs.mesh import CELL_TYPES
from ..nmgs.report import MetricSummary, Report
from ..objects.run import run
from ..resources import icon, ui
from .base import flags_value

_BAR = 24


class ReportPanel:
    """Changes nothing in the document. A row of the table picks the histogram below and shows the
    nodes of its worst elements."""

    def __init__(self, obj: Any):
        self.obj = obj
        self.mesh = obj.Proxy.mesh(obj)
        self.report: Report = run(
            lambda progress: self.mesh.report(progress=progress), "Measuring the mesh"
        )
        self.rows: List[MetricSummary] = [
            summary
            for cell_type, of_type in self.report.metrics.items()
            if CELL_TYPES[cell_type][1] == self._dimension()
            for summary in of_type.values()
        ]
        self.form = FreeCADGui.PySideUic.loadUi(ui("report"))
        self.form.setWindowTitle(f"Report of {obj.Label}")
        self.form.setWindowIcon(QtGui.QIcon(icon("nmgs_mesh_report")))
        self.form.summary.setText(summary_text(self.report))
        self._fill_metrics()
        self.form.metrics.currentCellChanged.connect(lambda row, *_: self._show(row))
        if self.rows:
            self.form.metrics.setCurrentCell(0, 0)
            self._show(0)

    def _dimension(self) -> int:
        # The faces on a volume mesh's boundary are not its elements.
        return max((CELL_TYPES[name][1] for name in self.report.metrics), default=0)

    def _fill_metrics(self) -> None:
        table = self.form.metrics
        table.setColumnCount(4)
        table.setHorizontalHeaderLabels(["Metric", "Worst", "Mean", "Best"])
        table.setRowCount(len(self.rows))
        many = len({summary.cell_type for summary in self.rows}) > 1
        for row, summary in enumerate(self.rows):
            name = summary.metric.replace("_", " ")
            title = f"{name} ({summary.cell_type})" if many else name
            values = [f"{v:.4g}" for v in (summary.worst, summary.mean, summary.best)]
            for column, text in enumerate([title, *values]):
                item = QtGui.QTableWidgetItem(text)
                if column:
                    item.setTextAlignment(
                        flags_value(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                    )
                table.setItem(row, column, item)
        table.verticalHeader().hide()
        table.resizeColumnsToContents()
        table.resizeRowsToContents()

    def _show(self, row: int) -> None:
        if not 0 <= row < len(self.rows):
            return
        summary = self.rows[row]
        self._fill_histogram(summary)
        cells = self.mesh.cells[summary.cell_type][summary.worst_cells]
        if self.obj.ViewObject is not None:
            self.obj.ViewObject.HighlightedNodes = sorted({int(n) + 1 for n in cells.ravel()})

    def _fill_histogram(self, summary: MetricSummary) -> None:
        name = summary.metric.replace("_", " ")
        self.form.histogram_title.setText(
            f"Elements by {name}; the {len(summary.worst_cells)} worst are marked in the view"
        )
        table = self.form.histogram
        table.setColumnCount(3)
        table.setHorizontalHeaderLabels(["From, to", "Elements", ""])
        table.setRowCount(len(summary.histogram))
        highest = max(int(summary.histogram.max()), 1) if len(summary.histogram) else 1
        for row, count in enumerate(summary.histogram.tolist()):
            low, high = summary.edges[row], summary.edges[row + 1]
            # An element alone is still seen.
            bar = "█" * -(-_BAR * count // highest)
            for column, text in enumerate([f"{low:.3g} to {high:.3g}", str(count), bar]):
                table.setItem(row, column, QtGui.QTableWidgetItem(text))
        table.verticalHeader().hide()
        table.resizeColumnsToContents()
        table.resizeRowsToContents()

    def getStandardButtons(self) -> int:
        return flags_value(QtGui.QDialogButtonBox.Close)

    def reject(self) -> bool:
        if self.obj.ViewObject is not None:
            self.obj.ViewObject.HighlightedNodes = []
        FreeCADGui.Control.closeDialog()
        return True


def summary_text(report: Report) -> str:
    """Counts, bounds and size as lines to read."""
    lines = [", ".join(f"{count} {name}" for name, count in report.counts.items())]
    low, high = report.bounds
    for axis, a, b in zip("xyz", low, high):
        lines.append(f"{axis}: {a:.6g} to {b:.6g} mm")
    for name, unit in (("length", "mm"), ("area", "mm²"), ("volume", "mm³")):
        value = getattr(report, name)
        if value:
            lines.append(f"{name}: {value:.9g} {unit}")
    return "\n".join(lines)
