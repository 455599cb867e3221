# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panel of Patches and Blocks: how they are fitted and divided."""

from __future__ import annotations

from PySide import QtGui

from ..nmgs.cad import METHODS
from .base import Panel

_DIRECTIONS = ("ξ", "η", "ζ")


class BlockingPanel(Panel):
    ui_name = "blocking"

    @property
    def icon_name(self) -> str:
        return "nmgs_patches" if self._directions == 2 else "nmgs_blocks"

    @property
    def _directions(self) -> int:
        return 2 if self.obj.Proxy.nodes_per_element == 8 else 3

    def fill(self) -> None:
        form, obj = self.form, self.obj
        form.element_size.setProperty("rawValue", obj.Size.Value)
        form.tolerance.setProperty("rawValue", obj.Tolerance.Value)
        form.method.clear()
        form.method.addItems(METHODS)
        form.method.setCurrentText(obj.Method)
        form.reference.setText(obj.Reference)
        form.auto_divisions.setChecked(obj.AutoDivisions)
        form.auto_divisions.toggled.connect(self._divisions_enabled)
        # Elements that were read or typed in have nothing to be fitted to.
        for widget in (form.element_size, form.tolerance, form.method, form.auto_divisions):
            widget.setEnabled(bool(obj.Source))
        self._fill_divisions()
        self._divisions_enabled(obj.AutoDivisions)
        form.report.setText("\n".join(obj.Report))

    def _divisions_enabled(self, automatic: bool) -> None:
        self.form.divisions.setEnabled(not automatic)

    def _fill_divisions(self) -> None:
        table, count = self.form.divisions, self._directions
        values = self.obj.Divisions
        table.setColumnCount(count)
        table.setRowCount(len(values) // count)
        table.setHorizontalHeaderLabels(_DIRECTIONS[:count])
        for n, value in enumerate(values):
            table.setItem(n // count, n % count, QtGui.QTableWidgetItem(str(value)))
        table.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.Stretch)

    def _divisions(self) -> list:
        table = self.form.divisions
        values = []
        for row in range(table.rowCount()):
            for column in range(table.columnCount()):
                text = table.item(row, column).text()
                try:
                    values.append(int(text))
                except ValueError:
                    raise ValueError(
                        f"Divisions of element {row + 1} along {_DIRECTIONS[column]}: "
                        f"expected a whole number, got {text!r}"
                    ) from None
        return values

    def store(self) -> None:
        form, obj = self.form, self.obj
        if not form.auto_divisions.isChecked():
            obj.Divisions = self._divisions()
        obj.AutoDivisions = form.auto_divisions.isChecked()
        obj.Size = form.element_size.property("rawValue")
        obj.Tolerance = form.tolerance.property("rawValue")
        obj.Method = form.method.currentText()
        obj.Reference = form.reference.text()
