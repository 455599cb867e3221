# SPDX-License-Identifier: LGPL-2.1-or-later
"""Salome's .med (MED 3.0 in HDF5), by h5py: nodes, cells, families and their groups.

Our own: meshio keeps VTK's order of nodes, with which Salome's hexahedra are inside out, and drops
13-node pyramids; FreeCAD's writer needs the mesh once more in its own, larger form. MED's order is
that of Fem.FemMesh: the base of a volume is seen from outside.
"""

from __future__ import annotations

import os
from typing import Any, Dict, List, Tuple

import numpy as np

from .atomic import temporary_beside
from .errors import Error, FormatError
from .group_partition import partition
from .mesh import CELL_TYPES, Mesh

#: MED's name of a cell type, and its nodes as indices into ours.
TYPES: Dict[str, Tuple[str, Any]] = {
    "line": ("SE2", None),
    "line3": ("SE3", None),
    "triangle": ("TR3", None),
    "triangle6": ("TR6", None),
    "quad": ("QU4", None),
    "quad8": ("QU8", None),
    "tetra": ("TE4", (0, 2, 1, 3)),
    "tetra10": ("T10", (0, 2, 1, 3, 6, 5, 4, 7, 9, 8)),
    "pyramid": ("PY5", (0, 3, 2, 1, 4)),
    "pyramid13": ("P13", (0, 3, 2, 1, 4, 8, 7, 6, 5, 9, 12, 11, 10)),
    "wedge": ("PE6", (0, 2, 1, 3, 5, 4)),
    "wedge15": ("P15", (0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13)),
    "hexahedron": ("HE8", (0, 3, 2, 1, 4, 7, 6, 5)),
    "hexahedron20": (
        "H20",
        (0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17),
    ),
}
_STEP = "-0000000000000000001-0000000000000000001"
_PROFILE = np.bytes_("MED_NO_PROFILE_INTERNAL")


def _h5py() -> Any:
    try:
        import h5py
    except ImportError as error:
        raise Error("MED files need h5py (Debian: python3-h5py)") from error
    return h5py


def write_med(path: str, mesh: Mesh) -> None:
    """All cells and groups; names of groups have 80 bytes. Raises Error where h5py is missing.

    The mesh has the file's name: FreeCAD looks for no other.
    """
    h5py = _h5py()
    title = os.path.splitext(os.path.basename(path))[0][:64] or "Mesh"
    with temporary_beside(path) as temporary, h5py.File(temporary, "w") as file:
        info = file.create_group("INFOS_GENERALES")
        for key, value in (("MAJ", 3), ("MIN", 0), ("REL", 0)):
            info.attrs[key] = np.int32(value)
        head = file.create_group(f"ENS_MAA/{title}")
        for key, value in (("DIM", 3), ("ESP", 3), ("REP", 0), ("SRT", 1), ("TYP", 0)):
            head.attrs[key] = np.int32(value)
        head.attrs["UNT"] = head.attrs["DES"] = np.bytes_("")
        head.attrs["UNI"] = np.bytes_(" " * 48)
        head.attrs["NOM"] = np.bytes_("".join(f"{axis:<16}" for axis in "XYZ"))
        step = head.create_group(_STEP)
        step.attrs["CGT"] = np.int32(1)
        step.attrs["NDT"] = step.attrs["NOR"] = np.int32(-1)
        step.attrs["PDT"] = -1.0
        families = file.create_group(f"FAS/{title}")
        families.create_group("FAMILLE_ZERO").attrs["NUM"] = np.int32(0)
        _write_nodes(step, families, mesh)
        _write_cells(step, families, mesh)


def _dataset(group: Any, name: str, array: np.ndarray, count: int) -> None:
    data = group.create_dataset(name, data=array)
    data.attrs["CGT"] = np.int32(1)
    data.attrs["NBR"] = np.int32(count)


def _columns(group: Any, name: str, array: np.ndarray, order: Any, add: int) -> None:
    """All first values, then all second ones, ...: written a column at a time."""
    count, wide = array.shape
    data = group.create_dataset(name, (count * wide,), dtype=array.dtype)
    for k in range(wide):
        column = array[:, k if order is None else order[k]]
        data[k * count : (k + 1) * count] = column + add if add else column
    data.attrs["CGT"] = np.int32(1)
    data.attrs["NBR"] = np.int32(count)


def _family(families: Any, kind: str, number: int, names: Tuple[str, ...]) -> None:
    title = f"FAM_{number}_{'_'.join(names)}".replace("/", "|")[:64]
    family = families.create_group(f"{kind}/{title}")
    family.attrs["NUM"] = np.int32(number)
    members = family.create_group("GRO")
    members.attrs["NBR"] = np.int32(len(names))
    text = np.zeros((len(names), 80), dtype=np.int8)
    for row, name in zip(text, names):
        raw = np.frombuffer(name.encode("utf-8")[:80], dtype=np.int8)
        row[: len(raw)] = raw
    # One string of 80 bytes each, as HDF5 arrays.
    kind80 = np.dtype((np.int8, 80))
    data = members.create_dataset("NOM", (len(names),), dtype=kind80)
    data[...] = text


def _write_nodes(step: Any, families: Any, mesh: Mesh) -> None:
    nodes = step.create_group("NOE")
    nodes.attrs["CGT"] = nodes.attrs["CGS"] = np.int32(1)
    nodes.attrs["PFL"] = _PROFILE
    _columns(nodes, "COO", mesh.points, None, 0)
    groups = {name: group for name, group in mesh.groups.items() if group[0] == "node"}
    if not groups:
        return
    part, members = _node_partition(mesh)
    number = 0
    table = []
    for names in members:
        number += bool(names)
        table.append(number if names else 0)
        if names:
            _family(families, "NOEUD", number, names)
    _dataset(nodes, "FAM", np.array(table, dtype=np.int32)[part], len(part))


def _node_partition(mesh: Mesh) -> Tuple[np.ndarray, List[Tuple[str, ...]]]:
    # As cells of one node, which partition knows how to part.
    dots = Mesh.__new__(Mesh)
    dots.cells = {"node": np.arange(len(mesh.points))[:, None]}
    dots.groups = mesh.groups
    return partition(dots, "node")


def _write_cells(step: Any, families: Any, mesh: Mesh) -> None:
    cells = step.create_group("MAI")
    cells.attrs["CGT"] = np.int32(1)
    known: Dict[Tuple[str, ...], int] = {(): 0}
    for kind, nodes in mesh.cells.items():
        if not len(nodes):
            continue
        name, order = TYPES[kind]
        group = cells.create_group(name)
        group.attrs["CGT"] = group.attrs["CGS"] = np.int32(1)
        group.attrs["PFL"] = _PROFILE
        _columns(group, "NOD", nodes, order, 1)
        part, members = partition(mesh, kind)
        for names in members:
            if names not in known:
                known[names] = -len(known)
                _family(families, "ELEME", known[names], names)
        table = np.array([known[names] for names in members], dtype=np.int32)
        _dataset(group, "FAM", table[part], len(part))


def read_med(path: str) -> Mesh:
    """The file's first mesh at its last step, with its groups. Raises FormatError,
    FileNotFoundError, and Error where h5py is missing."""
    h5py = _h5py()
    if not os.path.exists(path):
        raise FileNotFoundError(f"no such file: {path}")
    try:
        with h5py.File(path, "r") as file:
            return _read(path, file)
    except (OSError, KeyError, ValueError, IndexError) as error:
        if isinstance(error, FormatError):
            raise
        raise FormatError(f"{path}: not a MED mesh: {error}", path) from error


def _read(path: str, file: Any) -> Mesh:
    meshes = file["ENS_MAA"]
    title = next(iter(meshes))
    head = meshes[title]
    step = head[sorted(head)[-1]] if "NOE" not in head else head
    dimension = int(head.attrs["ESP"])
    places = np.asarray(step["NOE/COO"]).reshape(dimension, -1).T
    points = np.zeros((len(places), 3))
    points[:, :dimension] = places
    names = _read_families(file, title)
    kinds = {name: kind for kind, (name, _) in TYPES.items()}
    cells: Dict[str, np.ndarray] = {}
    groups: Dict[str, Dict[str, np.ndarray]] = {}
    labels = [("node", np.asarray(step["NOE/FAM"]))] if "FAM" in step["NOE"] else []
    for name in step["MAI"] if "MAI" in step else ():
        if name == "PO1":
            continue
        if name not in kinds:
            raise FormatError(f"{path}: cells {name} are not known here", path)
        kind, group = kinds[name], step["MAI"][name]
        nodes = np.asarray(group["NOD"]).reshape(CELL_TYPES[kind][0], -1).T - 1
        order = TYPES[kind][1]
        cells[kind] = nodes if order is None else nodes[:, np.argsort(order)]
        if "FAM" in group:
            labels.append((kind, np.asarray(group["FAM"])))
    for kind, label in labels:
        found: Dict[str, List[np.ndarray]] = {}
        for number in np.unique(label).tolist():
            for group_name in names.get((kind == "node", number), ()):
                found.setdefault(group_name, []).append(np.flatnonzero(label == number))
        for group_name, parts in found.items():
            groups.setdefault(group_name, {})[kind] = np.sort(np.concatenate(parts))
    named = {
        (group if len(parts) == 1 else f"{group}_{kind}"): (kind, indices)
        for group, parts in groups.items()
        for kind, indices in parts.items()
    }
    return Mesh(points, cells, named)


def _read_families(file: Any, title: str) -> Dict[Tuple[bool, int], List[str]]:
    """(of nodes, number) -> names of groups."""
    result: Dict[Tuple[bool, int], List[str]] = {}
    root = f"FAS/{title}"
    for kind in ("NOEUD", "ELEME"):
        for family in file[root][kind].values() if root in file and kind in file[root] else ():
            if "GRO" not in family:
                continue
            rows = np.asarray(family["GRO/NOM"][()]).reshape(-1, 80)
            result[kind == "NOEUD", int(family.attrs["NUM"])] = [
                row.astype(np.int8).tobytes().split(b"\0")[0].decode("utf-8", "replace").strip()
                for row in rows
            ]
    return result
