# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen's options in a QTableWidget: name, letter, value."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from ..nmgs import TetOptions
from ..texts import tr

VALUE = 2


class OptionTable:
    """Shows and reads a TetOptions. Switches are ticked; numbers are typed, empty for none."""

    def __init__(self, table: Any):
        self._table = table
        self._rows = TetOptions.table(TetOptions().version)
        table.setColumnCount(3)
        table.setHorizontalHeaderLabels([tr("Option"), tr("Switch"), tr("Value")])
        table.setRowCount(len(self._rows))
        table.verticalHeader().setVisible(False)
        fixed = QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable
        for number, row in enumerate(self._rows):
            sentence = row.sentence
            if not isinstance(row.default, bool):
                sentence += (
                    f" ({row.low:g} to {row.high:g}; default {_text(row.default) or 'none'})"
                )
            for column, text in enumerate((row.name.replace("_", " "), row.letter, "")):
                item = QtGui.QTableWidgetItem(text)
                item.setToolTip(sentence)
                if column != VALUE:
                    item.setFlags(fixed)
                elif isinstance(row.default, bool):
                    item.setFlags(fixed | QtCore.Qt.ItemIsUserCheckable)
                table.setItem(number, column, item)
        table.resizeColumnsToContents()
        table.horizontalHeader().setStretchLastSection(True)

    def show(self, options: TetOptions) -> None:
        for number, row in enumerate(self._rows):
            item = self._table.item(number, VALUE)
            value = getattr(options, row.name)
            if isinstance(row.default, bool):
                item.setCheckState(QtCore.Qt.Checked if value else QtCore.Qt.Unchecked)
            else:
                item.setText(_text(value))

    def options(self) -> TetOptions:
        """What the table says. Raises ValueError that names the option and its value."""
        options = TetOptions()
        for number, row in enumerate(self._rows):
            item = self._table.item(number, VALUE)
            if isinstance(row.default, bool):
                value: Any = item.checkState() == QtCore.Qt.Checked
            else:
                value = _number(row, item.text().strip())
            if value != row.default:
                setattr(options, row.name, value)
        return options


def _text(value: Any) -> str:
    return "" if value is None else f"{value:.12g}"


def _number(row: Any, text: str) -> Any:
    if not text:
        return row.default
    try:
        return int(text) if isinstance(row.default, int) or row.number is int else float(text)
    except ValueError:
        raise ValueError(f"{row.name}: expected a number, got {text!r}") from None
