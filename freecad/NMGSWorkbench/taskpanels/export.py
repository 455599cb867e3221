# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export: format, file, order, groups."""

from __future__ import annotations

import os
from typing import Any, List, Optional

import FreeCADGui
from PySide import QtCore, QtGui

from .. import export_object
from ..nmgs.mesh import Mesh
from ..objects.run import run
from ..resources import icon, ui
from ..texts import tr
from . import messages
from .base import ok_cancel


class ExportPanel:
    """Changes nothing in the document. OK writes the file and closes."""

    def __init__(self, obj: Any):
        self.obj = obj
        self.content = export_object.content(obj)
        self.form = form = FreeCADGui.PySideUic.loadUi(ui("export"))
        form.setWindowTitle(tr("Export {name}").format(name=obj.Label))
        form.setWindowIcon(QtGui.QIcon(icon("nmgs_export")))
        self._formats = export_object.formats(obj)
        form.format.addItems([f"{text} (*.{name})" for name, text in self._formats])
        form.format.currentIndexChanged[int].connect(self._take_format)
        form.path.textChanged.connect(self._take_path)
        form.browse.clicked.connect(self._browse)
        is_mesh = isinstance(self.content, Mesh)
        for name in ("order", "order_label", "split", "groups", "groups_label"):
            getattr(form, name).setVisible(is_mesh)
        for name, (kind, members) in self.content.groups.items() if is_mesh else ():
            item = QtGui.QListWidgetItem(f"{name}  ({len(members)} {kind})")
            item.setData(QtCore.Qt.UserRole, name)
            item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Checked)
            form.groups.addItem(item)
        folder = os.path.dirname(obj.Document.FileName) or os.path.expanduser("~")
        form.path.setText(os.path.join(folder, f"{obj.Label}.{self._formats[0][0]}"))
        form.problem.setVisible(False)

    def _take_format(self, index: int) -> None:
        """The path's ending follows."""
        path = self.form.path.text()
        for name, _ in sorted(self._formats, key=lambda row: -len(row[0])):
            if path.lower().endswith(f".{name}"):
                path = path[: -len(name) - 1]
                break
        self.form.path.setText(f"{path}.{self._formats[index][0]}")

    def _take_path(self, path: str) -> None:
        """The format follows an ending that is known."""
        for number, (name, _) in enumerate(self._formats):
            if path.lower().endswith(f".{name}") and number != self.form.format.currentIndex():
                longer = [n for n, _ in self._formats if len(n) > len(name)]
                if not any(path.lower().endswith(f".{n}") for n in longer):
                    self.form.format.blockSignals(True)
                    self.form.format.setCurrentIndex(number)
                    self.form.format.blockSignals(False)

    def _browse(self) -> None:
        dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), self.form.windowTitle())
        dialog.setObjectName("NMGS_Export")
        dialog.setAcceptMode(QtGui.QFileDialog.AcceptSave)
        filters = export_object.filters(self.obj)
        dialog.setNameFilters(filters)
        dialog.selectNameFilter(filters[self.form.format.currentIndex()])
        dialog.selectFile(self.form.path.text())

        def take(path: str) -> None:
            if not os.path.splitext(path)[1]:
                path = export_object.with_extension(path, dialog.selectedNameFilter())
            self.form.path.setText(path)

        dialog.fileSelected.connect(take)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _groups(self) -> Optional[List[str]]:
        items = [self.form.groups.item(row) for row in range(self.form.groups.count())]
        return [
            item.data(QtCore.Qt.UserRole)
            for item in items
            if item.checkState() == QtCore.Qt.Checked
        ]

    def getStandardButtons(self) -> int:
        return ok_cancel()

    def accept(self) -> bool:
        form, content = self.form, self.content
        name = self._formats[form.format.currentIndex()][0]
        path = form.path.text()
        order, split = form.order.currentIndex(), form.split.isChecked()
        groups = self._groups()

        def job(progress: Any) -> None:
            shown = content
            if isinstance(shown, Mesh):
                shown = export_object.prepared(shown, order, split, groups)
            export_object.nmgs.write(path, shown, format=name)

        try:
            run(job, tr("Writing {path}").format(path=os.path.basename(path)))
        except Exception as error:
            messages.show_error(form.windowTitle(), error)
            return False
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self) -> bool:
        FreeCADGui.Control.closeDialog()
        return True
