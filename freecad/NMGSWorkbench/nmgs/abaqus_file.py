# SPDX-License-Identifier: LGPL-2.1-or-later
"""Abaqus and CalculiX input files (.inp): nodes, elements, sets and surfaces.

Our own writer, since meshio's writes hexahedra as C3D20RH, which CalculiX does not know, and no
surfaces; FreeCAD's drops pyramids and has no surfaces either. Reading is meshio's.
"""

from __future__ import annotations

import re
from typing import Dict, Iterator, List, Optional, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .mesh import CELL_TYPES, Mesh
from .meshio_files import read_mesh
from .text_sections import reader
from .text_rows import write_rows, write_wrapped

__all__ = ["ELEMENT_TYPES", "read_inp", "write_inp"]

#: Element type of each cell type. Node orders agree with VTK's; see _COLLAPSED for pyramids.
ELEMENT_TYPES: Dict[str, str] = {
    "line": "B31",
    "line3": "B32",
    "triangle": "S3",
    "triangle6": "S6",
    "quad": "S4",
    "quad8": "S8",
    "tetra": "C3D4",
    "tetra10": "C3D10",
    "pyramid": "C3D8",
    "pyramid13": "C3D20",
    "wedge": "C3D6",
    "wedge15": "C3D15",
    "hexahedron": "C3D8",
    "hexahedron20": "C3D20",
}
#: CalculiX has no pyramids: hexahedra whose top is one node.
_COLLAPSED = {
    "pyramid": (0, 1, 2, 3, 4, 4, 4, 4),
    "pyramid13": (0, 1, 2, 3, 4, 4, 4, 4, 5, 6, 7, 8, 4, 4, 4, 4, 9, 10, 11, 12),
}
_MID_SIDES = {"line": (0, 2, 1), "line3": (0, 2, 1)}
#: Corner nodes of the faces S1, S2, ... of an element, 0-based; None: a face that is one node.
_TETRA = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))
_WEDGE = ((0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5))
_PYRAMID = ((0, 1, 2, 3), None, (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))
_HEXAHEDRON = (
    (0, 1, 2, 3),
    (4, 7, 6, 5),
    (0, 4, 5, 1),
    (1, 5, 6, 2),
    (2, 6, 7, 3),
    (3, 7, 4, 0),
)
SOLID_FACES: Dict[str, tuple] = {
    "tetra": _TETRA,
    "tetra10": _TETRA,
    "wedge": _WEDGE,
    "wedge15": _WEDGE,
    "pyramid": _PYRAMID,
    "pyramid13": _PYRAMID,
    "hexahedron": _HEXAHEDRON,
    "hexahedron20": _HEXAHEDRON,
}
_SOLID_CORNERS = {"tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}


@reader
def read_inp(path: str) -> Mesh:
    """Cells and sets. Pyramids that were written as collapsed hexahedra are pyramids again.

    Raises FormatError, FileNotFoundError.
    """
    mesh = read_mesh(path)
    for whole, part in (("hexahedron", "pyramid"), ("hexahedron20", "pyramid13")):
        cells = mesh.cells.get(whole)
        if cells is None:
            continue
        collapsed = (cells[:, 4:8] == cells[:, 4:5]).all(axis=1)
        if collapsed.any():
            mesh = _with_pyramids(mesh, whole, part, collapsed)
    return mesh


def _with_pyramids(mesh: Mesh, whole: str, part: str, collapsed: np.ndarray) -> Mesh:
    order = [_COLLAPSED[part].index(n) for n in range(CELL_TYPES[part][0])]
    cells = dict(mesh.cells)
    hexahedra = cells.pop(whole)
    if not collapsed.all():
        cells[whole] = hexahedra[~collapsed]
    cells[part] = hexahedra[collapsed][:, order]
    rank = np.where(collapsed, np.cumsum(collapsed), np.cumsum(~collapsed)) - 1
    groups = {}
    for name, (kind, indices) in mesh.groups.items():
        if kind != whole:
            groups[name] = (kind, indices)
            continue
        inside = collapsed[indices]
        if inside.any():
            groups[name if inside.all() else f"{name}_{part}"] = (part, rank[indices[inside]])
        if not inside.all():
            groups[name] = (whole, rank[indices[~inside]])
    return Mesh(mesh.points, cells, groups)


def write_inp(path: str, mesh: Mesh, plane: Optional[str] = None, reduced: bool = False) -> None:
    """The cells of the highest dimension, with their groups as ELSET.

    Groups of nodes are NSET; a group of cells of a lower dimension is an NSET of its nodes, and one
    of faces of volume cells a SURFACE of the same name as well. The faces are not written as
    elements: they would be shells. Each cell type is an ELSET by its own name, too. Pyramids become
    hexahedra with four nodes in one, since CalculiX has no others. plane: "stress" or "strain"
    writes surface cells as CPS or CPE elements instead of shells. reduced: hexahedron20 and quad8
    as elements of reduced integration (C3D20R, S8R), which CalculiX's manual recommends: they bend
    better and do not lock where Poisson's ratio nears 0.5. Characters that sets' names
    cannot have become "_". Raises ValueError.
    """
    if plane not in (None, "stress", "strain"):
        raise ValueError(f"plane: expected None, 'stress' or 'strain', got {plane!r}")
    top = max((CELL_TYPES[name][1] for name in mesh.cells), default=0)
    blocks = {name: nodes for name, nodes in mesh.cells.items() if CELL_TYPES[name][1] == top}
    types = dict(ELEMENT_TYPES)
    if plane is not None:
        prefix = {"stress": "CPS", "strain": "CPE"}[plane]
        types.update({k: prefix + v[1:] for k, v in types.items() if v.startswith("S")})
    if reduced:
        types.update({k: types[k] + "R" for k in ("hexahedron20", "quad8")})
    names = set_names(mesh.groups, reserved=blocks)
    with replaced_file(path) as file:
        file.write("*HEADING\nNMGS Workbench\n*NODE\n")
        write_rows(file, "{}, {}, {}, {}\n", mesh.points, first=1, convert=_number)
        first = _write_elements(file, blocks, types)
        for name, (kind, indices) in mesh.groups.items():
            title = names[name]
            if kind == "node":
                _write_set(file, f"*NSET, NSET={title}", indices + 1)
            elif kind in blocks:
                _write_set(file, f"*ELSET, ELSET={title}", indices + first[kind])
            elif CELL_TYPES[kind][1] < top and len(indices):
                cells = mesh.cells[kind][indices]
                _write_set(file, f"*NSET, NSET={title}", np.unique(cells) + 1)
                if top == 3 and CELL_TYPES[kind][1] == 2:
                    file.write(f"*SURFACE, NAME={title}, TYPE=ELEMENT\n")
                    file.writelines(
                        f"{element}, S{side}\n" for element, side in _sides(blocks, first, cells)
                    )


def set_names(names: "Iterator[str] | Dict[str, object]", reserved: object = ()) -> Dict[str, str]:
    """A name for each that a solver's input takes: letters, digits, "_" and "-", at most 80, told
    apart without regard to case, none of those reserved."""
    taken = {str(name).upper() for name in reserved}  # type: ignore[attr-defined]
    result: Dict[str, str] = {}
    for name in names:
        plain = re.sub(r"[^A-Za-z0-9_-]", "_", name)[:72] or "Set"
        title, number = plain, 1
        while title.upper() in taken:
            number += 1
            title = f"{plain}_{number}"
        taken.add(title.upper())
        result[name] = title
    return result


def _number(value: float) -> str:
    """The shortest text that reads back alike, or 14 digits of it: CalculiX reads 20 characters."""
    text = repr(value)
    return text if len(text) <= 20 else f"{value:.13e}"


def _write_elements(
    file: TextIO, blocks: Dict[str, np.ndarray], types: Dict[str, str]
) -> Dict[str, int]:
    """Writes the elements; returns the number of each type's first."""
    first: Dict[str, int] = {}
    number = 1
    for name, nodes in blocks.items():
        first[name] = number
        file.write(f"*ELEMENT, TYPE={types[name]}, ELSET={name}\n")
        order = _COLLAPSED.get(name) or (_MID_SIDES[name] if name == "line3" else None)
        count = nodes.shape[1] if order is None else len(order)
        # A line holds 16 numbers at most; one that ends in a comma goes on.
        template = ", ".join(["{}"] * (min(count, 15) + 1))
        if count > 15:
            template += ",\n" + ", ".join(["{}"] * (count - 15))
        write_rows(file, template + "\n", nodes, first=number, order=order, add=1)
        number += len(nodes)
    return first


def _write_set(file: TextIO, head: str, numbers: np.ndarray) -> None:
    if len(numbers):
        file.write(head + "\n")
        write_wrapped(file, numbers, 16)


def _sides(
    blocks: Dict[str, np.ndarray], first: Dict[str, int], faces: np.ndarray
) -> Iterator[Tuple[int, int]]:
    """(element number, 1-based side) of each face; one element's where two share it."""
    corners = 4 if faces.shape[1] in (4, 8) else 3
    wanted = np.sort(faces[:, :corners], axis=1)
    touched = np.unique(wanted)
    known: Dict[tuple, Tuple[int, int]] = {}
    for name, nodes in blocks.items():
        linear = next(k for k in _SOLID_CORNERS if name.startswith(k))
        # Only the elements at the faces are looked through.
        near = np.flatnonzero(np.isin(nodes[:, : _SOLID_CORNERS[linear]], touched).any(axis=1))
        for side, at in enumerate(SOLID_FACES[name], 1):
            if at is None or len(at) != corners:
                continue
            keys: List[List[int]] = np.sort(nodes[near][:, list(at)], axis=1).tolist()
            for element, key in zip(near.tolist(), keys):
                known.setdefault(tuple(key), (element + first[name], side))
    for key in wanted.tolist():
        if tuple(key) in known:
            yield known[tuple(key)]
