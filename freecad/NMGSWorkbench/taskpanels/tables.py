# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels' tables share: filling, reading numbers, marking what is wrong."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from PySide import QtCore, QtGui

from .base import flags_value

_WRONG = QtGui.QColor(255, 190, 180)


def prepare(table: Any, titles: Sequence[str], rows: int) -> None:
    """Columns with titles, so many empty rows, no row numbers."""
    table.setColumnCount(len(titles))
    table.setHorizontalHeaderLabels(list(titles))
    table.setRowCount(rows)
    table.verticalHeader().setVisible(False)
    table.horizontalHeader().setStretchLastSection(True)


def put(table: Any, row: int, column: int, text: str, editable: bool = True) -> Any:
    """A cell's text; numbers stand to the right."""
    item = QtGui.QTableWidgetItem(text)
    if not editable:
        item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable)
    if text[:1].isdigit() or text[:1] == "-":
        item.setTextAlignment(flags_value(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter))
    table.setItem(row, column, item)
    return item


def number(table: Any, row: int, column: int, whole: bool = False) -> Optional[float]:
    """The number in a cell, None where there is none. A decimal comma is taken as well."""
    item = table.item(row, column)
    text = (item.text() if item else "").strip().replace(",", ".")
    try:
        value = float(int(text)) if whole else float(text)
    except ValueError:
        return None
    return value if abs(value) < float("inf") else None


def judge(item: Any, problem: str) -> None:
    """Marks a cell as wrong, with the reason; "" takes the mark away."""
    item.setBackground(QtGui.QBrush(_WRONG) if problem else QtGui.QBrush())
    item.setToolTip(problem)


def fit_columns(table: Any) -> None:
    table.resizeColumnsToContents()
    table.horizontalHeader().setStretchLastSection(True)
