# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work off the main thread, behind a progress dialog with Cancel."""

from __future__ import annotations

import threading
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..nmgs.errors import Cancelled
from ..objects import run

#: Work shorter than this shows no dialog and handles no events.
PATIENCE_S = 0.4
_POLL_MS = 40


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


def _wait_behind_dialog(worker: _Worker, text: str) -> None:
    # The dialog is modal for the whole application: nobody changes the document meanwhile.
    dialog = QtGui.QProgressDialog(text, "Cancel", 0, 0, FreeCADGui.getMainWindow())
    dialog.setObjectName("NMGS_Progress")
    dialog.setWindowTitle("NMGS")
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(0)
    dialog.setAutoClose(False)
    dialog.setAutoReset(False)
    loop = QtCore.QEventLoop()
    timer = QtCore.QTimer()

    def poll() -> None:
        if not worker.is_alive():
            loop.quit()
        elif worker.cancelled:
            dialog.setLabelText("Stopping")
        elif worker.fraction >= 0.0:
            dialog.setMaximum(1000)
            dialog.setValue(int(1000 * min(worker.fraction, 1.0)))

    def cancel() -> None:
        worker.cancelled = True
        # Qt hides a cancelled dialog; it stays until the work has stopped.
        dialog.show()

    dialog.canceled.connect(cancel)
    timer.timeout.connect(poll)
    timer.start(_POLL_MS)
    dialog.show()
    getattr(loop, "exec", None)() if hasattr(loop, "exec") else loop.exec_()
    timer.stop()
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
    worker.join(PATIENCE_S)
    if worker.is_alive():
        _wait_behind_dialog(worker, text)
    worker.join()
    if worker.cancelled:
        raise Cancelled(f"{text}: cancelled")
    if worker.error is not None:
        raise worker.error
    return worker.result


def install() -> None:
    """From now on document objects compute behind the dialog."""
    if FreeCAD.GuiUp:
        run.set_runner(run_behind_dialog)
