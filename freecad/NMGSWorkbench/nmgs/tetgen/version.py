# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which TetGen the worker is linked to."""

from __future__ import annotations

import functools
import subprocess

from .. import _kernel


@functools.lru_cache(maxsize=None)
def tetgen_version() -> str:
    """ "1.5" or "1.6". Raises KernelMissing when the worker is not installed."""
    worker = str(_kernel.worker())
    done = subprocess.run([worker, "--version"], capture_output=True, text=True, timeout=30)
    return done.stdout.strip()
