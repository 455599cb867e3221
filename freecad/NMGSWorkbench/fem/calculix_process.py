# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX as a process that can be stopped."""

from __future__ import annotations

import os
import subprocess
import tempfile
from typing import Any, Callable, Optional, Tuple

from ..nmgs.errors import Cancelled

_POLL_S = 0.05


def run_calculix(
    binary: str, path: str, progress: Optional[Callable[[float], Any]] = None
) -> Tuple[int, str]:
    """Solves an input file beside which CalculiX writes its results: its exit code and output.

    binary: the program ccx. progress: called with -1, as nobody knows how long it takes; returns
    False to stop. Raises Cancelled, OSError.
    """
    folder, name = os.path.split(os.path.abspath(path))
    # OMP_NUM_THREADS that the user set is kept.
    threads = os.environ.get("OMP_NUM_THREADS") or str(os.cpu_count() or 1)
    with tempfile.TemporaryFile() as output:  # a pipe that nobody reads would stop CalculiX
        with subprocess.Popen(
            [binary, "-i", os.path.splitext(name)[0]],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            env={**os.environ, "OMP_NUM_THREADS": threads},
        ) as process:
            while True:
                try:
                    code = process.wait(_POLL_S)
                    break
                except subprocess.TimeoutExpired:
                    if progress is not None and progress(-1.0) is False:
                        process.kill()
                        raise Cancelled("CalculiX was stopped") from None
        output.seek(0)
        return code, output.read().decode("utf-8", "replace")
