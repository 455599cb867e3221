# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work: off the main thread, behind a dialog, stopped by its Cancel."""

import threading

import FreeCADGui
import numpy as np
import pytest
from conftest import content, message_boxes, pick, run, screenshot
from PySide import QtCore, QtGui

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.commands import tetgen_mesh
from freecad.NMGSWorkbench.objects import plc
from freecad.NMGSWorkbench.objects.run import run as run_job
from freecad.NMGSWorkbench.taskpanels import progress

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
SIDES = np.array(
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
)


def dialog():
    for widget in QtGui.QApplication.topLevelWidgets():
        if widget.objectName() == "NMGS_Progress" and widget.isVisible():
            return widget
    return None


@pytest.fixture
def when_shown():
    """Calls a function with the dialog once it is there; the list says what it saw."""
    timers = []

    def call(function):
        timer = QtCore.QTimer()

        def look():
            found = dialog()
            if found is not None and function(found):
                timer.stop()

        timer.timeout.connect(look)
        timer.start(20)
        timers.append(timer)

    yield call
    for timer in timers:
        timer.stop()


def press_cancel(found):
    found.findChild(QtGui.QPushButton).click()
    return True


def test_the_window_installs_the_dialog():
    from freecad.NMGSWorkbench.objects import run as module

    assert module._runner is progress.run_behind_dialog


def test_short_work_shows_nothing(when_shown):
    seen = []
    when_shown(seen.append)
    assert run_job(lambda progress: 42, "Thinking") == 42
    assert seen == []


def test_errors_come_through():
    def fail(progress):
        raise ValueError("seven")

    with pytest.raises(ValueError, match="seven"):
        run_job(fail, "Failing")


def test_long_work_runs_off_the_main_thread_and_shows_how_far_it_is(when_shown):
    told, seen = threading.Event(), []

    def job(progress):
        progress(0.25)
        assert told.wait(30)
        return threading.current_thread() is threading.main_thread()

    def look(found):
        # The window lives on: this is called while the job waits for it.
        if found.maximum() == 0:
            return False
        seen.append((found.value() / found.maximum(), found.labelText()))
        screenshot("progress")
        told.set()
        return True

    when_shown(look)
    assert run_job(job, "Waiting for the window") is False
    assert seen == [(0.25, "Waiting for the window")]
    assert dialog() is None


def test_cancel(when_shown):
    stopped = threading.Event()

    def job(progress):
        while progress(0.5) is not False:
            stopped.wait(0.01)
        stopped.set()

    when_shown(press_cancel)
    with pytest.raises(nmgs.Cancelled):
        run_job(job, "Working for ever")
    assert stopped.is_set() and dialog() is None


def test_cancelled_tetgen_leaves_everything_as_it_was(document, when_shown):
    """A cube in tetrahedra of 1e-8 would take TetGen hours."""
    source = plc.make(document, nmgs.PLC(CUBE, SIDES))
    pick(source)
    run("NMGS_TetGenMesh")
    mesh = document.getObject("TetGenMesh")
    before, steps = content(mesh), document.UndoCount
    when_shown(press_cancel)
    document.openTransaction("finer")
    mesh.Switches = "pqa0.00000001"
    document.recompute()
    assert isinstance(mesh.Proxy.failure, nmgs.Cancelled)
    assert not mesh.isValid() and content(mesh) == before
    document.abortTransaction()
    assert mesh.Switches == "pq" and document.UndoCount == steps
    assert message_boxes() == []


def test_a_cancelled_command_adds_nothing(document, when_shown, monkeypatch):
    monkeypatch.setattr(tetgen_mesh, "suggested_switches", lambda source: "pqa0.00000001")
    source = plc.make(document, nmgs.PLC(CUBE, SIDES))
    pick(source)
    when_shown(press_cancel)
    run("NMGS_TetGenMesh")
    assert document.Objects == [source] and message_boxes() == []
    assert FreeCADGui.Selection.getSelection() == [source]
