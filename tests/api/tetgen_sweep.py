# SPDX-License-Identifier: LGPL-2.1-or-later
"""The long checks of the TetGen worker; scripts/tetgen-sweep runs it."""

import os
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np
import tetgen_cases as cases

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.tetgen import worker

SWITCHES = ("p", "pq", "pY", "pq1.2a0.001", "pqAO2o2")


#: Seconds that the program gets for one file; some volume limits ask for billions of tetrahedra.
SECONDS = 30


def parity(chosen=SWITCHES):
    """Every surface and PLC of the corpus with several switches: the same tetrahedra."""
    files = cases.corpus_files("poly", "smesh", "off", "stl", "ply", "mesh")
    for switches in chosen:
        count = {"same": 0, "different": 0, "both fail": 0, "only here": 0, "only program": 0}
        count["program too slow"] = 0
        unnamed = 0
        for path in files:
            with tempfile.TemporaryDirectory() as folder:
                try:
                    theirs = cases.program(folder, path, switches, timeout=SECONDS)
                except subprocess.TimeoutExpired:
                    count["program too slow"] += 1
                    continue
            try:
                ours = nmgs.tetrahedralize(path, switches, timeout=10 * SECONDS)
            except nmgs.Error as error:
                ours = None
                if isinstance(error, nmgs.TetGenError) and not error.facets:
                    unnamed += 1
                    print(f"   {path.name}: {error}")
            if theirs is None or ours is None:
                row = "both fail" if theirs is ours else "only here" if ours else "only program"
            else:
                row = "same" if cases.same_mesh(ours, theirs) else "different"
            if row in ("different", "only program"):
                print(f"   {path.name}: {row}")
            count[row] += 1
        print(f"parity -{switches}: {count}; errors without facets: {unnamed}", flush=True)


def crossing(count=500):
    """Random PLCs with crossing facets: an error that names facets, or a valid mesh."""
    meshes = named = unnamed = 0
    slowest = 0.0
    for seed in range(count):
        started = time.perf_counter()
        try:
            mesh = nmgs.tetrahedralize(cases.crossing_plc(seed), "pq", timeout=60)
            cases.check_mesh(mesh)
            meshes += 1
        except nmgs.TetGenError as error:
            named += bool(error.facets)
            unnamed += not error.facets
        slowest = max(slowest, time.perf_counter() - started)
    print(
        f"crossing: {count} PLCs, {meshes} valid meshes, {named} errors that name facets, "
        f"{unnamed} that do not; slowest {slowest:.2f} s",
        flush=True,
    )


def kills(count=50):
    """The worker is killed at random moments: an error each time, and the next call works."""
    nmgs.TetOptions()  # asks the worker for its version, once
    random = np.random.default_rng(0)
    original = worker.subprocess.Popen
    errors = after = 0
    for _ in range(count):
        born = []

        def popen(*args, **kwargs):
            born.append(original(*args, **kwargs))
            return born[-1]

        worker.subprocess.Popen = popen
        delay = random.uniform(0, 1.0)

        def kill():
            time.sleep(delay)
            while not born:
                time.sleep(0.001)
            os.kill(born[0].pid, signal.SIGKILL)

        thread = threading.Thread(target=kill)
        thread.start()
        try:
            nmgs.tetrahedralize(cases.cube(), "pqa0.000001")
        except nmgs.TetGenError as error:
            errors += error.code == -signal.SIGKILL
        thread.join()
        worker.subprocess.Popen = original
        after += len(nmgs.tetrahedralize(cases.cube(), "p").cells["tetra"]) > 0
    print(f"kills: {count}, {errors} errors, {after} next calls work", flush=True)


def cpu_seconds():
    """Processor time of this process and of its children that ended."""
    usage = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(u.ru_utime + u.ru_stime for u in usage)


def timed(call):
    """The call's answer, wall seconds, processor seconds."""
    wall, cpu = time.perf_counter(), cpu_seconds()
    answer = call()
    return answer, time.perf_counter() - wall, cpu_seconds() - cpu


def speed():
    """A million tetrahedra: the call against the program's own time, and against its files.

    The program tells its own times in processor seconds; on a machine with other work only
    processor seconds can be compared.
    """
    plc = cases.cube()
    switches = "pqa0.0000018"
    for _ in range(3):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube.poly")
            nmgs.write(path, plc)
            command = ["tetgen", "-" + switches, path]
            done, wall, cpu = timed(
                lambda: subprocess.run(command, capture_output=True, text=True, check=True)
            )
            ele = os.path.join(folder, "cube.1.ele")
            theirs, read_wall, read_cpu = timed(lambda: nmgs.read(ele))
        total = float(done.stdout.split("Total running seconds:")[1].split()[0])
        output = float(done.stdout.split("Output seconds:")[1].split()[0])
        mesh, our_wall, our_cpu = timed(lambda: nmgs.tetrahedralize(plc, switches))
        meshing = total - output
        print(
            f"speed: {len(mesh.cells['tetra'])} tetrahedra, same: {cases.same_mesh(mesh, theirs)}; "
            f"processor seconds: program's meshing {meshing:.2f}, program whole {cpu:.2f}, and its "
            f"files read {cpu + read_cpu:.2f}; call {our_cpu:.2f} ({our_cpu / meshing - 1:+.1%}, "
            f"allowed {1.05 * meshing + 0.1:.2f}); wall: program {wall:.2f}, and its files read "
            f"{wall + read_wall:.2f}, call {our_wall:.2f}",
            flush=True,
        )


if __name__ == "__main__":
    wanted = [arg for arg in sys.argv[1:] if not arg.startswith("-")]
    chosen = [arg[1:] for arg in sys.argv[1:] if arg.startswith("-")] or SWITCHES
    for name in wanted or ("parity", "crossing", "kills", "speed"):
        if name == "parity":
            parity(chosen)
        else:
            {"crossing": crossing, "kills": kills, "speed": speed}[name]()
