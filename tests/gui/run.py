# SPDX-License-Identifier: LGPL-2.1-or-later
"""Started by FreeCAD's window itself: runs pytest in it and ends FreeCAD with pytest's code."""

import os
import sys

from PySide import QtCore


def _run() -> None:
    import pytest

    code = 3
    # FreeCAD's own streams end in its report view, and since 1.0 not always here.
    sys.stdout = open(1, "w", buffering=1, closefd=False)
    sys.stderr = open(2, "w", buffering=1, closefd=False)
    try:
        code = int(pytest.main(os.environ["NMGS_PYTEST_ARGS"].splitlines()))
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        # FreeCAD has no way to hand a code to its own exit.
        os._exit(code)


# Once the window is up and its event loop runs. A timer of its own: QTimer.singleShot's would be
# deleted while it runs _run, in whose event loops PySide6 would then crash.
_start = QtCore.QTimer()
_start.setSingleShot(True)
_start.timeout.connect(_run)
_start.start(1500)
