# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of the formats that meshio reads well."""

from __future__ import annotations

import base64
import os
from typing import Any, Dict, List, Optional

import numpy as np

from .errors import FormatError
from .mesh import CELL_TYPES, Mesh


def module() -> Any:
    """meshio, with two defects mended: version 5.0 (Debian 12) lacks the dimension of two cells
    that it reads and writes; and it decodes an array of a .vtu file together with all arrays
    behind it, which Python refuses from 3.13 on."""
    import meshio
    from meshio import _mesh
    from meshio.vtu import _vtu

    for name in ("wedge15", "pyramid13"):
        getattr(_mesh, "topological_dimension", {}).setdefault(name, 3)
    _vtu.VtuReader.read_uncompressed_binary = _one_array
    return meshio


def _one_array(reader: Any, text: str, dtype: Any) -> np.ndarray:
    """The array whose base64 text comes first: its number of bytes, then these, together or each by
    itself."""
    from meshio.vtu import _vtu

    order = {"LittleEndian": "<", "BigEndian": ">"}.get(reader.byte_order, "=")
    head = _vtu.vtu_to_numpy_type[reader.header_type].newbyteorder(order)
    chars = 4 * -(-head.itemsize // 3)
    start = base64.b64decode(text[:chars])
    size = int(np.frombuffer(start[: head.itemsize], head)[0])
    if text[chars - 1] == "=" or head.itemsize % 3 == 0:
        data = base64.b64decode(text[chars : chars + 4 * -(-size // 3)])
    else:
        data = base64.b64decode(text[: 4 * -(-(head.itemsize + size) // 3)])[head.itemsize :]
    return np.frombuffer(data[:size], dtype=dtype.newbyteorder(order))


def raw_mesh(path: str, file_format: Optional[str] = None) -> Any:
    """meshio's own mesh of a file. Raises FormatError, FileNotFoundError."""
    meshio = module()
    if not os.path.exists(path):
        raise FileNotFoundError(f"no such file: {path}")
    try:
        return meshio.read(path, file_format)
    except (Exception, SystemExit) as error:  # meshio raises what its readers happen to raise
        raise FormatError(f"{path}: {error or 'not readable'}", path) from error


def read_mesh(path: str, groups_of_arrays: bool = False, file_format: Optional[str] = None) -> Mesh:
    """The points, cells and sets of a file that meshio knows. groups_of_arrays: arrays of 0 and 1
    on cells or points are groups. Raises FormatError, FileNotFoundError."""
    raw = raw_mesh(path, file_format)
    return mesh_of_meshio(path, raw, _flagged(raw) if groups_of_arrays else None)


def mesh_of_meshio(path: str, raw: Any, groups: Optional[Dict[str, Any]] = None) -> Mesh:
    """A Mesh of meshio's: its sets, and these groups. Sets of single points are groups of nodes.
    Raises FormatError where there are cells that have no name here."""
    cells: Dict[str, List[np.ndarray]] = {}
    for block in raw.cells:
        if block.type in CELL_TYPES:
            cells.setdefault(block.type, []).append(np.asarray(block.data))
        elif block.type != "vertex":
            raise FormatError(f"{path}: {block.type} cells are not known here", path)
    points = np.zeros((len(raw.points), 3))
    points[:, : raw.points.shape[1]] = raw.points
    found: Dict[str, Any] = {
        name: ("node", np.asarray(indices)) for name, indices in (raw.point_sets or {}).items()
    }
    found.update(groups or {})
    for name, per_block in (raw.cell_sets or {}).items():
        members = [i if i is not None else [] for i in per_block]
        nodes = [
            np.asarray(block.data)[np.asarray(indices, dtype=np.int64)].ravel()
            for block, indices in zip(raw.cells, members)
            if block.type == "vertex" and len(indices)
        ]
        parts: Dict[str, np.ndarray] = {"node": np.concatenate(nodes)} if nodes else {}
        parts.update(_by_type(raw, members))
        for kind, indices in parts.items():
            found.setdefault(name if len(parts) == 1 else f"{name}_{kind}", (kind, indices))
    return Mesh(points, {name: np.concatenate(parts) for name, parts in cells.items()}, found)


def _by_type(raw: Any, per_block: Any) -> Dict[str, np.ndarray]:
    """cell name -> indices among the cells of the type, of indices in each block."""
    start: Dict[str, int] = {}
    found: Dict[str, List[np.ndarray]] = {}
    for block, indices in zip(raw.cells, per_block):
        first = start.get(block.type, 0)
        start[block.type] = first + len(block.data)
        if len(indices) and block.type in CELL_TYPES:
            found.setdefault(block.type, []).append(np.asarray(indices, dtype=np.int64) + first)
    return {kind: np.concatenate(parts) for kind, parts in found.items()}


def _flagged(raw: Any) -> Dict[str, Any]:
    """Arrays that hold nothing but 0 and 1 as groups."""
    groups: Dict[str, Any] = {}
    for name, values in (raw.point_data or {}).items():
        if _is_flags([values]):
            groups[name] = ("node", np.flatnonzero(values))
    for name, arrays in (raw.cell_data or {}).items():
        if _is_flags(arrays):
            parts = _by_type(raw, [np.flatnonzero(values) for values in arrays])
            for kind, indices in parts.items():
                groups[name if len(parts) == 1 else f"{name}_{kind}"] = (kind, indices)
    return groups


def _is_flags(arrays: Any) -> bool:
    arrays = [np.asarray(values) for values in arrays]
    whole = all(values.dtype.kind in "iu" and values.size == len(values) for values in arrays)
    return whole and all(np.isin(values, (0, 1)).all() for values in arrays)
