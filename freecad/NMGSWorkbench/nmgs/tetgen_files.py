# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen's own files: .node, .poly, .smesh; .ele, .face, .edge, .neigh; .face.gid, .ele.gid.

The lists of cells need the .node of the same name beside them. An .ele takes the boundary of a
.face beside it along; writing an .ele writes that .node too. Numbers start at 1 unless first=0.
"""

from __future__ import annotations

import os
from typing import Any, Dict, Tuple

import numpy as np

from . import _kernel
from .errors import FormatError
from .mesh import Group, Mesh
from .plc import PLC
from .tetgen.sources import TO_TETGEN, plc_of_surface

#: VTK's mid-nodes out of TetGen's: the inverse of TO_TETGEN.
TO_VTK = list(np.argsort(TO_TETGEN))


def read_node(path: str) -> PLC:
    """The points, attributes and markers as a PLC without facets."""
    return PLC.of_arrays(_kernel.core().read_node(path)[0])


def read_poly(path: str) -> PLC:
    """The PLC; holes in facets, holes, regions and markers included."""
    return PLC.of_arrays(_kernel.core().read_poly(path))


def read_smesh(path: str) -> PLC:
    """As read_poly, of a file with one polygon a facet."""
    return PLC.of_arrays(_kernel.core().read_smesh(path))


def write_node(path: str, source: Any, first: int = 1) -> None:
    """The points of a PLC or Mesh, or (N, 3) points."""
    _kernel.core().write_node(path, _points_only(source), first)


def write_poly(path: str, source: Any, first: int = 1) -> None:
    """A PLC, or the faces of a surface Mesh."""
    _kernel.core().write_poly(path, as_plc(source), first)


def write_smesh(path: str, source: Any, first: int = 1) -> None:
    """As write_poly. Raises ValueError when a facet has several polygons or holes."""
    _kernel.core().write_smesh(path, as_plc(source), first)


def as_plc(source: Any) -> PLC:
    """A PLC as it is; the faces of a Mesh as one. Raises ValueError."""
    if isinstance(source, PLC):
        return source
    if isinstance(source, Mesh):
        return plc_of_surface(source)
    raise ValueError(f"obj: expected a PLC or a Mesh with faces, got {type(source).__name__}")


def _points_only(source: Any) -> PLC:
    if isinstance(source, PLC):
        return PLC(
            source.points,
            (),
            point_markers=source.point_markers,
            point_attributes=source.point_attributes,
        )
    if isinstance(source, Mesh):
        data = getattr(source, "tetgen", None)
        return PLC(
            source.points,
            (),
            point_markers=None if data is None else data.point_markers,
            point_attributes=None if data is None else data.point_attributes,
        )
    return PLC(source, ())


def _beside(path: str, extension: str) -> str:
    return os.path.splitext(path)[0] + extension


def _nodes_of(path: str) -> Tuple[np.ndarray, int]:
    node = _beside(path, ".node")
    if not os.path.isfile(node):
        if not os.path.isfile(path):
            raise FileNotFoundError(f"no such file: {path}")
        raise FormatError(f"{path}: its points are missing, expected {node}", path)
    arrays, first = _kernel.core().read_node(node)
    return arrays["points"], first


def _marker_groups(prefix: str, kind: str, values: np.ndarray) -> Dict[str, Group]:
    return {
        f"{prefix}{value:g}": (kind, np.flatnonzero(values == value))
        for value in np.unique(values)
        if value != 0
    }


def read_ele(path: str) -> Mesh:
    """Tetrahedra, the triangles of the .face beside them, and groups of attributes and markers."""
    points, first = _nodes_of(path)
    rows = _kernel.core().read_cells(path, "ele", first, len(points))
    kind = "tetra" if rows["nodes"].shape[1] == 4 else "tetra10"
    nodes = rows["nodes"] if kind == "tetra" else rows["nodes"][:, TO_VTK]
    mesh = Mesh(points, {kind: nodes})
    if "attributes" in rows:
        mesh.groups.update(_marker_groups("Region", kind, rows["attributes"][:, -1]))
    if os.path.isfile(_beside(path, ".face")):
        _add_list(mesh, _beside(path, ".face"), "face", first)
    return mesh


def _add_list(mesh: Mesh, path: str, name: str, first: int) -> None:
    rows = _kernel.core().read_cells(path, name, first, len(mesh.points))
    kinds = {"face": {3: "triangle", 6: "triangle6"}, "edge": {2: "line", 3: "line3"}}[name]
    kind = kinds[rows["nodes"].shape[1]]
    mesh.cells[kind] = rows["nodes"]
    if "markers" in rows:
        prefix = "Facet" if name == "face" else "Edge"
        mesh.groups.update(_marker_groups(prefix, kind, rows["markers"]))


def read_face(path: str) -> Mesh:
    """Triangles, with a group for each marker."""
    points, first = _nodes_of(path)
    mesh = Mesh(points, {})
    _add_list(mesh, path, "face", first)
    return mesh


def read_edge(path: str) -> Mesh:
    """Lines, with a group for each marker."""
    points, first = _nodes_of(path)
    mesh = Mesh(points, {})
    _add_list(mesh, path, "edge", first)
    return mesh


def read_neigh(path: str) -> np.ndarray:
    """int32 (M, 4): for each corner of each tetrahedron the one opposite to it, -1 for none."""
    first = 1
    if os.path.isfile(_beside(path, ".node")):
        first = _kernel.core().read_node(_beside(path, ".node"))[1]
    return _kernel.core().read_cells(path, "neigh", first, 0)["nodes"]


def _cells(mesh: Any, *kinds: str) -> Tuple[str, np.ndarray]:
    if isinstance(mesh, Mesh):
        for kind in kinds:
            if kind in mesh.cells:
                return kind, mesh.cells[kind]
    raise ValueError(f"obj: expected a Mesh with {' or '.join(kinds)} cells, got {mesh!r}")


def _numbers_of_groups(mesh: Mesh, kind: str, count: int) -> Any:
    """A number a cell from the groups of cells: the one in "Facet7", else the group's place."""
    names = [name for name, (of, _) in mesh.groups.items() if of == kind]
    if not names:
        return None
    numbers = np.zeros(count, np.int32)
    digits = [name[len(name.rstrip("0123456789")) :] for name in names]
    own = all(digits) and len(set(digits)) == len(digits)
    for place, name in enumerate(names):
        numbers[mesh.groups[name][1]] = int(digits[place]) if own else place + 1
    return numbers


def write_ele(path: str, mesh: Any, first: int = 1) -> None:
    """The tetrahedra, with their groups as attribute, and the points in the .node beside."""
    kind, nodes = _cells(mesh, "tetra", "tetra10")
    numbers = _numbers_of_groups(mesh, kind, len(nodes))
    attributes = None if numbers is None else numbers[:, None].astype(np.float64)
    write_node(_beside(path, ".node"), mesh, first)
    order = nodes if kind == "tetra" else nodes[:, TO_TETGEN]
    _kernel.core().write_cells(path, "ele", order, attributes, None, first)


def write_face(path: str, mesh: Any, first: int = 1) -> None:
    """The triangles with their groups as markers; the points belong into the .node beside."""
    kind, nodes = _cells(mesh, "triangle", "triangle6")
    markers = _numbers_of_groups(mesh, kind, len(nodes))
    _kernel.core().write_cells(path, "face", nodes, None, markers, first)


def write_edge(path: str, mesh: Any, first: int = 1) -> None:
    """The lines with their groups as markers; the points belong into the .node beside."""
    kind, nodes = _cells(mesh, "line", "line3")
    markers = _numbers_of_groups(mesh, kind, len(nodes))
    _kernel.core().write_cells(path, "edge", nodes, None, markers, first)


def write_neigh(path: str, mesh: Any, first: int = 1) -> None:
    """The neighbours that TetGen gave with -n, or an int array (M, 4)."""
    rows = mesh
    if isinstance(mesh, Mesh):
        rows = getattr(getattr(mesh, "tetgen", None), "neighbours", None)
        if rows is None:
            raise ValueError("obj: the mesh has no neighbours; mesh with the switch -n")
    _kernel.core().write_cells(path, "neigh", rows, None, None, first)


def _read_gid(path: str, kinds: Dict[int, str]) -> Mesh:
    points, nodes = _kernel.core().read_gid(path)
    kind = kinds.get(nodes.shape[1])
    if kind is None:
        found = f"{nodes.shape[1]} nodes a cell"
        raise FormatError(
            f"{path}: expected {' or '.join(kinds.values())} cells, found {found}", path
        )
    return Mesh(points, {kind: nodes})


def read_face_gid(path: str) -> Mesh:
    """Triangles (thesis, Table C.9)."""
    return _read_gid(path, {3: "triangle", 6: "triangle6"})


def read_ele_gid(path: str) -> Mesh:
    """Tetrahedra (thesis, Table C.10)."""
    return _read_gid(path, {4: "tetra", 10: "tetra10"})


def write_face_gid(path: str, mesh: Any) -> None:
    """The triangles and all points (thesis, Table C.9)."""
    _kernel.core().write_gid(path, mesh.points, _cells(mesh, "triangle", "triangle6")[1])


def write_ele_gid(path: str, mesh: Any) -> None:
    """The tetrahedra and all points (thesis, Table C.10)."""
    _kernel.core().write_gid(path, mesh.points, _cells(mesh, "tetra", "tetra10")[1])
