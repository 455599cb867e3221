# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenFOAM's polyMesh, a folder: points, faces, owner, neighbour, boundary, cellZones (user guide,
"Mesh description"). Neither meshio nor FreeCAD writes it."""

from __future__ import annotations

import os
import re
from typing import Any, Dict, List, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .cell_sides import SIDES, Sides, sides
from .errors import FormatError
from .group_partition import one_number
from .mesh import CELL_TYPES, Mesh
from .text_sections import reader
from .text_rows import slices, write_rows

#: Patch of boundary faces that are in no group, OpenFOAM's own name for it.
REST = "defaultFaces"


def header(kind: str, name: str, folder: str = "constant/polyMesh") -> str:
    """The head of a dictionary or list."""
    return (
        "FoamFile\n{\n    version 2.0;\n    format ascii;\n"
        f'    class {kind};\n    location "{folder}";\n    object {name};\n}}\n\n'
    )


def word(name: str) -> str:
    """A name as OpenFOAM takes it."""
    return re.sub(r"[^\w.:+-]", "_", name) or "group"


def write_polymesh(path: str, mesh: Mesh, scale: float = 1.0) -> None:
    """path: the polyMesh folder itself; it is made where it is missing. scale: times every length,
    0.001 for a mesh in mm.

    Groups of faces are patches, or faceZones where the faces lie inside; groups of cells are
    cellZones; other boundary faces are the patch defaultFaces. A face or cell in many groups is in
    the first. Internal faces are in OpenFOAM's upper triangular order. Raises ValueError for
    quadratic cells and meshes without volumes.
    """
    wrong = [n for n in mesh.cells if n not in SIDES and CELL_TYPES[n][1] == 3]
    if wrong or not any(name in SIDES for name in mesh.cells):
        raise ValueError(f"mesh: polyMesh wants linear volume cells, not {', '.join(wrong) or '0'}")
    faces = sides(mesh)
    names, label = _labels(mesh, faces)
    inside = faces.neighbour >= 0
    order = _order(faces, inside, label)
    start = int(inside.sum())
    os.makedirs(path, exist_ok=True)
    with replaced_file(os.path.join(path, "points")) as file:
        file.write(header("vectorField", "points") + f"{len(mesh.points)}\n(\n")
        for part in slices(len(mesh.points)):
            write_rows(file, "({} {} {})\n", mesh.points[part] * scale)
        file.write(")\n")
    with replaced_file(os.path.join(path, "faces")) as file:
        file.write(header("faceList", "faces") + f"{len(order)}\n(\n")
        for part in slices(len(order)):
            rows = faces.nodes[order[part]].tolist()
            file.writelines(
                f"3({a} {b} {c})\n" if d < 0 else f"4({a} {b} {c} {d})\n" for a, b, c, d in rows
            )
        file.write(")\n")
    _write_labels(path, "owner", faces.owner[order], mesh, faces)
    _write_labels(path, "neighbour", faces.neighbour[order[:start]], mesh, faces)
    patches = [
        (names[k - 1], int(((label == k) & ~inside).sum())) for k in range(1, len(names) + 1)
    ]
    patches.append((REST, int(((label == 0) & ~inside).sum())))
    with replaced_file(os.path.join(path, "boundary")) as file:
        _write_patches(file, [entry for entry in patches if entry[1]], start)
    _write_zones(path, mesh, names, label[order], start)


def _labels(mesh: Mesh, faces: Sides) -> Tuple[List[str], np.ndarray]:
    """(names of groups of faces, number of each face's first group from 1 on, or 0)."""
    names = [n for n, (k, _) in mesh.groups.items() if k != "node" and CELL_TYPES[k][1] == 2]
    number = {name: at for at, name in enumerate(names, 1)}
    label = np.zeros(len(faces.nodes), dtype=np.int32)
    keys = np.sort(faces.nodes, axis=1)
    for kind in ("triangle", "quad"):
        if kind not in mesh.cells or not len(mesh.cells[kind]):
            continue
        rows = np.full((len(mesh.cells[kind]), 4), -1, dtype=np.int32)
        rows[:, : CELL_TYPES[kind][0]] = mesh.cells[kind]
        whole = np.concatenate([keys, np.sort(rows, axis=1)])
        _, place = np.unique(whole, axis=0, return_inverse=True)
        place = place.reshape(-1)
        labels = np.zeros(place.max() + 1, dtype=np.int32)
        labels[place[len(keys) :]] = one_number(mesh, kind, number)
        found = labels[place[: len(keys)]]
        label[found > 0] = found[found > 0]
    return names, label


def _order(faces: Sides, inside: np.ndarray, label: np.ndarray) -> np.ndarray:
    """Internal faces by owner and neighbour, then patches one after the other, the rest last."""
    last = len(label) + 1  # more than there are groups; labels have few bits
    patch = np.where(inside, -1, np.where(label == 0, last, label))
    return np.lexsort((np.where(inside, faces.neighbour, 0), faces.owner, patch))


def _write_labels(path: str, name: str, values: np.ndarray, mesh: Mesh, faces: Sides) -> None:
    cells = int(faces.owner.max()) + 1 if len(faces.owner) else 0
    note = (
        f'    note "nPoints:{len(mesh.points)} nCells:{cells} nFaces:{len(faces.nodes)} '
        f'nInternalFaces:{int((faces.neighbour >= 0).sum())}";\n'
    )
    with replaced_file(os.path.join(path, name)) as file:
        head = header("labelList", name).replace("    location", note + "    location")
        file.write(head + f"{len(values)}\n(\n")
        write_rows(file, "{}\n", values[:, None])
        file.write(")\n")


def _write_patches(file: TextIO, patches: List[Tuple[str, int]], start: int) -> None:
    file.write(header("polyBoundaryMesh", "boundary") + f"{len(patches)}\n(\n")
    for name, count in patches:
        file.write(
            f"    {word(name)}\n    {{\n        type patch;\n        nFaces {count};\n"
            f"        startFace {start};\n    }}\n"
        )
        start += count
    file.write(")\n")


def _write_zones(path: str, mesh: Mesh, names: List[str], label: np.ndarray, start: int) -> None:
    titles = [n for n, (k, _) in mesh.groups.items() if k in SIDES]
    number = {name: at for at, name in enumerate(titles, 1)}
    labels = [one_number(mesh, k, number) for k in mesh.cells if k in SIDES]
    cell_label = np.concatenate(labels)
    zones = [(name, np.flatnonzero(cell_label == number[name])) for name in titles]
    _write_zone_file(path, "cellZones", "cellZone", "cellLabels", zones)
    walls = [(n, np.flatnonzero(label[:start] == k)) for k, n in enumerate(names, 1)]
    _write_zone_file(path, "faceZones", "faceZone", "faceLabels", walls)
    dots = [(n, i) for n, (kind, i) in mesh.groups.items() if kind == "node"]
    _write_zone_file(path, "pointZones", "pointZone", "pointLabels", dots)


def _write_zone_file(path: str, base: str, kind: str, key: str, zones: Any) -> None:
    zones = [(name, members) for name, members in zones if len(members)]
    target = os.path.join(path, base)
    if not zones:
        # One of an earlier mesh in this folder would belong to other cells.
        if os.path.exists(target):
            os.unlink(target)
        return
    with replaced_file(target) as file:
        file.write(header("regIOobject", base) + f"{len(zones)}\n(\n")
        for name, members in zones:
            file.write(
                f"    {word(name)}\n    {{\n        type {kind};\n        {key} List<label>\n"
            )
            file.write(f"{len(members)}\n(\n")
            write_rows(file, "{}\n", members[:, None])
            file.write(");\n")
            if kind == "faceZone":
                file.write(f"        flipMap List<bool> {len(members)}{{0}};\n")
            file.write("    }\n")
        file.write(")\n")


@reader
def read_polymesh(path: str) -> Mesh:
    """A polyMesh of hexahedra, wedges, pyramids and tetrahedra, as text; patches and zones are
    groups. Raises FormatError, FileNotFoundError."""
    points = _floats(os.path.join(path, "points"))
    faces = _faces(os.path.join(path, "faces"))
    owner = _integers(os.path.join(path, "owner"))
    neighbour = _integers(os.path.join(path, "neighbour"))
    if len(owner) != len(faces) or len(neighbour) > len(faces):
        raise FormatError(f"{path}: {len(faces)} faces, but {len(owner)} owners", path)
    around: Dict[int, List[List[int]]] = {}
    for at, face in enumerate(faces):
        around.setdefault(int(owner[at]), []).append(face)
        if at < len(neighbour):
            around.setdefault(int(neighbour[at]), []).append(face[::-1])
    cells: Dict[str, List[List[int]]] = {}
    place: Dict[int, Tuple[str, int]] = {}
    for number in sorted(around):
        kind, nodes = _cell(path, number, around[number])
        place[number] = (kind, len(cells.setdefault(kind, [])))
        cells[kind].append(nodes)
    groups: Dict[str, Any] = {}
    for name, entries in _dictionary(os.path.join(path, "boundary")):
        first, count = int(entries.get("startFace", 0)), int(entries.get("nFaces", 0))
        parts: Dict[str, List[int]] = {}
        for face in faces[first : first + count]:
            if len(face) not in (3, 4):
                raise FormatError(f"{path}: a face of {len(face)} nodes", path)
            kind = "triangle" if len(face) == 3 else "quad"
            rows = cells.setdefault(kind, [])
            parts.setdefault(kind, []).append(len(rows))
            rows.append(face)
        for kind, indices in parts.items():
            groups[name if len(parts) == 1 else f"{name}_{kind}"] = (kind, np.array(indices))
    for name, entries in _dictionary(os.path.join(path, "cellZones")):
        members: Dict[str, List[int]] = {}
        for number in entries.get("cellLabels", []):
            kind, at = place[number]
            members.setdefault(kind, []).append(at)
        for kind, indices in members.items():
            groups[name if len(members) == 1 else f"{name}_{kind}"] = (kind, np.array(indices))
    return Mesh(points, {kind: np.array(rows) for kind, rows in cells.items()}, groups)


def _cell(path: str, number: int, faces: List[List[int]]) -> Tuple[str, List[int]]:
    """The cell that these faces, seen from outside, enclose."""
    corners = sorted(len(face) for face in faces)
    known = {tuple(sorted(map(len, table))): kind for kind, table in SIDES.items()}
    kind = known.get(tuple(corners))
    if kind is None:
        raise FormatError(f"{path}: cell {number} has faces of {corners} nodes", path)
    base = next(f for f in faces if len(f) == len(SIDES[kind][0]))
    # The first side is the base seen from outside: turned round it is the first nodes.
    nodes = [base[0], *base[:0:-1]]
    onward: Dict[int, int] = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            if a in nodes and b not in nodes:
                onward[a] = b
    top = [onward[node] for node in nodes]
    return kind, nodes + (top if kind in ("hexahedron", "wedge") else top[:1])


def _text(path: str) -> str:
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read()
    if re.search(r"format\s+binary", text[:2000]):
        raise FormatError(f"{path}: it is binary; foamFormatConvert makes text of it", path)
    text = re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.S)
    return re.sub(r"FoamFile\s*\{.*?\}", " ", text, count=1, flags=re.S)


def _list(path: str) -> str:
    """What stands between the outer parentheses."""
    text = _text(path)
    first, last = text.find("("), text.rfind(")")
    if first < 0 or last < first:
        raise FormatError(f"{path}: expected a list in parentheses", path)
    return text[first + 1 : last]


def _numbers(path: str, text: str, dtype: Any) -> np.ndarray:
    try:
        return np.array(text.replace("(", " ").replace(")", " ").split(), dtype=np.str_).astype(
            dtype
        )
    except ValueError as error:
        raise FormatError(f"{path}: expected numbers: {error}", path) from error


def _floats(path: str) -> np.ndarray:
    values = _numbers(path, _list(path), np.float64)
    if values.size % 3:
        raise FormatError(f"{path}: {values.size} coordinates are no points", path)
    return values.reshape(-1, 3)


def _integers(path: str) -> np.ndarray:
    return _numbers(path, _list(path), np.int64)


def _faces(path: str) -> List[List[int]]:
    try:
        return [
            [int(w) for w in nodes.split()]
            for _, nodes in re.findall(r"(\d+)\s*\(([^()]*)\)", _list(path))
        ]
    except ValueError as error:
        raise FormatError(f"{path}: {error}", path) from error


def _dictionary(path: str) -> List[Tuple[str, Dict[str, Any]]]:
    """(name, entries) of a list of dictionaries; lists of numbers are lists."""
    if not os.path.exists(path):
        return []
    result = []
    for name, body in re.findall(r"([\w.:+-]+)\s*\{([^{}]*)\}", re.sub(r"\{0\}", "", _list(path))):
        entries: Dict[str, Any] = {}
        for key, value in re.findall(r"(\w+)\s+([^;]*);", body):
            words = re.search(r"\(([^()]*)\)", value)
            listed = words.group(1).split() if words else None
            whole = listed is not None and all(word.isdigit() for word in listed)
            entries[key] = [int(w) for w in listed or ()] if whole else value.strip()
        result.append((name, entries))
    return result
