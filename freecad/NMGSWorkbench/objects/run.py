# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long work is run: at once here; the window puts a runner with a dialog in its place."""

from __future__ import annotations

from typing import Any, Callable, Optional

#: Called with the finished fraction; returns False to stop.
Progress = Optional[Callable[[float], Any]]
Job = Callable[[Progress], Any]
Runner = Callable[[Job, str], Any]


def _at_once(job: Job, text: str) -> Any:
    return job(None)


_runner: Runner = _at_once


def set_runner(runner: Optional[Runner]) -> None:
    """Replaces what `run` does; None puts the plain call back."""
    global _runner
    _runner = runner or _at_once


def run(job: Job, text: str) -> Any:
    """job(progress)'s result. text: what the user reads meanwhile. Raises what the job raises."""
    return _runner(job, text)
