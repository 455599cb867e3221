# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels share that make or change blocks by hand: a preview, and nothing until OK."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import nmgs
from ..nmgs.block_model import BlockModel
from ..objects import blocks, patches, stale
from ..resources import icon, ui
from ..texts import tr
from ..viewproviders.preview import Preview
from . import messages
from .base import ok_cancel, tell

_DELAY_MS = 120


class ModelPanel:
    """A subclass sets the names and writes fill(), model() and store(obj, model).

    obj: what is changed; None for a new object, which is made by OK.
    """

    ui_name = ""
    icon_name = "nmgs_blocks"
    title = ""

    def __init__(self, obj: Any = None, document: Any = None):
        self.obj = obj
        self.document = obj.Document if obj is not None else document or FreeCAD.ActiveDocument
        self.form = FreeCADGui.PySideUic.loadUi(ui(self.ui_name))
        self.form.setWindowIcon(QtGui.QIcon(icon(self.icon_name)))
        if obj is not None:
            self.form.setWindowTitle(obj.Label)
        self.preview = Preview(self.document)
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.check)
        self.fill()
        self.check()
        view = FreeCADGui.getDocument(self.document.Name).activeView()
        if not self.document.Objects and hasattr(view, "viewIsometric"):
            view.viewIsometric()
            view.fitAll()

    def fill(self) -> None:
        """Widgets as the object, or a new one, has it."""
        raise NotImplementedError

    def model(self) -> BlockModel:
        """What the widgets say. Raises ValueError or nmgs.Error in words."""
        raise NotImplementedError

    def store(self, obj: Any, model: BlockModel) -> None:
        """Puts it into the object's properties."""
        raise NotImplementedError

    def changed(self, *_: Any) -> None:
        """Connected to widgets: checks and previews when the typing pauses."""
        self._timer.start(_DELAY_MS)

    def check(self) -> None:
        """Says what is wrong, and draws what there is."""
        try:
            model = self.model()
        except (ValueError, nmgs.Error) as error:
            self._tell(str(error))
            return
        self._tell("\n".join(str(problem) for problem in model.check()[:3]))
        self.draw(model)

    def draw(self, model: BlockModel) -> None:
        from ..viewproviders import block_scene

        node = block_scene.separator()
        node.addChild(block_scene.edges(model))
        if len(model) <= 60:
            node.addChild(block_scene.counts(model))
        self.preview.show(node)

    def _tell(self, problem: str) -> None:
        tell(self.form, problem)

    def getStandardButtons(self) -> int:
        return ok_cancel()

    def accept(self) -> bool:
        title = self.title if self.obj is None else tr("Edit {name}").format(name=self.obj.Label)
        self.document.openTransaction(title)
        try:
            model = self.model()
            obj = self.obj
            if obj is None:
                obj = (patches if model.dimension == 2 else blocks).make(self.document)
            self.store(obj, model)
            with stale.forced():
                self.document.recompute([obj])
            if obj.Proxy.failure is not None:
                raise obj.Proxy.failure
        except Exception as error:
            self.document.abortTransaction()
            messages.show_error(title, error)
            return False
        self.document.recompute()
        self.document.commitTransaction()
        self._close()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(obj)
        return True

    def reject(self) -> bool:
        self._close()
        return True

    def _close(self) -> None:
        self._timer.stop()
        self.preview.clear()
        close(self.document)


def close(document: Any) -> None:
    """Closes the task panel, opened by a double click or by a command."""
    gui = FreeCADGui.getDocument(document.Name)
    if gui.getInEdit() is not None:
        gui.resetEdit()
    FreeCADGui.Control.closeDialog()
