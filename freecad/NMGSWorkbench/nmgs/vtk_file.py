# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK's XML (.vtu) and legacy (.vtk) unstructured grids, binary.

Our own writers: meshio's copy and pack every array, ours write slices of the mesh's own arrays.
Groups are arrays of 0 and 1 by their names, of cells or of points. Reading is meshio's.
"""

from __future__ import annotations

from typing import BinaryIO, Callable, Dict, Iterator, List, Tuple

import numpy as np

from .atomic import temporary_beside
from .mesh import Mesh
from .meshio_files import read_mesh
from .text_rows import SLICE

#: Numbers of VTK's cells (vtkCellType.h). Node orders are VTK's already, but for _ORDER.
VTK_TYPES: Dict[str, int] = {
    "line": 3,
    "triangle": 5,
    "quad": 9,
    "tetra": 10,
    "hexahedron": 12,
    "wedge": 13,
    "pyramid": 14,
    "line3": 21,
    "triangle6": 22,
    "quad8": 23,
    "tetra10": 24,
    "hexahedron20": 25,
    "wedge15": 26,
    "pyramid13": 27,
}
#: vtkWedge has its base seen from outside; meshio, whose order is ours, turns it round as well.
_ORDER = {"wedge": [0, 2, 1, 3, 5, 4]}
_ROWS = SLICE * 8

#: (name, VTK's type, components, values in all, pieces of the array)
Part = Tuple[str, str, int, int, Callable[[], Iterator[np.ndarray]]]


def read_vtk(path: str) -> Mesh:
    """Points, cells, and arrays of 0 and 1 as groups. Raises FormatError, FileNotFoundError."""
    return read_mesh(path, groups_of_arrays=True)


def _pieces(array: np.ndarray) -> Iterator[np.ndarray]:
    for start in range(0, len(array), _ROWS):
        yield array[start : start + _ROWS]


def _connectivity(mesh: Mesh) -> Iterator[np.ndarray]:
    for name, nodes in mesh.cells.items():
        for piece in _pieces(nodes):
            yield piece[:, _ORDER[name]] if name in _ORDER else piece


def _offsets(mesh: Mesh) -> Iterator[np.ndarray]:
    start = 0
    for nodes in mesh.cells.values():
        size = nodes.shape[1]
        for first in range(0, len(nodes), _ROWS):
            count = min(_ROWS, len(nodes) - first)
            yield start + size * np.arange(1, count + 1, dtype=np.int64)
            start += size * count


def _types(mesh: Mesh) -> Iterator[np.ndarray]:
    for name, nodes in mesh.cells.items():
        for first in range(0, len(nodes), _ROWS):
            yield np.full(min(_ROWS, len(nodes) - first), VTK_TYPES[name], dtype=np.uint8)


def _flags(mesh: Mesh, group: str) -> Iterator[np.ndarray]:
    """0 and 1 for all cells, or all points of a group of nodes."""
    kind, indices = mesh.groups[group]
    blocks = {"node": mesh.points} if kind == "node" else mesh.cells
    for name, rows in blocks.items():
        flags = np.zeros(len(rows), dtype=np.int8)
        if name == kind:
            flags[indices] = 1
        yield flags


def _cell_count(mesh: Mesh) -> int:
    return sum(len(nodes) for nodes in mesh.cells.values())


def _named(mesh: Mesh, of_nodes: bool) -> List[str]:
    return [name for name, (kind, _) in mesh.groups.items() if (kind == "node") == of_nodes]


def _attribute(text: str) -> str:
    for plain, escaped in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;")):
        text = text.replace(plain, escaped)
    return text


def write_vtu(path: str, mesh: Mesh) -> None:
    """All cells. The arrays follow the XML as raw bytes ("appended")."""
    points, cells = len(mesh.points), _cell_count(mesh)
    nodes = sum(n.size for n in mesh.cells.values())
    flags: List[List[Part]] = [
        [
            (name, "Int8", 1, count, lambda name=name: _flags(mesh, name))  # type: ignore[misc]
            for name in _named(mesh, of_nodes)
        ]
        for of_nodes, count in ((True, points), (False, cells))
    ]
    sections: List[Tuple[str, List[Part]]] = [
        ("PointData", flags[0]),
        ("CellData", flags[1]),
        ("Points", [("Points", "Float64", 3, 3 * points, lambda: _pieces(mesh.points))]),
        (
            "Cells",
            [
                ("connectivity", "Int32", 1, nodes, lambda: _connectivity(mesh)),
                ("offsets", "Int64", 1, cells, lambda: _offsets(mesh)),
                ("types", "UInt8", 1, cells, lambda: _types(mesh)),
            ],
        ),
    ]
    bytes_of = {"Int8": 1, "UInt8": 1, "Int32": 4, "Int64": 8, "Float64": 8}
    lines = [
        '<?xml version="1.0"?>',
        '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
        'header_type="UInt64">',
        "<UnstructuredGrid>",
        f'<Piece NumberOfPoints="{points}" NumberOfCells="{cells}">',
    ]
    at = 0
    for section, parts in sections:
        lines.append(f"<{section}>")
        for name, kind, components, count, _ in parts:
            lines.append(
                f'<DataArray type="{kind}" Name="{_attribute(name)}" '
                f'NumberOfComponents="{components}" format="appended" offset="{at}"/>'
            )
            at += 8 + count * bytes_of[kind]
        lines.append(f"</{section}>")
    lines += ["</Piece>", "</UnstructuredGrid>", '<AppendedData encoding="raw">', "_"]
    with temporary_beside(path) as temporary, open(temporary, "wb") as file:
        file.write("\n".join(lines).encode("utf-8"))
        for _, parts in sections:
            for _, kind, _, count, pieces in parts:
                file.write(np.array([count * bytes_of[kind]], dtype="<u8").tobytes())
                _write(file, pieces(), f"<{_DTYPES[kind]}")
        file.write(b"\n</AppendedData>\n</VTKFile>\n")


_DTYPES = {"Int8": "i1", "UInt8": "u1", "Int32": "i4", "Int64": "i8", "Float64": "f8"}


def _write(file: BinaryIO, pieces: Iterator[np.ndarray], dtype: str) -> None:
    for piece in pieces:
        file.write(np.ascontiguousarray(piece, dtype=dtype).tobytes())


def write_vtk(path: str, mesh: Mesh) -> None:
    """Legacy file, version 3.0, binary (big-endian)."""
    points, cells = len(mesh.points), _cell_count(mesh)
    total = cells + sum(n.size for n in mesh.cells.values())
    with temporary_beside(path) as temporary, open(temporary, "wb") as file:
        file.write(b"# vtk DataFile Version 3.0\nNMGS Workbench\nBINARY\n")
        file.write(f"DATASET UNSTRUCTURED_GRID\nPOINTS {points} double\n".encode())
        _write(file, _pieces(mesh.points), ">f8")
        file.write(f"\nCELLS {cells} {total}\n".encode())
        for piece in _connectivity(mesh):
            counted = np.empty((len(piece), 1 + piece.shape[1]), dtype=">i4")
            counted[:, 0] = piece.shape[1]
            counted[:, 1:] = piece
            file.write(counted.tobytes())
        file.write(f"\nCELL_TYPES {cells}\n".encode())
        _write(file, _types(mesh), ">i4")
        for head, of_nodes, count in (("CELL_DATA", False, cells), ("POINT_DATA", True, points)):
            names = _named(mesh, of_nodes)
            if names:
                file.write(f"\n{head} {count}\nFIELD groups {len(names)}\n".encode())
            for name in names:
                # A name is one word in this format.
                plain = "_".join(name.split()) or "group"
                file.write(f"{plain} 1 {count} char\n".encode("utf-8"))
                _write(file, _flags(mesh, name), "i1")
                file.write(b"\n")
