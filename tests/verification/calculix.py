# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX on a mesh that nmgs.write wrote: a linear static step, or natural frequencies."""

import os
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.mesh import CELL_TYPES

MISSING = "CalculiX is not installed" if shutil.which("ccx") is None else ""


class Results:
    """displacement: (N, 3). stress: (N, 6), xx yy zz xy yz zx, the mean over the elements at a
    node. frequencies: cycles per unit of time, ascending."""

    displacement = stress = frequencies = None


def solve(
    mesh, young, poisson, held, forces=None, density=None, modes=0, plane=None, reduced=False
):
    """mesh: cells of the highest dimension are solved.

    held: (node, degree of freedom 0 to 2, value) rows. forces: (N, 3). modes: how many natural
    frequencies to find instead of a static solution. plane: "stress" or "strain" for surfaces.
    reduced: elements of reduced integration where there are some.
    """
    folder = pathlib.Path(tempfile.mkdtemp(prefix="nmgs-verify-"))
    try:
        nmgs.write(folder / "mesh.inp", mesh, plane=plane, reduced=reduced)
        deck = _deck(mesh, young, poisson, held, forces, density, modes, plane)
        (folder / "run.inp").write_text(deck)
        done = subprocess.run(
            ["ccx", "run"],
            cwd=folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
        )
        if done.returncode or "*ERROR" in done.stdout:
            raise RuntimeError(f"CalculiX: {done.stdout[-1500:]}")
        result = Results()
        if modes:
            result.frequencies = _frequencies(folder / "run.dat", modes)
        else:
            result.displacement = _displacements(folder / "run.dat", len(mesh.points))
            result.stress = _stresses(folder / "run.frd", len(mesh.points))
        return result
    finally:
        shutil.rmtree(folder)


def _deck(mesh, young, poisson, held, forces, density, modes, plane):
    top = max(CELL_TYPES[name][1] for name in mesh.cells)
    kinds = [name for name in mesh.cells if CELL_TYPES[name][1] == top]
    lines = [
        "*INCLUDE, INPUT=mesh.inp",
        "*NSET, NSET=Nall, GENERATE",
        f"1, {len(mesh.points)}",
        "*MATERIAL, NAME=M",
        "*ELASTIC",
        f"{young}, {poisson}",
    ]
    if density is not None:
        lines += ["*DENSITY", f"{density}"]
    for kind in kinds:
        lines += [f"*SOLID SECTION, ELSET={kind}, MATERIAL=M"] + (["1."] if plane else [])
    if len(held):
        lines += ["*BOUNDARY"]
        lines += [f"{int(n) + 1}, {int(d) + 1}, {int(d) + 1}" for n, d, _ in held]
    lines += ["*STEP"]
    if modes:
        lines += ["*FREQUENCY", f"{modes}", "*END STEP"]
        return "\n".join(lines) + "\n"
    lines += ["*STATIC"]
    moved = [f"{int(n) + 1}, {int(d) + 1}, {int(d) + 1}, {v:.13e}" for n, d, v in held if v]
    lines += (["*BOUNDARY"] + moved) if moved else []
    if forces is not None:
        rows = [
            f"{n + 1}, {d + 1}, {forces[n, d]:.13e}" for n, d in np.argwhere(forces != 0).tolist()
        ]
        lines += ["*CLOAD"] + rows
    lines += ["*NODE PRINT, NSET=Nall", "U", "*EL FILE", "S", "*END STEP"]
    return "\n".join(lines) + "\n"


def _displacements(path, count):
    values = np.full((count, 3), np.nan)
    for line in path.read_text().splitlines():
        row = line.split()
        if len(row) == 4 and row[0].isdigit():
            if int(row[0]) <= count:
                values[int(row[0]) - 1] = [float(v) for v in row[1:]]
    return values


def _frequencies(path, count):
    """Rows of five of the first table: number, eigenvalue, radians, cycles, imaginary part."""
    found = []
    for line in path.read_text().splitlines():
        row = line.split()
        if len(row) == 5 and row[0].isdigit() and int(row[0]) == len(found) + 1:
            found.append(float(row[3]))
        if len(found) == count:
            break
    return np.array(found)


def _stresses(path, count):
    """The block of stresses of an .frd file: numbers stand in columns of fixed width."""
    values = np.full((count, 6), np.nan)
    reading = False
    for line in path.read_text().splitlines():
        if line.startswith(" -4"):
            reading = line.split()[1] == "STRESS"
        elif reading and line.startswith(" -1"):
            node = int(line[3:13])
            if node <= count:
                values[node - 1] = [float(line[13 + 12 * k : 25 + 12 * k]) for k in range(6)]
    return values
