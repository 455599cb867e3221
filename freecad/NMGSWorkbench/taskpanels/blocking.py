# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panel of fitted Patches and Blocks: options, and what became of each face or solid."""

from __future__ import annotations

from typing import Any, Dict, List

import FreeCADGui
from PySide import QtCore, QtGui

from ..nmgs.cad import METHODS
from ..nmgs.tet_to_hexas import METHOD as UNSTRUCTURED
from ..texts import tr
from . import tables
from .base import Panel

_DIRECTIONS = ("ξ", "η", "ζ")
#: Of an entry of the report, in the order of the table's columns; what else it has comes behind.
_FIRST = ("entity", "method", "error", "reason")


class BlockingPanel(Panel):
    ui_name = "blocking"

    @property
    def icon_name(self) -> str:
        return "nmgs_patches" if self._directions == 2 else "nmgs_blocks"

    @property
    def _directions(self) -> int:
        return 2 if self.obj.Proxy.nodes_per_element == 8 else 3

    def connect(self) -> None:
        form = self.form
        form.auto_divisions.toggled.connect(self._divisions_enabled)
        form.report.cellClicked.connect(lambda row, *_: self.take_entry(row))
        form.cut.setVisible(self._directions == 3)
        form.cut.clicked.connect(self._cut)

    def fill(self) -> None:
        form, obj = self.form, self.obj
        form.element_size.setProperty("rawValue", obj.Size.Value)
        form.tolerance.setProperty("rawValue", obj.Tolerance.Value)
        form.method.clear()
        form.method.addItems(METHODS)
        form.method.setCurrentText(obj.Method)
        form.reference.setText(obj.Reference)
        form.keep_layout.setChecked(obj.KeepLayout)
        form.auto_divisions.setChecked(obj.AutoDivisions)
        self._fill_divisions()
        self._divisions_enabled(obj.AutoDivisions)
        self._fill_report()

    def _fill_report(self) -> None:
        form = self.form
        self.entries: List[Dict[str, Any]] = self.obj.Proxy.entries(self.obj)
        left_out = sum(not entry.get("method") for entry in self.entries)
        text = tr("{blocks} blocks").format(blocks=self.obj.ElementCount)
        if left_out:
            text += "; " + tr("{left} of {all} could not be used").format(
                left=left_out, all=len(self.entries)
            )
        if any(_in_the_way(entry) for entry in self.entries):
            text += ". " + tr("A click on a row picks what stands in the way of structured blocks.")
        form.summary.setText(text)
        further = [
            key
            for key in dict.fromkeys(key for entry in self.entries for key in entry)
            if key not in _FIRST
            and all(isinstance(e.get(key), (int, float, str, type(None))) for e in self.entries)
        ]
        titles = [tr("Geometry"), tr("Method"), tr("Off the CAD"), tr("Reason")]
        titles += [key.replace("_", " ") for key in further]
        tables.prepare(form.report, titles, len(self.entries))
        for row, entry in enumerate(self.entries):
            owner = self.obj.Proxy.owner(self.obj, entry["entity"])
            who = f"{owner[0].Label}.{owner[1]}" if owner else entry["entity"]
            method = entry.get("method") or tr("left out")
            texts = [who, method, _text(entry.get("error")) if entry.get("method") else ""]
            texts += [_text(entry.get(key)) for key in ("reason", *further)]
            for column, words in enumerate(texts):
                tables.put(form.report, row, column, words, False).setToolTip(words)
        tables.fit_columns(form.report)

    def take_entry(self, row: int) -> None:
        """Picks in the view what stands in the way of blocks; else the face or solid of the row."""
        entry = self.entries[row]
        FreeCADGui.Selection.clearSelection()
        for name in _in_the_way(entry) or [entry["entity"]]:
            owner = self.obj.Proxy.owner(self.obj, name)
            if owner is not None:
                FreeCADGui.Selection.addSelection(owner[0].Document.Name, owner[0].Name, owner[1])

    def _cut(self) -> None:
        if not self.accept():
            return
        from . import cuts  # only here: few open it

        # When this panel is gone.
        blocks = self.obj
        QtCore.QTimer.singleShot(0, lambda: FreeCADGui.Control.showDialog(cuts.panel_for(blocks)))

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
                        tr(
                            "Divisions of element {element} along {axis}: "
                            "expected a whole number, got {text!r}"
                        ).format(element=row + 1, axis=_DIRECTIONS[column], text=text)
                    ) from None
        return values

    def store(self) -> None:
        form, obj = self.form, self.obj
        if not form.auto_divisions.isChecked():
            obj.Divisions = self._divisions()
        obj.AutoDivisions = form.auto_divisions.isChecked()
        obj.KeepLayout = form.keep_layout.isChecked()
        obj.Size = form.element_size.property("rawValue")
        obj.Tolerance = form.tolerance.property("rawValue")
        obj.Method = form.method.currentText()
        obj.Reference = form.reference.text()


def _in_the_way(entry: Dict[str, Any]) -> List[str]:
    """Edges and faces for which a solid has no structured blocks."""
    structured = entry.get("method") not in ("", UNSTRUCTURED)
    return [] if structured else list(entry.get("blockers") or ())


def _text(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.3g}" if isinstance(value, float) else str(value)
