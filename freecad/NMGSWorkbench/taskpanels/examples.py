# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gallery: examples by picture; OK, or a double click, opens one."""

from __future__ import annotations

import os
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import gallery, resources
from ..texts import tr
from . import messages
from .base import ok_cancel

_PICTURE = QtCore.QSize(150, 120)


def picture_of(name: str) -> str:
    """Path of an example's picture."""
    return os.path.join(os.path.dirname(resources.guide()), "pictures", f"example_{name}.png")


class ExamplesPanel:
    """Changes no document that is open."""

    def __init__(self, _: Any = None):
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(tr("Examples"))
        self.form.setWindowIcon(QtGui.QIcon(resources.icon("nmgs_examples")))
        layout = QtGui.QVBoxLayout(self.form)
        self.list = QtGui.QListWidget()
        self.list.setObjectName("examples")
        self.list.setIconSize(_PICTURE)
        self.list.setMinimumHeight(420)
        self.list.setWordWrap(True)
        for example in gallery.EXAMPLES:
            item = QtGui.QListWidgetItem(QtGui.QIcon(picture_of(example.name)), tr(example.title))
            item.setToolTip(tr(example.about))
            self.list.addItem(item)
        self.about = QtGui.QLabel()
        self.about.setObjectName("about")
        self.about.setWordWrap(True)
        layout.addWidget(self.list)
        layout.addWidget(self.about)
        self.list.currentRowChanged.connect(
            lambda row: self.about.setText(tr(gallery.EXAMPLES[row].about))
        )
        self.list.setCurrentRow(0)
        self.list.itemDoubleClicked.connect(lambda _: self.accept())

    def getStandardButtons(self) -> int:
        return ok_cancel()

    def accept(self) -> bool:
        FreeCADGui.Control.closeDialog()
        try:
            document = gallery.make(gallery.EXAMPLES[self.list.currentRow()].name)
        except Exception as error:
            messages.show_error(tr("Examples"), error)
            return True
        FreeCAD.setActiveDocument(document.Name)
        view = FreeCADGui.getDocument(document.Name).activeView()
        if hasattr(view, "viewIsometric"):
            view.viewIsometric()
            view.fitAll()
        return True

    def reject(self) -> bool:
        FreeCADGui.Control.closeDialog()
        return True
