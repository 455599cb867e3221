# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work off the main thread, behind a progress dialog with Cancel."""

from __future__ import annotations

import sys
import threading
import time
from typing import Any, Callable

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..objects import run
from ..texts import tr

#: Work shorter than this handles no events at all.
INSTANT_S = 0.05
#: Work shorter than this shows no dialog; the window is drawn, but clicks and keys wait.
PATIENCE_S = 0.4
_POLL_MS = 40
_SWITCH_S = 0.0005


class _Worker(threading.Thread):
    """Runs the job. The main thread reads `fraction`, sets `cancelled`; no Qt is touched here."""

    def __init__(self, job: run.Job):
        super().__init__(name="nmgs", daemon=True)
        self._job = job
        self.fraction = -1.0
        self.cancelled = False
        self.result: Any = None
        self.error: Any = None

    def _progress(self, fraction: float) -> bool:
        self.fraction = fraction
        return not self.cancelled

    def run(self) -> None:
        try:
            self.result = self._job(self._progress)
        except BaseException as error:  # handed to the main thread, which raises it
            self.error = error


def _loop(
    worker: _Worker,
    poll: Callable[[], None],
    seconds: float = 1e9,
    flags: Any = QtCore.QEventLoop.AllEvents,
) -> None:
    """Handles events until the worker is done or the time is over."""
    loop = QtCore.QEventLoop()
    timer = QtCore.QTimer()
    end = time.monotonic() + seconds

    def tick() -> None:
        if not worker.is_alive() or time.monotonic() > end:
            loop.quit()
        else:
            poll()

    timer.timeout.connect(tick)
    timer.start(_POLL_MS)
    (loop.exec if hasattr(loop, "exec") else loop.exec_)(flags)
    timer.stop()


def _wait_behind_dialog(worker: _Worker, text: str) -> None:
    # The dialog is modal for the whole application: nobody changes the document meanwhile.
    dialog = QtGui.QProgressDialog(tr(text), tr("Cancel"), 0, 0, FreeCADGui.getMainWindow())
    dialog.setObjectName("NMGS_Progress")
    dialog.setWindowTitle("NMGS")
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(0)
    dialog.setAutoClose(False)
    dialog.setAutoReset(False)

    def poll() -> None:
        if worker.cancelled:
            dialog.setLabelText(tr("Stopping"))
        elif worker.fraction >= 0.0:
            dialog.setMaximum(1000)
            dialog.setValue(int(1000 * min(worker.fraction, 1.0)))

    def cancel() -> None:
        worker.cancelled = True
        # Qt hides a cancelled dialog; it stays until the work has stopped.
        dialog.show()

    dialog.canceled.connect(cancel)
    dialog.show()
    _loop(worker, poll)
    dialog.canceled.disconnect(cancel)
    dialog.hide()
    dialog.deleteLater()


def run_behind_dialog(job: run.Job, text: str) -> Any:
    """job(progress)'s result; raises what it raises, Cancelled when the user pressed Cancel."""
    application = QtCore.QCoreApplication.instance()
    if application is None or QtCore.QThread.currentThread() != application.thread():
        return job(None)
    worker = _Worker(job)
    worker.start()
    worker.join(INSTANT_S)
    interval = sys.getswitchinterval()
    # Each of Qt's calls into Python waits so long for a worker that is in Python as well.
    sys.setswitchinterval(_SWITCH_S)
    try:
        if worker.is_alive():
            waiting = QtCore.QEventLoop.ExcludeUserInputEvents
            _loop(worker, lambda: None, PATIENCE_S - INSTANT_S, waiting)
        if worker.is_alive():
            _wait_behind_dialog(worker, text)
        worker.join()
    finally:
        sys.setswitchinterval(interval)
    if worker.cancelled:
        from ..nmgs.errors import Cancelled  # only here: it imports NumPy and Part

        raise Cancelled(f"{text}: cancelled")
    if worker.error is not None:
        raise worker.error
    return worker.result


def install() -> None:
    """From now on document objects compute behind the dialog."""
    if FreeCAD.GuiUp:
        run.set_runner(run_behind_dialog)
