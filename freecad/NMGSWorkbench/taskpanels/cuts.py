# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts through solids: proposed ones and picked faces, seen before they are made."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Optional, Tuple

import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from .. import nmgs
from ..nmgs.cuts import tool_faces
from ..objects import cut_solids, sources, stale
from ..resources import icon, ui
from ..texts import tr
from ..viewproviders.preview import Preview
from . import culprits, messages, tables
from .base import ok_cancel, tell
from .cutting_picks import cutting_picks
from .model_panel import close

_DELAY_MS = 60
#: Proposals shown at most: behind these none is of use to anybody.
_MOST = 40


class Row(NamedTuple):
    """A cut in the table: cut, or an object's face."""

    text: str
    resolves: str
    cut: Optional[nmgs.Cut] = None
    tool: Optional[sources.Entity] = None


class CutsPanel:
    """obj: the CutSolids that is changed; None for a new one, made by OK, of the solids in source
    (a LinkSubList's value). blocks: Blocks that fill the pieces from then on."""

    def __init__(self, obj: Any = None, source: Any = None, blocks: Any = None):
        self.obj, self.blocks = obj, blocks
        self.source = obj.Source if obj is not None else source
        self.document = (obj or self.source[0][0]).Document
        self.form = FreeCADGui.PySideUic.loadUi(ui("cuts"))
        self.form.setWindowIcon(QtGui.QIcon(icon("nmgs_cut_solids")))
        if obj is not None:
            self.form.setWindowTitle(obj.Label)
        self.preview = Preview(self.document)
        self.made: List[Row] = []
        if obj is not None:
            self.made = [_row(cut_solids.cut_of(line)) for line in obj.Cuts]
            self.made += [_tool_row(entity) for entity in sources.entities(obj.Tools)]
        self.solids = sources.picked_shape(self.source)
        self.pieces = self.solids
        self.rows: List[Row] = []
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.update)
        self.form.cuts.itemChanged.connect(self._checked)
        self.form.cuts.currentCellChanged.connect(lambda row, *_: self.draw())
        self.form.add.clicked.connect(self.add_picked)
        self._quiet = False
        FreeCADGui.Selection.clearSelection()
        # What is cut is seen, and can be picked.
        self._shown = [(part, part.Visibility) for part, _ in self.source]
        for part, _ in self._shown:
            part.Visibility = True
        if obj is not None:
            self._shown.append((obj, obj.Visibility))
            obj.Visibility = False
        self.update()

    def update(self) -> None:
        """Cuts as the checked rows say, and proposes what may be cut next."""
        problem = ""
        proposals: List[nmgs.Cut] = []
        try:
            self.pieces = cut_solids.pieces_of(self.source, *self._values())
            proposals = nmgs.propose_cuts(self.pieces)
        except (ValueError, nmgs.Error) as error:
            problem = str(error)
        self.rows = self.made + [_row(cut) for cut in proposals[:_MOST]]
        self._fill()
        text = tr("{count} pieces.").format(count=len(self.pieces.Solids))
        if not proposals and not problem:
            text += " " + tr("Nothing stands in the way of blocks.")
        self.form.summary.setText(text)
        tell(self.form, problem)
        self.draw()

    def _fill(self) -> None:
        table = self.form.cuts
        current = table.currentRow()
        self._quiet = True
        tables.prepare(table, [tr("Cut"), tr("Resolves")], len(self.rows))
        for n, row in enumerate(self.rows):
            item = tables.put(table, n, 0, row.text, False)
            item.setToolTip(row.text)
            item.setFlags(item.flags() | QtCore.Qt.ItemIsUserCheckable)
            on = n < len(self.made)
            item.setCheckState(QtCore.Qt.Checked if on else QtCore.Qt.Unchecked)
            tables.put(table, n, 1, row.resolves, False)
        header = table.horizontalHeader()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(0, QtGui.QHeaderView.Stretch)
        header.setSectionResizeMode(1, QtGui.QHeaderView.ResizeToContents)
        if 0 <= current < len(self.rows):
            table.setCurrentCell(current, 0)
        self._quiet = False

    def _checked(self, item: Any) -> None:
        if self._quiet or item.column() != 0:
            return
        row = self.rows[item.row()]
        on = item.checkState() == QtCore.Qt.Checked
        if on and row not in self.made:
            self.made.append(row)
        elif not on and row in self.made:
            self.made.remove(row)
        self._timer.start(_DELAY_MS)

    def add_picked(self) -> None:
        """Picked faces and planes become cuts."""
        rows = [_tool_row(entity) for entity in cutting_picks()]
        if not rows:
            tell(self.form, tr("Pick faces or planes in the view first."))
            return
        self.made += [row for row in rows if row not in self.made]
        self.update()

    def _values(self) -> Tuple[List[sources.Entity], List[nmgs.Cut]]:
        tools = [row.tool for row in self.made if row.tool is not None]
        return tools, [row.cut for row in self.made if row.cut is not None]

    def draw(self) -> None:
        """The pieces' edges, and where the row that is chosen cuts."""
        from ..viewproviders import scene_nodes

        group = scene_nodes.on_top()
        for edge in self.pieces.Edges:
            if not edge.Degenerated:
                count = 2 if edge.Curve.TypeId == "Part::GeomLine" else 17
                points = np.array([tuple(p) for p in edge.discretize(count)])
                group.addChild(scene_nodes.polylines(points[None], (0.90, 0.45, 0.10), 2.0))
        at = self.form.cuts.currentRow()
        if 0 <= at < len(self.rows):
            for face in self._section(self.rows[at]):
                group.addChild(face)
        self.preview.show(group)

    def _section(self, row: Row) -> List[Any]:
        from ..viewproviders import scene_nodes

        tool = row.cut if row.tool is None else cut_solids.tool_of(*row.tool)
        nodes = []
        for face in tool_faces(tool, self.solids.BoundBox):
            inside = face.common(self.solids)
            if not inside.Faces:
                continue
            points, triangles = inside.tessellate(0.01 * self.solids.BoundBox.DiagonalLength)
            node = scene_nodes.on_top()
            for child in (
                scene_nodes.two_sided(),
                scene_nodes.material((0.15, 0.55, 0.95), 0.4),
                scene_nodes.coordinates(np.array([tuple(p) for p in points])),
                scene_nodes.faces(np.array(triangles, dtype=np.int32)),
            ):
                node.addChild(child)
            nodes.append(node)
        return nodes

    def getStandardButtons(self) -> int:
        return ok_cancel()

    def accept(self) -> bool:
        if self.obj is None and not self.made:
            tell(self.form, tr("Check a cut, or pick faces and add them."))
            return False
        title = tr("Cut solids")
        self.document.openTransaction(title)
        try:
            obj = self._stored()
            if self.blocks is not None:
                self.blocks.Source = [(obj, _names(obj))]
                stale.compute(self.blocks)
        except Exception as error:
            self.document.abortTransaction()
            messages.show_error(title, error)
            return False
        self._restore_visibility()
        for part, _ in self.source:
            part.Visibility = False
        obj.Visibility = self.blocks is None
        self.document.recompute()
        self.document.commitTransaction()
        self._close()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.blocks or obj)
        return True

    def _stored(self) -> Any:
        obj = self.obj
        if obj is None:
            obj = cut_solids.make(self.document)
            obj.Source = self.source
        tools, cuts = self._values()
        obj.Tools = tools
        obj.Cuts = [cut_solids.line_of(cut) for cut in cuts]
        stale.compute(obj)
        return obj

    def reject(self) -> bool:
        self._restore_visibility()
        self._close()
        return True

    def _restore_visibility(self) -> None:
        for part, shown in self._shown:
            part.Visibility = shown

    def _close(self) -> None:
        self._timer.stop()
        self.preview.clear()
        culprits.clear()
        close(self.document)


def _names(obj: Any) -> Tuple[str, ...]:
    return tuple(f"Solid{n + 1}" for n in range(obj.PieceCount))


def _row(cut: nmgs.Cut) -> Row:
    return Row(cut.name or tr("plane"), str(cut.resolves) if cut.resolves else "", cut=cut)


def _tool_row(entity: sources.Entity) -> Row:
    obj, name = entity
    return Row(f"{obj.Label}.{name}" if name else obj.Label, "", tool=entity)


def panel_for(picked: Any) -> CutsPanel:
    """The panel for picked: solids (a LinkSubList's value), or Blocks, whose solids are cut, or
    what cuts them already is changed."""
    if isinstance(picked, list):
        return CutsPanel(source=picked)
    owners = {obj.Name: obj for obj, _ in picked.Source}
    if len(owners) == 1:
        (owner,) = owners.values()
        if isinstance(getattr(owner, "Proxy", None), cut_solids.CutSolids):
            return CutsPanel(owner, blocks=picked)
    return CutsPanel(source=picked.Source, blocks=picked)
