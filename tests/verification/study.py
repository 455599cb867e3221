# SPDX-License-Identifier: LGPL-2.1-or-later
"""One problem solved on one mesh, and what a series of meshes tells."""

import dataclasses

import calculix
import meshes

#: How a mesh is made and its elements integrated: name -> (mesher, reduced, what it is).
METHODS = {
    "hex20": (meshes.hexahedra, True, "fitted blocks, C3D20R"),
    "hex20 full": (meshes.hexahedra, False, "the same meshes, C3D20"),
    "TetGen tet10": (meshes.tetgen, False, "nmgs.tetrahedralize, C3D10"),
    "Gmsh tet10": (meshes.gmsh, False, "FreeCAD's FEM mesh by Gmsh, C3D10"),
}
#: The suite's bar.
WANTED = 0.02


@dataclasses.dataclass
class Run:
    size: float
    elements: int
    freedoms: int
    value: float
    error: float


def run(problem, size, method="hex20"):
    """The problem on a mesh of the size."""
    mesher, reduced, _ = METHODS[method]
    mesh = mesher(problem.shape(), size)
    held, forces = problem.conditions(mesh)
    result = calculix.solve(
        mesh,
        problem.young,
        problem.poisson,
        held,
        forces,
        problem.density,
        problem.modes,
        reduced=reduced,
    )
    value = problem.measure(mesh, result)
    elements = sum(len(nodes) for nodes in mesh.cells.values())
    return Run(size, elements, 3 * len(mesh.points), value, value / problem.reference - 1)


def needed(runs):
    """The fewest degrees of freedom of a series that are within the bar, as are all finer meshes;
    None where there are none."""
    best = None
    for entry in sorted(runs, key=lambda entry: -entry.freedoms):
        if abs(entry.error) > WANTED:
            break
        best = entry.freedoms
    return best


def converges(runs):
    """Whether changes get smaller from mesh to mesh: the last is less than half the largest, or a
    two hundredth of the value; and the last error is not above the first."""
    values = [entry.value for entry in runs]
    steps = [abs(b - a) for a, b in zip(values, values[1:])]
    settled = steps[-1] <= 0.5 * max(steps) or steps[-1] <= 0.005 * abs(values[-1])
    first, last = abs(runs[0].error), abs(runs[-1].error)
    return settled and (last <= first or last <= WANTED)
