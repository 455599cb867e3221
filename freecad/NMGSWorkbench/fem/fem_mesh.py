# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh as Fem.FemMesh: nodes, cells, boundary faces, groups."""

from __future__ import annotations

from typing import Any, Dict, Tuple

import numpy as np

from ..nmgs import _kernel
from ..nmgs.mesh import CELL_TYPES, Mesh

#: Fem.FemMesh's node order, as indices into VTK's; found by Jacobian signs and by CalculiX.
_HEX = (7, 4, 5, 6, 3, 0, 1, 2, 15, 12, 13, 14, 11, 8, 9, 10, 19, 16, 17, 18)
_TET = (1, 0, 2, 3, 4, 6, 5, 8, 7, 9)
NODE_ORDER: Dict[str, Tuple[int, ...]] = {
    "hexahedron": _HEX[:8],
    "hexahedron20": _HEX,
    "tetra": _TET[:4],
    "tetra10": _TET,
}
#: Cells that Fem.FemMesh takes from here, lowest dimension last: volumes get the first numbers.
_SUPPORTED = (
    "hexahedron20",
    "hexahedron",
    "tetra10",
    "tetra",
    "quad8",
    "quad",
    "triangle6",
    "triangle",
    "line3",
    "line",
)
_GROUP_KINDS = {1: "Edge", 2: "Face", 3: "Volume"}


def fem_mesh(mesh: Mesh) -> Any:
    """A Fem.FemMesh with the mesh's nodes, cells and groups; numbers are ours plus one.

    A volume mesh gets all faces of its boundary, since FEM constraints look for them and come out
    empty where some are missing. Raises ValueError for cells that Fem.FemMesh cannot take.
    """
    import Fem

    unknown = set(mesh.cells) - set(_SUPPORTED)
    if unknown:
        raise ValueError(f"mesh: {', '.join(sorted(unknown))} cells cannot go to FEM yet")
    mesh = _with_boundary(mesh)
    result = Fem.FemMesh()
    add_node = result.addNode
    for number, (x, y, z) in enumerate(mesh.points.tolist(), 1):
        add_node(x, y, z, number)
    adders = {1: result.addEdge, 2: result.addFace, 3: result.addVolume}
    first: Dict[str, int] = {}
    number = 1
    for name in _SUPPORTED:
        if name not in mesh.cells:
            continue
        nodes = mesh.cells[name] + 1
        if name in NODE_ORDER:
            nodes = nodes[:, NODE_ORDER[name]]
        first[name] = number
        add = adders[CELL_TYPES[name][1]]
        for cell in nodes.tolist():
            add(cell, number)
            number += 1
    for name, (kind, indices) in mesh.groups.items():
        typename = "Node" if kind == "node" else _GROUP_KINDS[CELL_TYPES[kind][1]]
        group = result.addGroup(name, typename)
        offset = 1 if kind == "node" else first[kind]
        result.addGroupElements(group, (indices + offset).tolist())
    return result


def _with_boundary(mesh: Mesh) -> Mesh:
    """The mesh with every outer face of its volumes among its cells, those that exist first."""
    volumes = {name: nodes for name, nodes in mesh.cells.items() if CELL_TYPES[name][1] == 3}
    if not volumes:
        return mesh
    cells = dict(mesh.cells)
    for name, (faces, _, _) in _kernel.core().boundary(len(mesh.points), volumes).items():
        present = cells.get(name, faces[:0])
        cells[name] = np.concatenate([present, faces[~_among(faces, present)]])
    return Mesh(mesh.points, cells, mesh.groups, model=mesh.model)


def _among(rows: np.ndarray, others: np.ndarray) -> np.ndarray:
    """bool (len(rows),): whether a row's nodes, in any order, are those of one of the others."""
    whole = np.sort(np.concatenate([rows, others]), axis=1)
    _, number = np.unique(whole, axis=0, return_inverse=True)
    number = number.reshape(-1)
    return np.isin(number[: len(rows)], number[len(rows) :])
