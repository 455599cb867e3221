# SPDX-License-Identifier: LGPL-2.1-or-later
"""nmgs.to_fem beside the bare calls of FemMesh for the same arrays. See scripts/bench-fem.

Processor time, the smallest of some runs each, in turns: other work on the machine disturbs little.
"""

import sys
import time

import FreeCAD
import Fem

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem.fem_mesh import NODE_ORDER, with_boundary
from freecad.NMGSWorkbench.nmgs.mesh import CELL_TYPES

RUNS = 5


def bare(points, cells, groups):
    """What anybody would write, given arrays in FemMesh's own order and numbers."""
    document = FreeCAD.newDocument("Bare")
    result = Fem.FemMesh()
    for number, (x, y, z) in enumerate(points.tolist(), 1):
        result.addNode(x, y, z, number)
    number = 1
    for name, nodes in cells:
        add = {2: result.addFace, 3: result.addVolume}[CELL_TYPES[name][1]]
        for cell in nodes.tolist():
            add(cell, number)
            number += 1
    for name, kind, members in groups:
        result.addGroupElements(result.addGroup(name, kind), members.tolist())
    document.addObject("Fem::FemMeshObject", "Mesh").FemMesh = result
    return document


def ours(mesh):
    document = FreeCAD.newDocument("Ours")
    nmgs.to_fem(mesh, document)
    return document


def arrays_for_bare(mesh):
    whole = with_boundary(mesh)
    cells, first, number = [], {}, 1
    for name in sorted(whole.cells, key=lambda n: (-CELL_TYPES[n][1], -CELL_TYPES[n][0])):
        if CELL_TYPES[name][1] > 1:
            nodes = whole.cells[name] + 1
            cells.append((name, nodes[:, list(NODE_ORDER.get(name, range(nodes.shape[1])))]))
            first[name] = number
            number += len(nodes)
    kinds = {2: "Face", 3: "Volume"}
    groups = [
        (name, kinds[CELL_TYPES[kind][1]], indices + first[kind])
        for name, (kind, indices) in mesh.groups.items()
        if kind in first
    ]
    groups += [(n, "Node", i + 1) for n, (kind, i) in mesh.groups.items() if kind == "node"]
    return whole.points, cells, groups


def seconds(job, *arguments):
    start = time.process_time()
    document = job(*arguments)
    taken = time.process_time() - start
    FreeCAD.closeDocument(document.Name)
    return taken


def main():
    import Part

    print(f"{'to_fem against the bare calls':<34}{'cells':>9}{'to_fem':>9}{'bare':>9}{'ratio':>8}")
    worst = 0.0
    for title, size, change in (
        ("8-node hexahedra", 1 / 40, lambda model: model.generate()),
        ("20-node hexahedra", 1 / 22, lambda model: model.generate(order=2)),
        ("4-node tetrahedra", 1 / 18, lambda model: model.generate().split()),
        ("10-node tetrahedra", 1 / 12, lambda model: model.generate().split().to_order(2)),
    ):
        mesh = change(nmgs.fit(Part.makeBox(1, 1, 1), size=size))
        arrays = arrays_for_bare(mesh)
        times = [(seconds(ours, mesh), seconds(bare, *arrays)) for _ in range(RUNS)]
        mine, theirs = (min(column) for column in zip(*times))
        count = sum(len(n) for k, n in mesh.cells.items() if CELL_TYPES[k][1] == 3)
        worst = max(worst, mine / theirs)
        print(f"{title:<34}{count:>9}{mine:>9.3f}{theirs:>9.3f}{mine / theirs:>8.2f}", flush=True)
    print(f"largest ratio {worst:.2f}; wanted: at most 1.1")
    return 0 if worst <= 1.1 else 1


if __name__ == "__main__":
    sys.exit(main())
