# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the worker once: a request in, an answer out, with progress, cancel, time-out, memory limit.

The calling thread never blocks on a pipe: three threads move the data, and the caller waits for
them and calls progress between. However run() is left, the worker is gone.
"""

from __future__ import annotations

import io
import subprocess
import threading
import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional

import numpy as np

from .. import _kernel
from ..errors import Cancelled
from . import protocol
from .phases import Phases

#: Seconds between two looks at the worker, and between two calls of progress.
INTERVAL = 0.04
#: Seconds that a worker gets to end by itself after its pipe has closed.
PATIENCE = 5.0


class Outcome(NamedTuple):
    """What came of one run."""

    arrays: Dict[str, np.ndarray]  # protocol.ANSWER's names
    whole: bool  # the answer is complete
    code: int  # of TetGen's or the worker's error; 0 for none
    text: str  # the worker's own words to the code
    status: int  # exit status; -n for signal n
    timed_out: bool
    log: str  # TetGen's words
    version: str  # of the linked TetGen


class _Conversation:
    """The pipes of one worker, and what came through them so far."""

    def __init__(self, process: "subprocess.Popen[bytes]", hear: Callable[[str], None]):
        self._process = process
        self._hear = hear
        self.arrays: Dict[str, np.ndarray] = {}
        self.whole = False
        self.code = 0
        self.text = ""
        self.version = ""
        self.lines: List[str] = []
        self._told = 0
        self.out_of_memory = False
        self.finished = threading.Event()

    def send(self, arrays: Dict[str, np.ndarray], memory_limit: int) -> None:
        """The request. The pipe stays open after it: it is the worker's life line."""
        try:
            for buffer in protocol.encode(arrays, memory_limit):
                view = memoryview(buffer)
                while view:
                    view = view[self._process.stdin.write(view) :]
        except OSError:
            pass  # the worker is gone; what it said, and its exit status, tell why

    def receive(self) -> None:
        """The answer, up to its end or the worker's."""
        try:
            while not (self.whole or self.code):
                self._take(protocol.read_frame(self._process.stdout))
        except (protocol.BrokenAnswer, OSError):
            pass  # as above
        except MemoryError:
            self.out_of_memory = True
        finally:
            self.finished.set()

    def _take(self, frame: protocol.Frame) -> None:
        if frame.kind == protocol.HELLO:
            self.version = frame.array.tobytes().decode()
        elif frame.kind == protocol.ERROR:
            self.text = frame.array.tobytes().decode(errors="replace")
            self.code = frame.code
        elif frame.kind == protocol.DONE:
            self.whole = True
        else:
            self.arrays[protocol.ANSWER[frame.kind]] = frame.array

    def listen(self) -> None:
        """TetGen's lines."""
        with io.BufferedReader(self._process.stderr) as stream:
            for line in stream:
                text = line.decode(errors="replace").rstrip("\n")
                self.lines.append(text)
                self._hear(text)

    def tell(self, log: Optional[Callable[[str], Any]]) -> None:
        """The lines that the caller has not heard yet."""
        while log is not None and self._told < len(self.lines):
            self._told += 1
            log(self.lines[self._told - 1])


def _watch(
    talk: _Conversation,
    phases: Phases,
    timeout: Optional[float],
    progress: Optional[Callable[[float], Any]],
    log: Optional[Callable[[str], Any]],
) -> bool:
    """Waits for the answer; True when the time ran out. Raises Cancelled."""
    end = None if timeout is None else time.monotonic() + timeout
    while True:
        over = talk.finished.wait(INTERVAL)
        talk.tell(log)
        if progress is not None and progress(phases.fraction) is False:
            raise Cancelled("cancelled")
        if over:
            return False
        if end is not None and time.monotonic() > end:
            return True


def run(
    arrays: Dict[str, np.ndarray],
    timeout: Optional[float] = None,
    progress: Optional[Callable[[float], Any]] = None,
    log: Optional[Callable[[str], Any]] = None,
    memory_limit: int = 0,
) -> Outcome:
    """Sends the arrays (names of protocol.REQUEST) to a new worker and returns what came back.

    timeout: seconds. progress(fraction) and log(line) are called from the calling thread, progress
    at least every 50 ms; False from progress ends the worker. memory_limit: bytes, 0 for none.
    Raises Cancelled, KernelMissing, MemoryError.
    """
    phases = Phases()
    process = subprocess.Popen(
        [str(_kernel.worker())],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        bufsize=0,
    )
    talk = _Conversation(process, phases.hear)
    threads = [
        threading.Thread(target=talk.send, args=(arrays, memory_limit), daemon=True),
        threading.Thread(target=talk.receive, daemon=True),
        threading.Thread(target=talk.listen, daemon=True),
    ]
    for thread in threads:
        thread.start()
    timed_out = True
    try:
        timed_out = _watch(talk, phases, timeout, progress, log)
    finally:
        if timed_out or talk.whole or talk.code:
            process.kill()
        try:
            # A worker that crashed is already dying, and its own status shall be seen.
            status = process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            status = process.wait()
        for thread in threads:
            thread.join()
        process.stdin.close()
        process.stdout.close()
    talk.tell(log)
    if talk.out_of_memory:
        raise MemoryError("not enough memory for TetGen's mesh")
    return Outcome(
        arrays=talk.arrays,
        whole=talk.whole,
        code=talk.code,
        text=talk.text,
        status=status,
        timed_out=timed_out,
        log="\n".join(talk.lines),
        version=talk.version,
    )
