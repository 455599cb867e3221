# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panel of TetGenMesh: presets, every option by name, and the switches that they amount to."""

from __future__ import annotations

import contextlib
from typing import Any, Iterator, Tuple

from ..nmgs import TetOptions
from ..texts import tr
from . import figures
from .base import Panel, tell
from .option_table import OptionTable


def presets() -> Tuple[Tuple[str, str], ...]:
    """What the user wants, and the switches that ask for it."""
    return (
        (tr("Quality mesh of the boundary"), "pq1.4"),
        (tr("Mesh of the boundary"), "p"),
        (tr("Mesh of the boundary, its triangles kept"), "pY"),
        (tr("Delaunay mesh of the points"), ""),
        (tr("Convex hull of the points"), "E"),
    )


class TetGenMeshPanel(Panel):
    ui_name = "tetgen_mesh"
    icon_name = "nmgs_tetgen_mesh"

    def __init__(self, obj: Any):
        self._quiet = False
        self._table: "OptionTable | None" = None
        super().__init__(obj)

    def fill(self) -> None:
        form, obj = self.form, self.obj
        if self._table is None:
            self._table = OptionTable(form.options)
            form.preset.addItems([tr("Own choice"), *(name for name, _ in presets())])
            form.preset.currentIndexChanged[int].connect(self._take_preset)
            form.switches.textChanged.connect(self._take_switches)
            form.options.itemChanged.connect(self._take_options)
        form.switches.setText(obj.Switches)
        self._take_switches(obj.Switches)
        form.time_limit.setValue(obj.TimeLimit)
        form.figures.setText(figures.text(obj))
        form.log.setPlainText(_log(obj))

    def store(self) -> None:
        self.obj.Switches = self.form.switches.text()
        self.obj.TimeLimit = self.form.time_limit.value()

    def apply(self) -> bool:
        done = super().apply()
        self.form.log.setPlainText(_log(self.obj))
        return done

    @contextlib.contextmanager
    def _silence(self) -> Iterator[bool]:
        """False within itself: one widget follows another, and not back again."""
        if self._quiet:
            yield False
            return
        self._quiet = True
        try:
            yield True
        finally:
            self._quiet = False

    def _take_preset(self, index: int) -> None:
        if index > 0 and not self._quiet:
            self.form.switches.setText(presets()[index - 1][1])

    def _take_switches(self, text: str) -> None:
        with self._silence() as mine:
            if not mine:
                return
            known = [switches for _, switches in presets()]
            self.form.preset.setCurrentIndex(known.index(text) + 1 if text in known else 0)
            try:
                self._table.show(TetOptions.parse(text))
            except ValueError as error:
                self._tell(str(error))
            else:
                self._tell("")

    def _take_options(self, *_: Any) -> None:
        with self._silence() as mine:
            if not mine:
                return
            try:
                text = str(self._table.options())
            except ValueError as error:
                self._tell(str(error))
                return
            self._tell("")
            self.form.switches.setText(text)
            self.form.preset.setCurrentIndex(0)

    def _tell(self, problem: str) -> None:
        tell(self.form, problem)


def _log(obj: Any) -> str:
    """TetGen's own words of the last run, failed or not; empty after a document was opened."""
    failure = obj.Proxy.failure
    if failure is not None:
        return getattr(failure, "log", "") or str(failure)
    tetgen = getattr(obj.Proxy.mesh(obj), "tetgen", None)
    return getattr(tetgen, "log", "") or ""
