# SPDX-License-Identifier: LGPL-2.1-or-later
"""Number and spacing of the elements along picked edges, with arrows along all that will change."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import FreeCADGui
import numpy as np

from .. import nmgs
from ..nmgs import grading as gradings_of
from ..nmgs.block_model import BlockModel
from ..nmgs.grading import Grading
from ..objects import gradings
from ..objects.block_edges import unique_edges
from ..texts import tr
from . import tables
from .model_panel import ModelPanel

#: In the order of the combo box: kind of Grading, and which of the boxes it needs.
KINDS: Tuple[Tuple[str, Tuple[str, ...]], ...] = (
    ("uniform", ()),
    ("geometric", ("ratio",)),
    ("geometric", ("first",)),
    ("geometric", ("last",)),
    ("two_sided", ("ratio",)),
    ("two_sided", ("first", "last")),
    ("tanh", ("first", "last")),
)


class DivisionsPanel(ModelPanel):
    ui_name = "divisions"
    icon_name = "nmgs_divisions"

    def fill(self) -> None:
        form = self.form
        self._model: BlockModel = self.obj.Proxy.model(self.obj).copy()
        self._senses = self._model.chain_senses()
        self._at: Tuple[int, int] = (-1, 0)
        self._quiet = False
        form.chains.currentCellChanged.connect(lambda row, *_: self._choose_chain(row))
        form.count.valueChanged[int].connect(self._take)
        form.grading.currentIndexChanged[int].connect(self._take)
        form.ratio.valueChanged.connect(self._take)
        for box in (form.first, form.last):
            box.valueChanged.connect(self._take)
        form.turn.toggled.connect(self._take)
        self._firsts: List[Tuple[int, int]] = []
        for number in range(int(self._senses["chain"].max()) + 1):
            found = np.argwhere(self._senses["chain"] == number)
            if len(found):
                self._firsts.append((int(found[0][0]), int(found[0][1])))
        self._fill_chains()
        self._enable()
        # Edges can be picked only where they are seen.
        self._was_visible = self.obj.Visibility
        self.obj.Visibility = True
        FreeCADGui.Selection.addObserver(self)
        for pick in FreeCADGui.Selection.getSelectionEx():
            for name in pick.SubElementNames if pick.Object == self.obj else ():
                self._pick(name)

    def _fill_chains(self) -> None:
        table = self.form.chains
        titles = [tr("Block"), tr("Direction"), tr("Edges"), tr("Elements"), tr("Grading")]
        tables.prepare(table, titles, len(self._firsts))
        owners = unique_edges(self._model.nodes)
        from ..viewproviders.block_scene import directions

        along = directions(self._model)[owners[:, 1], 0]
        of_edges = self._senses["chain"][owners[:, 0], along]
        for row, (element, direction) in enumerate(self._firsts):
            number = self._senses["chain"][element, direction]
            cells = (
                str(element + 1),
                "ξηζ"[direction],
                str(int((of_edges == number).sum())),
                str(self._model.divisions[element, direction]),
                _kind_text(self._model.grading[element][direction]),
            )
            for column, text in enumerate(cells):
                tables.put(table, row, column, text, False)
        tables.fit_columns(table)

    # FreeCAD's observer of the selection.
    def addSelection(self, document: str, name: str, element: str, place: Any) -> None:
        if (document, name) == (self.obj.Document.Name, self.obj.Name):
            self._pick(element)

    def _pick(self, name: str) -> None:
        if not name.startswith("Edge"):
            return
        owners = unique_edges(self._model.nodes)
        number = int(name[4:]) - 1
        if number >= len(owners):
            return
        from ..viewproviders.block_scene import directions

        element, local = owners[number]
        direction = directions(self._model)[local, 0]
        wanted = self._senses["chain"][element, direction]
        for row, first in enumerate(self._firsts):
            if self._senses["chain"][first] == wanted:
                self.form.chains.selectRow(row)
                self._choose_chain(row)

    def _choose_chain(self, row: int) -> None:
        if not 0 <= row < len(self._firsts):
            return
        self._at = self._firsts[row]
        element, direction = self._at
        form = self.form
        self._quiet = True
        form.count.setValue(int(self._model.divisions[self._at]))
        self._show_grading(self._model.grading[element][direction])
        self._quiet = False
        number = self._senses["chain"][self._at]
        others = int((self._senses["chain"] == number).sum())
        form.picked.setText(
            tr(
                "{direction} of block {block}: {count} directions of blocks change together."
            ).format(direction="ξηζ"[direction], block=element + 1, count=others)
        )
        self._enable()
        self.check()

    def _show_grading(self, grading: Grading) -> None:
        form = self.form
        needs = tuple(n for n in ("ratio", "first", "last") if getattr(grading, n) is not None)
        same = [n for n, (kind, names) in enumerate(KINDS) if kind == grading.kind]
        exact = [n for n in same if KINDS[n][1] == needs]
        form.grading.setCurrentIndex((exact or same or [0])[0])
        length = float(self._senses["length"][self._at])
        even = length / int(self._model.divisions[self._at])
        form.ratio.setValue(grading.ratio or 1.2)
        form.first.setProperty("rawValue", grading.first or 0.5 * even)
        form.last.setProperty("rawValue", grading.last or 0.5 * even)
        form.turn.setChecked(grading.reverse)

    def _enable(self) -> None:
        form = self.form
        chosen = self._at[0] >= 0
        needs = KINDS[form.grading.currentIndex()][1]
        for widget in (form.count, form.grading, form.turn):
            widget.setEnabled(chosen)
        for name in ("ratio", "first", "last"):
            for widget in (getattr(form, name), getattr(form, f"{name}_label")):
                widget.setVisible(name in needs)

    def _grading(self) -> Grading:
        form = self.form
        kind, needs = KINDS[form.grading.currentIndex()]
        values: Dict[str, float] = {}
        for name in needs:
            box = getattr(form, name)
            value = box.value() if name == "ratio" else box.property("rawValue")
            # The kernel's own check of a size names it; 0 there stands for "none".
            if value > 0:
                values[name] = value
        made = getattr(gradings_of, kind)(**values)
        return made.reversed() if form.turn.isChecked() else made

    def _take(self, *_: Any) -> None:
        if self._quiet or self._at[0] < 0:
            return
        self._enable()
        try:
            trial = self._model.copy()
            # Spacings given one by one have to give way to another number of elements.
            trial.set_grading(*self._at, Grading())
            trial.set_divisions(hard={self._at: self.form.count.value()})
            trial.set_grading(*self._at, self._grading())
            trial.spacing
        except (ValueError, nmgs.Error) as error:
            self._tell(str(error))
            return
        self._model = trial
        row = self._firsts.index(self._at)
        self.form.chains.item(row, 3).setText(str(trial.divisions[self._at]))
        self.form.chains.item(row, 4).setText(_kind_text(trial.grading[self._at[0]][self._at[1]]))
        self.check()

    def model(self) -> BlockModel:
        return self._model

    def draw(self, model: BlockModel) -> None:
        from ..viewproviders import block_scene

        node = block_scene.separator()
        if not self.obj.ViewObject.ShowCounts:
            node.addChild(block_scene.counts(model))
        if self._at[0] >= 0:
            node.addChild(block_scene.chain(model, *self._at, self._senses))
        self.preview.show(node)

    def store(self, obj: Any, model: BlockModel) -> None:
        obj.AutoDivisions = False
        obj.Divisions = [int(n) for n in model.divisions.ravel()]
        obj.Grading = gradings.lines(model)

    def _close(self) -> None:
        FreeCADGui.Selection.removeObserver(self)
        self.obj.Visibility = self._was_visible
        super()._close()


def _kind_text(grading: Grading) -> str:
    if grading.kind == "uniform":
        return tr("uniform")
    values = [
        f"{name} {getattr(grading, name):.4g}"
        for name in ("ratio", "first", "last")
        if getattr(grading, name) is not None
    ]
    return ", ".join([grading.kind.replace("_", " "), *values])
