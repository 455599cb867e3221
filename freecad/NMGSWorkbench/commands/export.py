# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PySide import QtGui

from .. import export_object
from ..objects.base import DocumentObject
from ..taskpanels import messages
from . import selection
from .base import Command


class Export(Command):
    icon_name = "nmgs_export"
    menu_text = "Export"
    tooltip = "Write the picked blocks or mesh to a file: N2S, N3S, N2R, N3R, TetGen, FEM formats"

    def ready(self) -> bool:
        return len(selection.picked(DocumentObject)) == 1

    def act(self, document: Any) -> Any:
        found = selection.picked(DocumentObject)
        if len(found) != 1:
            raise ValueError("Pick one mesh, Blocks, Patches or PLC object.")
        obj = found[0]
        dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), f"Export {obj.Label}")
        dialog.setObjectName("NMGS_Export")
        dialog.setAcceptMode(QtGui.QFileDialog.AcceptSave)
        filters = export_object.filters(obj)
        dialog.setNameFilters(filters)
        dialog.selectFile(export_object.with_extension(obj.Label, filters[0]))

        def write(path: str) -> None:
            try:
                export_object.write(obj, path, dialog.selectedNameFilter())
            except Exception as error:
                messages.show_error(self.menu_text, error)

        dialog.fileSelected.connect(write)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()
        return None
