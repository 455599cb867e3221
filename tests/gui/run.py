# SPDX-License-Identifier: LGPL-2.1-or-later
"""Started by FreeCAD's window itself: runs pytest in it and ends FreeCAD with pytest's code."""

import os
import sys

from PySide import QtCore


def _run() -> None:
    import pytest

    code = 3
    try:
        code = int(pytest.main(os.environ["NMGS_PYTEST_ARGS"].splitlines()))
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        # FreeCAD has no way to hand a code to its own exit.
        os._exit(code)


# Once the window is up and its event loop runs.
QtCore.QTimer.singleShot(1500, _run)
