# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks typed in or edited node by node, checked as they are typed (thesis: New manual entry)."""

from __future__ import annotations

from typing import Any, List

import numpy as np

from .. import nmgs
from ..nmgs.block_model import BlockModel
from ..objects import blocking
from ..objects.block_edges import BLOCK_EDGES, PATCH_EDGES
from ..texts import tr
from . import tables
from .model_panel import ModelPanel

_AXES = ("x", "y", "z")
_DIRECTIONS = ("ξ", "η", "ζ")
_FIRST = 2  # column of x
_SIZE = 10.0  # mm, side of a new block


class NodeTablePanel(ModelPanel):
    ui_name = "node_table"

    def fill(self) -> None:
        form = self.form
        self.title = tr("Blocks by nodes")
        self._quiet = False
        self._nodes = 8 if self.obj is not None and self.obj.Proxy.nodes_per_element == 8 else 20
        form.kind.setCurrentIndex(0 if self._nodes == 8 else 1)
        form.kind.setEnabled(self.obj is None)
        form.kind.currentIndexChanged.connect(self._take_kind)
        form.add.clicked.connect(self._add)
        form.remove.clicked.connect(self._remove)
        form.straighten.clicked.connect(self._straighten)
        form.nodes.itemChanged.connect(lambda item: self._judge(form.nodes, item))
        form.divisions.itemChanged.connect(lambda item: self._judge(form.divisions, item))
        if self.obj is None:
            self._show(_new(self._nodes))
        else:
            form.reference.setText(self.obj.Reference)
            self._show(self.obj.Proxy.model(self.obj))

    def _show(self, model: BlockModel) -> None:
        self._quiet = True
        table, count = self.form.nodes, model.nodes.shape[1]
        tables.prepare(table, [tr("Block"), tr("Node"), *_AXES], len(model) * count)
        for row, place in enumerate(model.nodes.reshape(-1, 3).tolist()):
            tables.put(table, row, 0, str(row // count + 1), False)
            tables.put(table, row, 1, str(row % count + 1), False)
            for axis, value in enumerate(place):
                tables.put(table, row, _FIRST + axis, f"{value:.12g}")
        tables.fit_columns(table)
        table = self.form.divisions
        tables.prepare(table, [tr("Block"), *_DIRECTIONS[: model.dimension]], len(model))
        for row, counts in enumerate(model.divisions.tolist()):
            tables.put(table, row, 0, str(row + 1), False)
            for column, value in enumerate(counts):
                tables.put(table, row, column + 1, str(value))
        self._quiet = False
        self.changed()

    def _judge(self, table: Any, item: Any) -> None:
        if self._quiet:
            return
        self._quiet = True
        nodes = table is self.form.nodes
        value = tables.number(table, item.row(), item.column(), whole=not nodes)
        problem = ""
        if value is None or (not nodes and value < 1):
            problem = tr("expected a number") if nodes else tr("expected a whole number from 1 on")
        tables.judge(item, problem)
        self._quiet = False
        self.changed()

    def _numbers(self, table: Any, columns: int, whole: bool) -> np.ndarray:
        first = table.columnCount() - columns
        rows: List[List[float]] = []
        for row in range(table.rowCount()):
            values = [tables.number(table, row, first + c, whole) for c in range(columns)]
            if None in values:
                at = values.index(None)
                raise ValueError(
                    tr("Block {block}, {what}: expected a number, got {text!r}").format(
                        block=table.item(row, 0).text(),
                        what=self._what(table, row, first + at),
                        text=table.item(row, first + at).text(),
                    )
                )
            rows.append(values)
        return np.array(rows)

    def _what(self, table: Any, row: int, column: int) -> str:
        title = table.horizontalHeaderItem(column).text()
        if table is self.form.divisions:
            return tr("divisions along {axis}").format(axis=title)
        return tr("node {node}, {axis}").format(node=table.item(row, 1).text(), axis=title)

    def model(self) -> BlockModel:
        places = self._numbers(self.form.nodes, 3, False)
        directions = 2 if self._nodes == 8 else 3
        divisions = self._numbers(self.form.divisions, directions, True)
        return BlockModel(places.reshape(-1, self._nodes, 3), divisions, self.form.reference.text())

    def store(self, obj: Any, model: BlockModel) -> None:
        if self.obj is not None and len(obj.Grading) == model.divisions.size:
            blocking.gradings.put(model, obj.Grading)
        path = obj.File
        blocking.fill(obj, model, path)

    def _take_kind(self, index: int) -> None:
        self._nodes = (8, 20)[index]
        self._show(_new(self._nodes))

    def _current(self) -> int:
        return max(self.form.nodes.currentRow(), 0) // self._nodes

    def _add(self) -> None:
        try:
            model = self.model()
        except (ValueError, nmgs.Error) as error:
            self._tell(str(error))
            return
        last = model.nodes[-1]
        # Beside the last one: its face ξ = 1 becomes the new one's ξ = -1.
        moved = last + (last[1] - last[0])
        self._show(
            BlockModel(
                np.concatenate([model.nodes, moved[None]]),
                np.concatenate([model.divisions, model.divisions[-1:]]),
                model.reference,
            )
        )
        self.form.nodes.setCurrentCell(len(model) * self._nodes, _FIRST)

    def _remove(self) -> None:
        count = self.form.divisions.rowCount()
        if count < 2:
            self._tell(tr("The last block cannot be removed."))
            return
        block = self._current()
        for _ in range(self._nodes):
            self.form.nodes.removeRow(block * self._nodes)
        self.form.divisions.removeRow(block)
        self._quiet = True
        for row in range(self.form.nodes.rowCount()):
            self.form.nodes.item(row, 0).setText(str(row // self._nodes + 1))
        for row in range(count - 1):
            self.form.divisions.item(row, 0).setText(str(row + 1))
        self._quiet = False
        self.changed()

    def _straighten(self) -> None:
        try:
            model = self.model()
        except (ValueError, nmgs.Error) as error:
            self._tell(str(error))
            return
        for a, middle, b in PATCH_EDGES if self._nodes == 8 else BLOCK_EDGES:
            block = model.nodes[self._current()]
            block[middle] = 0.5 * (block[a] + block[b])
        self._show(model)


def _new(nodes: int) -> BlockModel:
    shapes = nmgs.shapes
    return shapes.square(_SIZE, 4) if nodes == 8 else shapes.cube(_SIZE, 4)
