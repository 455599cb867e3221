# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fem.FemMesh -> nmgs.Mesh, the way back from fem_mesh."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from .. import nmgs
from .fem_mesh import NODE_ORDER
from ..nmgs.mesh import CELL_TYPES

_DIMENSIONS = {"Edge": 1, "Face": 2, "Volume": 3}


def mesh_of(fem_mesh: Any) -> nmgs.Mesh:
    """The mesh with its cells and groups, nodes in ascending order of their numbers.

    Faces of a volume mesh that no group names are left out: they are its boundary, which fem_mesh
    adds. Raises ValueError for elements that have no name here.
    """
    numbers = np.array(sorted(fem_mesh.Nodes), dtype=np.int64)
    places = fem_mesh.Nodes
    points = np.array([tuple(places[n]) for n in numbers.tolist()]).reshape(-1, 3)
    groups = [
        (fem_mesh.getGroupName(g), fem_mesh.getGroupElementType(g), fem_mesh.getGroupElements(g))
        for g in fem_mesh.Groups
    ]
    cells: Dict[str, np.ndarray] = {}
    at: Dict[int, Tuple[str, int]] = {}
    for dimension, elements in ((3, fem_mesh.Volumes), (2, fem_mesh.Faces), (1, fem_mesh.Edges)):
        if dimension < 3 and fem_mesh.Volumes:
            elements = sorted(
                {
                    n
                    for _, kind, members in groups
                    if _DIMENSIONS.get(kind) == dimension
                    for n in members
                }
            )
        for name, rows in _by_type(fem_mesh, elements, dimension).items():
            for row, element in enumerate(rows[0]):
                at[element] = (name, row)
            order = NODE_ORDER.get(name, tuple(range(CELL_TYPES[name][0])))
            found = np.empty((len(rows[1]), len(order)), dtype=np.int64)
            found[:, order] = np.array(rows[1], dtype=np.int64)
            cells[name] = np.searchsorted(numbers, found)
    return nmgs.Mesh(points, cells, _groups(groups, at, numbers))


def _by_type(
    fem_mesh: Any, elements: Any, dimension: int
) -> Dict[str, Tuple[List[int], List[Tuple[int, ...]]]]:
    names = {nodes: name for name, (nodes, d) in CELL_TYPES.items() if d == dimension}
    result: Dict[str, Tuple[List[int], List[Tuple[int, ...]]]] = {}
    for element in elements:
        nodes = fem_mesh.getElementNodes(element)
        if len(nodes) not in names:
            raise ValueError(
                f"element {element} has {len(nodes)} nodes, which no cell type here has"
            )
        numbers, rows = result.setdefault(names[len(nodes)], ([], []))
        numbers.append(element)
        rows.append(nodes)
    return result


def _groups(
    groups: Any, at: Dict[int, Tuple[str, int]], numbers: np.ndarray
) -> Dict[str, Tuple[str, np.ndarray]]:
    result = {}
    for name, kind, members in groups:
        if kind == "Node":
            result[name] = ("node", np.searchsorted(numbers, sorted(members)))
        elif kind in _DIMENSIONS:
            found = sorted(at[n] for n in members)
            types = {cell for cell, _ in found}
            # A group of ours is of one cell type; one made elsewhere becomes one a type.
            for cell in sorted(types):
                title = name if len(types) == 1 else f"{name}_{cell}"
                result[title] = (cell, np.array([row for c, row in found if c == cell]))
    return result
