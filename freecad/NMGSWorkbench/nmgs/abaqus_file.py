# SPDX-License-Identifier: LGPL-2.1-or-later
"""Abaqus and CalculiX input files (.inp): nodes, elements, sets and surfaces.

Our own writer, since meshio's writes hexahedra as C3D20RH, which CalculiX does not know, and no
surfaces. Reading is meshio's.
"""

from __future__ import annotations

from typing import Dict, Iterator, List, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .mesh import CELL_TYPES, Mesh
from .meshio_files import read_mesh as read_inp

__all__ = ["ELEMENT_TYPES", "read_inp", "write_inp"]

#: Element type of each cell type. Node orders agree with VTK's.
ELEMENT_TYPES: Dict[str, str] = {
    "line": "B31",
    "line3": "B32",
    "triangle": "S3",
    "triangle6": "S6",
    "quad": "S4",
    "quad8": "S8",
    "tetra": "C3D4",
    "tetra10": "C3D10",
    "hexahedron": "C3D8",
    "hexahedron20": "C3D20",
}
#: Corner nodes of the faces S1, S2, ... of an element, 0-based.
_FACES = {
    4: ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)),
    8: ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)),
}


def write_inp(path: str, mesh: Mesh) -> None:
    """The cells of the highest dimension, with their groups as ELSET.

    Groups of nodes are NSET; a group of faces of volume cells is an NSET of its nodes and a SURFACE
    of the same name. The faces are not written as elements: they would be shells.
    Raises ValueError when a cell type has no Abaqus element here.
    """
    top = max((CELL_TYPES[name][1] for name in mesh.cells), default=0)
    blocks = {name: nodes for name, nodes in mesh.cells.items() if CELL_TYPES[name][1] == top}
    unknown = set(blocks) - set(ELEMENT_TYPES)
    if unknown:
        raise ValueError(f"mesh: {', '.join(sorted(unknown))} cells cannot be written as .inp")
    with replaced_file(path) as file:
        file.write("*HEADING\nNMGS Workbench\n*NODE\n")
        rows = mesh.points.tolist()
        file.writelines(
            f"{n}, {_number(x)}, {_number(y)}, {_number(z)}\n"
            for n, (x, y, z) in enumerate(rows, 1)
        )
        first = _write_elements(file, blocks)
        for name, (kind, indices) in mesh.groups.items():
            if kind == "node":
                _write_set(file, f"*NSET, NSET={name}", indices + 1)
            elif kind in blocks:
                _write_set(file, f"*ELSET, ELSET={name}", indices + first[kind])
            elif top == 3 and CELL_TYPES[kind][1] == 2:
                faces = mesh.cells[kind][indices]
                _write_set(file, f"*NSET, NSET={name}", np.unique(faces) + 1)
                file.write(f"*SURFACE, NAME={name}, TYPE=ELEMENT\n")
                file.writelines(
                    f"{element}, S{face}\n" for element, face in _sides(blocks, first, faces)
                )


def _number(value: float) -> str:
    """The shortest text that reads back alike, or 14 digits of it: CalculiX reads 20 characters."""
    text = repr(value)
    return text if len(text) <= 20 else f"{value:.13e}"


def _write_elements(file: TextIO, blocks: Dict[str, np.ndarray]) -> Dict[str, int]:
    """Writes the elements; returns the number of each type's first."""
    first: Dict[str, int] = {}
    number = 1
    for name, nodes in blocks.items():
        first[name] = number
        file.write(f"*ELEMENT, TYPE={ELEMENT_TYPES[name]}, ELSET={name}\n")
        for cell in (nodes + 1).tolist():
            # A line holds 16 numbers at most; one that ends in a comma goes on.
            if len(cell) > 15:
                head, tail = ", ".join(map(str, cell[:15])), ", ".join(map(str, cell[15:]))
                file.write(f"{number}, {head},\n{tail}\n")
            else:
                file.write(f"{number}, {', '.join(map(str, cell))}\n")
            number += 1
    return first


def _write_set(file: TextIO, head: str, numbers: np.ndarray) -> None:
    file.write(head + "\n")
    values = numbers.tolist()
    for start in range(0, len(values), 16):
        file.write(", ".join(map(str, values[start : start + 16])) + "\n")


def _sides(
    blocks: Dict[str, np.ndarray], first: Dict[str, int], faces: np.ndarray
) -> Iterator[Tuple[int, int]]:
    """(element number, 1-based side) of each face; one element's where two share it."""
    corners = 4 if faces.shape[1] in (4, 8) else 3
    wanted = np.sort(faces[:, :corners], axis=1)
    touched = np.unique(wanted)
    for name, nodes in blocks.items():
        local = _FACES[8 if name.startswith("hexahedron") else 4]
        if len(local[0]) != corners:
            continue
        # Only the elements at the faces are looked through.
        near = np.flatnonzero(np.isin(nodes[:, : len(set(sum(local, ())))], touched).any(axis=1))
        known: Dict[tuple, Tuple[int, int]] = {}
        for side, at in enumerate(local, 1):
            keys: List[List[int]] = np.sort(nodes[near][:, list(at)], axis=1).tolist()
            for element, key in zip(near.tolist(), keys):
                known.setdefault(tuple(key), (element + first[name], side))
        for key in wanted.tolist():
            if tuple(key) in known:
                yield known[tuple(key)]
