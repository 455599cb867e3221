# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects into files, by what they hold."""

from __future__ import annotations

import os
import re
from typing import Any, Dict, List, Optional, Sequence, Tuple

from . import nmgs
from .nmgs import io, plot
from .objects.blocks import Blocks
from .objects.mesh_base import MeshObject
from .objects.patches import Patches

#: Formats in the order of the dialog: extension -> what the user reads.
_BLOCK_FORMATS = {"n2s": "NMGS surface patches", "n3s": "NMGS volume blocks"}
_MESH_FORMATS: Dict[str, str] = {
    "n2r": "NMGS surface mesh",
    "n3r": "NMGS volume mesh",
    "inp": "Abaqus and CalculiX input",
    "vtu": "VTK unstructured grid",
    "vtk": "VTK legacy file",
    "msh": "Gmsh mesh",
    "med": "Salome MED",
    "unv": "I-DEAS universal file",
    "bdf": "Nastran bulk data",
    "su2": "SU2 mesh",
    "gid": "GiD mesh",
    "stl": "STL surface",
    "ply": "PLY surface",
    "obj": "Wavefront surface",
    "node": "TetGen points",
    "ele": "TetGen tetrahedra",
    "face.gid": "GiD surface mesh",
    "ele.gid": "GiD volume mesh",
}
_PLC_FORMATS = {
    "poly": "TetGen piecewise linear complex",
    "smesh": "TetGen simple piecewise linear complex",
    "node": "TetGen points",
}


def content(obj: Any) -> Any:
    """What obj holds as the console API's type: BlockModel, Mesh or PLC. Raises TypeError."""
    proxy = getattr(obj, "Proxy", None)
    for method in ("model", "mesh", "plc"):
        if hasattr(proxy, method):
            return getattr(proxy, method)(obj)
    raise TypeError(f"{obj.Label}: expected a mesh, Blocks, Patches or PLC object of NMGS")


def formats(obj: Any) -> List[Tuple[str, str]]:
    """(extension, description) of the formats that can hold obj and have a writer."""
    proxy = getattr(obj, "Proxy", None)
    if isinstance(proxy, Patches):
        known = {"n2s": _BLOCK_FORMATS["n2s"]}
    elif isinstance(proxy, Blocks):
        known = {"n3s": _BLOCK_FORMATS["n3s"]}
    elif isinstance(proxy, MeshObject):
        known = _MESH_FORMATS
    else:
        known = _PLC_FORMATS
    return [
        (name, text) for name, text in known.items() if name in io.FORMATS and io.FORMATS[name][2]
    ]


def filters(obj: Any) -> List[str]:
    """formats(obj) as a file dialog's filters."""
    return [f"{text} (*.{name})" for name, text in formats(obj)]


def write(obj: Any, path: str, chosen_filter: str = "") -> str:
    """Writes obj; adds the chosen filter's extension to a path without one. Returns the path."""
    if not os.path.splitext(path)[1]:
        path = with_extension(path, chosen_filter)
    nmgs.write(path, content(obj))
    return path


def prepared(
    mesh: nmgs.Mesh, order: int = 0, split: bool = False, groups: Optional[Sequence[str]] = None
) -> nmgs.Mesh:
    """The mesh as it is to be written. order: 1, 2, or 0 for as it is. split: into triangles or
    tetrahedra. groups: these alone; None for all. Raises ValueError."""
    if groups is not None:
        kept = {name: mesh.groups[name] for name in groups}
        mesh = nmgs.Mesh(mesh.points, mesh.cells, kept, model=mesh.model)
    quadratic = any(name in plot.LINEAR for name in mesh.cells)
    if quadratic and (order == 1 or split):
        mesh = plot.linear(mesh)
    if split:
        mesh = mesh.split()
    wanted = order or (2 if quadratic else 1)
    return (
        mesh.to_order(2) if wanted == 2 and not any(n in plot.LINEAR for n in mesh.cells) else mesh
    )


def with_extension(path: str, chosen_filter: str) -> str:
    """path with the extension of a filter like "VTK file (*.vtu)", if it names one."""
    extension = re.search(r"\*\.([\w.]+)\)", chosen_filter)
    return f"{path}.{extension.group(1)}" if extension else path


def write_only(objects: Sequence[Any], path: str) -> None:
    """Writes the one object that was picked for File > Export. Raises ValueError otherwise."""
    if len(objects) != 1:
        raise ValueError(f"Pick one object to export; {len(objects)} are picked.")
    write(objects[0], path)
