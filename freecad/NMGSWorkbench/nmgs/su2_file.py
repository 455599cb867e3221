# SPDX-License-Identifier: LGPL-2.1-or-later
"""SU2's native mesh (.su2). Our own writer: meshio's has no names of markers. Cells are linear."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from .atomic import replaced_file
from .convert import boundary_with_parents
from .group_partition import one_number
from .mesh import CELL_TYPES, Mesh
from .text_rows import write_rows
from .text_sections import Lines, reader
from .vtk_file import VTK_TYPES

#: VTK's numbers, as SU2 takes them; from 21 on they are quadratic.
TYPES = {name: number for name, number in VTK_TYPES.items() if number < 21}
#: Marker of boundary faces that are in no group.
REST = "boundary"


def write_su2(path: str, mesh: Mesh) -> None:
    """Cells of the highest dimension; markers from the groups of the boundary's cells.

    Faces (of a surface: edges) of the boundary that no group has get the marker "boundary", since
    SU2 wants every one marked. A face in many groups goes to the first. Raises ValueError for
    quadratic cells.
    """
    top = max((CELL_TYPES[name][1] for name in mesh.cells), default=0)
    wrong = [name for name in mesh.cells if name not in TYPES and len(mesh.cells[name])]
    if wrong:
        raise ValueError(f"mesh: SU2 has linear cells only, not {', '.join(wrong)}")
    if top < 2:
        raise ValueError("mesh: SU2 wants surface or volume cells")
    blocks = {name: n for name, n in mesh.cells.items() if CELL_TYPES[name][1] == top}
    flat = top == 2 and not mesh.points[:, 2].any()
    dimensions = 2 if flat else 3
    with replaced_file(path) as file:
        file.write(f"NDIME= {dimensions}\nNELEM= {sum(map(len, blocks.values()))}\n")
        number = 0
        for name, nodes in blocks.items():
            # The number at the end is old practice that readers still expect.
            template = f"{TYPES[name]} " + "{} " * nodes.shape[1] + "\n"
            write_rows(file, template, nodes)
            number += len(nodes)
        file.write(f"NPOIN= {len(mesh.points)}\n")
        write_rows(file, "{} " * dimensions + "\n", mesh.points[:, :dimensions])
        markers = markers_of(mesh, top)
        file.write(f"NMARK= {len(markers)}\n")
        for title, parts in markers.items():
            file.write(f"MARKER_TAG= {'_'.join(title.split())}\n")
            file.write(f"MARKER_ELEMS= {sum(len(rows) for _, rows in parts)}\n")
            for name, rows in parts:
                write_rows(file, f"{TYPES[name]} " + "{} " * rows.shape[1] + "\n", rows)


def markers_of(mesh: Mesh, top: int) -> Dict[str, List[Tuple[str, np.ndarray]]]:
    """name -> (cell type, rows of nodes): the outer faces of a mesh by their groups, the rest as
    "boundary"."""
    bare = Mesh(mesh.points, {k: v for k, v in mesh.cells.items() if CELL_TYPES[k][1] == top})
    outer, kept, _ = boundary_with_parents(bare)
    result: Dict[str, List[Tuple[str, np.ndarray]]] = {}
    titles = [n for n, (k, _) in mesh.groups.items() if k != "node" and CELL_TYPES[k][1] == top - 1]
    number = {name: at for at, name in enumerate(titles, 1)}
    rest: List[Tuple[str, np.ndarray]] = []
    for kind, local in outer.cells.items():
        faces = kept[local]
        label = np.zeros(len(faces), dtype=np.int32)
        if kind in mesh.cells:
            whole = np.sort(np.concatenate([faces, mesh.cells[kind]]), axis=1)
            _, place = np.unique(whole, axis=0, return_inverse=True)
            place = place.reshape(-1)
            labels = np.zeros(place.max() + 1, dtype=np.int32)
            labels[place[len(faces) :]] = one_number(mesh, kind, number)
            label = labels[place[: len(faces)]]
        for name in titles:
            chosen = faces[label == number[name]]
            if len(chosen):
                result.setdefault(name, []).append((kind, chosen))
        if (label == 0).any():
            rest.append((kind, faces[label == 0]))
    if rest:
        result[REST if REST not in result else "rest"] = rest
    return result


@reader
def read_su2(path: str) -> Mesh:
    """Cells, and markers as groups. Raises FormatError, FileNotFoundError."""
    lines = Lines(path)
    names = {number: name for name, number in TYPES.items()}
    cells: Dict[str, List[List[int]]] = {}
    groups: Dict[str, Dict[str, List[int]]] = {}
    points = np.zeros((0, 3))
    dimension, marker = 3, ""
    while lines.more():
        key, _, value = lines.next("a key").partition("=")
        key, value = key.strip().upper(), value.split("%")[0].strip()
        if not key or key.startswith("%"):
            continue
        if key == "MARKER_TAG":
            marker = value
        elif key in ("NDIME", "NELEM", "NPOIN", "MARKER_ELEMS"):
            try:
                count = int(value.split()[0])
            except (ValueError, IndexError):
                raise lines.error(f"expected a number after {key}=, found {value!r}") from None
            if key == "NDIME":
                dimension = count
            elif key == "NPOIN":
                points = _read_points(lines, count, dimension)
            else:
                for _ in range(count):
                    name, nodes = _read_element(lines, names)
                    rows = cells.setdefault(name, [])
                    if key == "MARKER_ELEMS":
                        groups.setdefault(marker, {}).setdefault(name, []).append(len(rows))
                    rows.append(nodes)
    named: Dict[str, Any] = {}
    for title, parts in groups.items():
        for name, indices in parts.items():
            named[title if len(parts) == 1 else f"{title}_{name}"] = (name, np.array(indices))
    try:
        return Mesh(points, {k: np.array(v) for k, v in cells.items()}, named)
    except ValueError as error:
        raise lines.error(str(error)) from error


def _read_points(lines: Lines, count: int, dimension: int) -> np.ndarray:
    points = np.zeros((count, 3))
    for at in range(count):
        row = lines.next("a point").split()
        try:
            points[at, :dimension] = [float(word) for word in row[:dimension]]
        except ValueError:
            raise lines.error(
                f"expected {dimension} coordinates, found {' '.join(row)!r}"
            ) from None
    return points


def _read_element(lines: Lines, names: Dict[int, str]) -> Tuple[str, List[int]]:
    row = lines.integers("an element", 1)
    if row[0] not in names:
        raise lines.error(f"elements of type {row[0]} are not known here")
    name = names[row[0]]
    lines.at -= 1
    return name, lines.integers("an element's nodes", 1 + CELL_TYPES[name][0])[1:]
