# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of nmgs_bench, of Gmsh and of memory, with the ratios that matter. See scripts/bench."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

#: The cube as a transfinite volume: Gmsh's counterpart of a block.
TRANSFINITE_GEO = """SetFactory("Built-in");
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Point(5) = {0, 0, 1}; Point(6) = {1, 0, 1}; Point(7) = {1, 1, 1}; Point(8) = {0, 1, 1};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Line(9) = {1, 5}; Line(10) = {2, 6}; Line(11) = {3, 7}; Line(12) = {4, 8};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(2) = {2};
Curve Loop(3) = {1, 10, -5, -9}; Plane Surface(3) = {3};
Curve Loop(4) = {2, 11, -6, -10}; Plane Surface(4) = {4};
Curve Loop(5) = {3, 12, -7, -11}; Plane Surface(5) = {5};
Curve Loop(6) = {4, 9, -8, -12}; Plane Surface(6) = {6};
Surface Loop(1) = {1, 2, 3, 4, 5, 6}; Volume(1) = {1};
Transfinite Curve {1:12} = 101; Transfinite Surface {1:6}; Recombine Surface {1:6};
Transfinite Volume {1};
"""

MEMORY_RUN = """
import resource, sys, time
from freecad.NMGSWorkbench import nmgs
import numpy as np
n = [int(a) for a in sys.argv[1:4]]
nmgs.shapes.cube(divisions=2).generate()
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
start = time.perf_counter()
from nmgs_kernel import core
model = nmgs.shapes.box(*(float(a) for a in n), divisions=n)
raw = core.generate(model.nodes, model.divisions)
seconds = time.perf_counter() - start
after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
nodes, cells = len(raw["points"]), len(raw["cells"]["hexahedron"])
corner = raw["points"][raw["cells"]["hexahedron"][-1, 6]]
assert (corner == n).all(), corner
print(nodes, cells, seconds, (after - before) * 1024)
"""


def line(what, figure, wanted=""):
    print(f"{what:<66} {figure:>16}  {wanted}", flush=True)


def benchmarks(path):
    with open(path, encoding="utf-8") as file:
        entries = json.load(file)["benchmarks"]
    result = {}
    for entry in entries:
        name = re.sub(r"/(real_time|min_time:.*)$", "", entry["name"].split("/real_time")[0])
        name = name.split("/min_time")[0]
        result[name] = entry
    return result


def gmsh_seconds():
    """Wall seconds of Gmsh's "Done meshing 3D", the best of three; None without Gmsh."""
    program = shutil.which("gmsh")
    if program is None:
        return None
    best = None
    with tempfile.TemporaryDirectory() as folder:
        geo = os.path.join(folder, "cube.geo")
        with open(geo, "w", encoding="ascii") as file:
            file.write(TRANSFINITE_GEO)
        for _ in range(3):
            run = subprocess.run(
                [program, "-3", geo, "-o", os.path.join(folder, "cube.msh"), "-v", "5"],
                capture_output=True,
                text=True,
                timeout=600,
                check=False,
            )
            done = re.search(r"Done meshing 3D \(Wall ([\d.]+)s", run.stdout + run.stderr)
            count = re.search(r"(\d+) nodes \d+ elements", run.stdout + run.stderr)
            if done is None or count is None or int(count.group(1)) != 101**3:
                raise SystemExit(f"error: gmsh did not mesh the cube:\n{run.stdout[-2000:]}")
            seconds = float(done.group(1))
            best = seconds if best is None else min(best, seconds)
    return best


def memory(counts):
    run = subprocess.run(
        [sys.executable, "-c", MEMORY_RUN, *map(str, counts)],
        capture_output=True,
        text=True,
        timeout=900,
        check=False,
    )
    if run.returncode:
        raise SystemExit("error: " + run.stderr[-2000:])
    nodes, cells, seconds, bytes_used = run.stdout.split()
    return int(nodes), int(cells), float(seconds), int(bytes_used)


def free_bytes():
    with open("/proc/meminfo", encoding="ascii") as file:
        return next(int(row.split()[1]) * 1024 for row in file if row.startswith("MemAvailable"))


def main():
    times = benchmarks(sys.argv[1])

    def ms(name):
        return times[name]["real_time"]

    def rate(name):
        return times[name]["bytes_per_second"] / 1e6

    line("figure", "", "wanted")
    million, memset = ms("generate_million"), ms("memset_million")
    line("1 M hexahedra of one block, into touched memory", f"{million:.2f} ms")
    line("  against memset of the same bytes", f"{million / memset:.2f} x", "<= 2 x")
    gmsh = gmsh_seconds()
    if gmsh is None:
        line("  Gmsh", "not installed")
    else:
        line("  Gmsh transfinite volume, its own wall time", f"{gmsh * 1000:.0f} ms")
        line("  Gmsh against this", f"{gmsh * 1000 / million:.0f} x", ">= 50 x")
    one = ms("generate_ten_million/one_block")
    hundred = ms("generate_ten_million/hundred_blocks")
    line("10 M hexahedra of one block, all of generate()", f"{one:.0f} ms")
    line("  of 100 blocks with common nodes, against that", f"{hundred / one:.2f} x", "<= 1.5 x")
    for name in ("cube", "bent"):
        tets = times[f"split_million/{name}"]["tets/s"] / 1e6
        line(f"tetrahedra of a {name}'s hexahedra, one thread", f"{tets:.0f} M/s", ">= 100 M/s")
    split, related = ms("split_million/bent"), ms("related_nodes_of_tetrahedra")
    line("  their related nodes, against the split", f"{related / split:.2f} x", "<= 5 x")
    for divisions in (250, 50, 10):
        seconds = ms(f"generate_on_spline/{divisions}") / 1000
        what = f"1 M nodes on a B-spline face, patches of {divisions} x {divisions}"
        line(what, f"{seconds:.2f} s", "<= 3 s")
    line("skin of a solid with 50 faces laid out", f"{ms('lay_out_skin') / 1000:.2f} s", "<= 2 s")
    for ours, peer, verb in (
        ("write_n3r", "printf_peer", "written"),
        ("read_n3r", "scanf_peer", "read"),
    ):
        line(f"N3R {verb}, one thread", f"{rate(ours):.0f} MB/s", ">= 200 MB/s")
        line("  printf, scanf: the same numbers", f"{rate(peer):.0f} MB/s")
        line("  against that", f"{rate(ours) / rate(peer):.1f} x")
    for counts in ((250, 250, 160), (464, 464, 465)):
        cells = counts[0] * counts[1] * counts[2]
        name = f"{cells / 1e6:.1f} M hexahedra in Python"
        if free_bytes() < 80 * cells:
            line(name, "left out", f"{80 * cells / 1e9:.0f} GB of free memory are needed")
            continue
        nodes, cells, seconds, used = memory(counts)
        own = 24 * nodes + 32 * cells
        line(name, f"{seconds:.2f} s")
        line("  peak memory against 24 bytes a node, 32 a hexahedron", f"{used / own:.3f} x",
             "<= 1.3 x")  # fmt: skip


if __name__ == "__main__":
    main()
