# SPDX-License-Identifier: LGPL-2.1-or-later
"""read and write by extension. A format adds one row; its module is imported when it is used."""

from __future__ import annotations

import importlib
import os
from typing import Any, Dict, Optional, Tuple

from .block_model import BlockModel
from .mesh import Mesh

#: format name -> (module beside this one, reader or "", writer or "")
FORMATS: Dict[str, Tuple[str, str, str]] = {
    "inp": ("abaqus_file", "read_inp", "write_inp"),
    "vtk": ("vtk_file", "read_vtk", "write_vtk"),
    "vtu": ("vtk_file", "read_vtk", "write_vtu"),
    "msh": ("gmsh_file", "read_msh", "write_msh41"),
    "msh22": ("gmsh_file", "read_msh", "write_msh22"),
    "msh41": ("gmsh_file", "read_msh", "write_msh41"),
    "unv": ("unv_file", "read_unv", "write_unv"),
    "su2": ("su2_file", "read_su2", "write_su2"),
    "elmer": ("elmer_files", "read_elmer", "write_elmer"),
    "gid": ("gid_file", "read_gid", "write_gid"),
    "post.msh": ("gid_file", "read_gid", "write_gid"),
    "med": ("med_file", "read_med", "write_med"),
    "polymesh": ("openfoam_files", "read_polymesh", "write_polymesh"),
    "blockmeshdict": ("blockmesh_file", "", "write_blockmesh"),
    "n2s": ("nmgs_files", "read_n2s", "write_n2s"),
    "n3s": ("nmgs_files", "read_n3s", "write_n3s"),
    "n2r": ("nmgs_files", "read_n2r", "write_n2r"),
    "n3r": ("nmgs_files", "read_n3r", "write_n3r"),
    "node": ("tetgen_files", "read_node", "write_node"),
    "poly": ("tetgen_files", "read_poly", "write_poly"),
    "smesh": ("tetgen_files", "read_smesh", "write_smesh"),
    "ele": ("tetgen_files", "read_ele", "write_ele"),
    "face": ("tetgen_files", "read_face", "write_face"),
    "edge": ("tetgen_files", "read_edge", "write_edge"),
    "neigh": ("tetgen_files", "read_neigh", "write_neigh"),
    "face.gid": ("tetgen_files", "read_face_gid", "write_face_gid"),
    "ele.gid": ("tetgen_files", "read_ele_gid", "write_ele_gid"),
    "off": ("surface_files", "read_off", "write_off"),
    "stl": ("surface_files", "read_stl", "write_stl"),
    "ply": ("surface_files", "read_surface", "write_ply"),
    "mesh": ("surface_files", "read_medit", ""),
    "obj": ("obj_file", "read_obj", "write_obj"),
    "bdf": ("nastran_file", "read_nastran", "write_nastran"),
    "nas": ("nastran_file", "read_nastran", "write_nastran"),
}


#: Modules whose writers take meshes and nothing else.
_MESHES_ONLY = (
    "abaqus_file",
    "elmer_files",
    "gid_file",
    "gmsh_file",
    "med_file",
    "nastran_file",
    "obj_file",
    "openfoam_files",
    "su2_file",
    "unv_file",
    "vtk_file",
)
#: Formats of files and folders that have a name instead of an extension.
NAMED = ("polymesh", "blockmeshdict")


def _format_of(path: str, format: Optional[str]) -> str:
    if format is not None:
        if format.lower() not in FORMATS:
            raise ValueError(f"format: no such format {format!r}; known: {', '.join(FORMATS)}")
        return format.lower()
    name = os.path.basename(path.rstrip("/" + os.sep)).lower()
    if name in NAMED:
        return name
    # The longest extension wins: "part.face.gid" is of format "face.gid".
    for known in sorted(FORMATS, key=len, reverse=True):
        if name.endswith("." + known):
            return known
    raise ValueError(f"path: cannot tell the format of {path!r}; known: {', '.join(FORMATS)}")


def _function(format: str, which: int) -> Any:
    row = FORMATS[format]
    if not row[which]:
        verb = "read" if which == 1 else "written"
        raise ValueError(f"format: {format!r} cannot be {verb}")
    module = importlib.import_module("." + row[0], __package__)
    return getattr(module, row[which])


def read(path: "str | os.PathLike[str]", format: Optional[str] = None, **options: Any) -> Any:
    """The BlockModel, Mesh or PLC in a file. format: an extension that overrides the path's.

    Raises FormatError (file, line, expected and found), FileNotFoundError, ValueError.
    """
    name = os.fspath(path)
    return _function(_format_of(name, format), 1)(name, **options)


def write(
    path: "str | os.PathLike[str]", obj: Any, format: Optional[str] = None, **options: Any
) -> None:
    """Writes a BlockModel, Mesh or PLC. The file appears whole or not at all.

    Raises ValueError when the format cannot hold the object.
    """
    name = os.fspath(path)
    kind = _format_of(name, format)
    if FORMATS[kind][0] in _MESHES_ONLY and not isinstance(obj, Mesh):
        hint = "; generate() makes one" if isinstance(obj, BlockModel) else ""
        raise ValueError(f"obj: {kind!r} holds a Mesh, got {type(obj).__name__}{hint}")
    _function(kind, 2)(name, obj, **options)
