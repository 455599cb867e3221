# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worker: cancel, time-out, memory, crash, kill, orphans, several at once, nonsense."""

import os
import signal
import struct
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from tetgen_cases import check_mesh, crossing_plc, cube

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs import _kernel
from freecad.NMGSWorkbench.nmgs.tetgen import protocol, worker

#: Enough work for minutes, on any machine.
ENDLESS = "pqa0.00000001"
SWEEP = os.environ.get("NMGS_SWEEP")


class Spy:
    """Remembers the processes that the worker's module starts."""

    def __init__(self, monkeypatch):
        nmgs.TetOptions()  # asks for the version once, in a process of its own
        self.born = []
        original = subprocess.Popen

        def popen(*args, **kwargs):
            self.born.append(original(*args, **kwargs))
            return self.born[-1]

        monkeypatch.setattr(worker.subprocess, "Popen", popen)


def test_progress_rises_and_comes_often():
    calls = []
    mesh = nmgs.tetrahedralize(
        np.random.default_rng(0).random((60000, 3)),
        "",
        progress=lambda f: calls.append((time.monotonic(), f)),
    )
    check_mesh(mesh)
    fractions = [f for _, f in calls]
    assert fractions == sorted(fractions)
    assert 0 <= fractions[0] and fractions[-1] < 1
    assert len(calls) >= 3


def test_log_is_tetgens_own():
    lines = []
    mesh = nmgs.tetrahedralize(cube(), "pq", log=lines.append)
    assert any(line.startswith("Delaunizing vertices") for line in lines)
    assert mesh.tetgen.log.split("\n") == lines


def test_cancel_ends_the_worker(monkeypatch):
    spy = Spy(monkeypatch)
    asked = []

    def progress(_):
        if len(spy.born) == 1 and len(asked) < 5:
            asked.append(None)
        return len(asked) < 5

    with pytest.raises(nmgs.Cancelled):
        nmgs.tetrahedralize(cube(), ENDLESS, progress=progress)
    assert spy.born[0].returncode == -signal.SIGKILL


def test_an_exception_of_the_callback_ends_the_worker_too(monkeypatch):
    spy = Spy(monkeypatch)

    def progress(_):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        nmgs.tetrahedralize(cube(), ENDLESS, progress=progress)
    assert spy.born[0].returncode is not None


def test_time_out(monkeypatch):
    spy = Spy(monkeypatch)
    with pytest.raises(nmgs.TetGenError, match="0.3 s"):
        nmgs.tetrahedralize(cube(), ENDLESS, timeout=0.3)
    assert spy.born[0].returncode == -signal.SIGKILL


def test_memory_limit():
    with pytest.raises(nmgs.TetGenError, match="memory") as caught:
        nmgs.tetrahedralize(cube(), ENDLESS, memory_limit=50_000_000)
    assert caught.value.code == 1
    check_mesh(nmgs.tetrahedralize(cube(), "pq", memory_limit=50_000_000), volume=1.0)


@pytest.mark.parametrize("seed", range(500 if SWEEP else 40))
def test_crossing_facets_are_named(seed):
    plc = crossing_plc(seed)
    try:
        mesh = nmgs.tetrahedralize(plc, "pq", timeout=60)
    except nmgs.TetGenError as error:
        assert error.facets
        assert all(0 <= f < len(plc) for f in error.facets)
    else:
        check_mesh(mesh)


def test_kills_at_random_moments(monkeypatch):
    spy = Spy(monkeypatch)
    random = np.random.default_rng(3)
    for round in range(50 if SWEEP else 8):
        wait = random.uniform(0, 0.3)

        def kill(round=round, wait=wait):
            while len(spy.born) <= 2 * round:
                time.sleep(0.001)
            time.sleep(wait)
            os.kill(spy.born[2 * round].pid, signal.SIGKILL)

        thread = threading.Thread(target=kill)
        thread.start()
        with pytest.raises(nmgs.TetGenError, match="SIGKILL") as caught:
            nmgs.tetrahedralize(cube(), ENDLESS)
        thread.join()
        assert caught.value.code == -signal.SIGKILL
        check_mesh(nmgs.tetrahedralize(cube(), "p"), volume=1.0)


def test_several_at_once():
    meshes = {}

    def work(number):
        meshes[number] = nmgs.tetrahedralize(cube(number), "pqa0.5")

    threads = [threading.Thread(target=work, args=(n,)) for n in range(1, 7)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for number in range(1, 7):
        check_mesh(meshes[number], volume=float(number) ** 3)


ORPHAN = """
import os, sys, threading, time
from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.tetgen import worker
original = worker.subprocess.Popen
nmgs.TetOptions()
def popen(*args, **kwargs):
    process = original(*args, **kwargs)
    print(process.pid, flush=True)
    return process
worker.subprocess.Popen = popen
P = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
F = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
nmgs.tetrahedralize(nmgs.PLC(P, F), "pqa0.00000001")
"""


def alive(pid):
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def test_a_killed_parent_leaves_no_orphan():
    parent = subprocess.Popen(
        [sys.executable, "-c", ORPHAN], stdout=subprocess.PIPE, text=True, env=os.environ
    )
    pid = int(parent.stdout.readline())
    assert alive(pid)
    parent.kill()
    parent.wait()
    parent.stdout.close()
    end = time.monotonic() + 10
    while alive(pid) and time.monotonic() < end:
        threading.Event().wait(0.02)
    assert not alive(pid)


def talk(data):
    """Frames and exit status of a worker that is told these bytes."""
    process = subprocess.Popen(
        [str(_kernel.worker())],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    process.stdin.write(data)
    process.stdin.flush()
    if not data or data == CUT_SHORT:
        process.stdin.close()  # else the pipe stays open: it is the worker's life line
    answer = process.stdout.read()
    process.wait(60)
    process.stdout.close()
    frames, place = [], 0
    while place < len(answer):
        _, kind, scalar, code, rows, columns = protocol.HEADER.unpack_from(answer, place)
        place += protocol.HEADER.size
        size = rows * columns * protocol.SCALARS[scalar].itemsize
        frames.append((kind, code, answer[place : place + size]))
        place += size
    return frames, process.returncode


def encoded(**arrays):
    return b"".join(bytes(b) for b in protocol.encode({k: np.array(v) for k, v in arrays.items()}))


CUT_SHORT = encoded(points=[[0.0, 0, 0]])[:-40]


@pytest.mark.parametrize(
    "data",
    [
        b"x" * 100,
        CUT_SHORT,
        struct.pack("=IIIiQQ", protocol.MAGIC, 1, 2, 0, 2, 1) + struct.pack("=qq", 99, 0),
        struct.pack("=IIIiQQ", protocol.MAGIC, 1, 2, 0, 2**62, 2**62),
        encoded()[: 32 + 16] + struct.pack("=IIIiQQ", protocol.MAGIC, 101, 9, 0, 1, 3),
    ],
    ids=["nonsense", "cut short", "version", "too long", "scalar"],
)
def test_the_worker_refuses_nonsense(data):
    frames, status = talk(data)
    assert frames[-1][:2] == (protocol.ERROR, 101)
    assert status == 1


def test_the_worker_ends_when_nobody_asks():
    frames, status = talk(b"")
    assert [kind for kind, _, _ in frames] == [protocol.HELLO]
    assert status == 1


@pytest.mark.parametrize(
    ("arrays", "words"),
    [
        ({"points": [[0.0, 0, 0]] * 4, "tetra": [[0, 1, 2, 4]]}, b"tetra: node 4"),
        ({"points": [[0.0, 0, 0]] * 4, "tetra": [[0, 1, 2]]}, b"4 or 10"),
        ({"points": [[0.0, 0, float("nan")]]}, b"not finite"),
        ({"points": [[0.0, 0]]}, b"3 columns"),
        (
            {
                "points": [[0.0, 0, 0]] * 4,
                "polygon_nodes": [0, 1, 2],
                "polygon_offsets": [0, 9],
                "facet_offsets": [0, 1],
            },
            b"polygon offsets",
        ),
        ({"points": [[0.0, 0, 0]] * 4, "facet_offsets": [0, 1]}, b"polygon offsets"),
        ({"points": [[0.0, 0, 0]] * 4, "point_markers": [1, 2]}, b"point markers"),
    ],
)
def test_the_worker_refuses_what_contradicts_itself(arrays, words):
    frames, _ = talk(encoded(switches=np.frombuffer(b"p", np.uint8), **arrays))
    kind, code, text = frames[-1]
    assert (kind, code) == (protocol.ERROR, 10)
    assert words in text
