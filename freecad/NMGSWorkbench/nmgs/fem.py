# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes for FreeCAD's FEM workbench: nmgs.to_fem. FreeCAD is imported when it is used."""

from __future__ import annotations

from typing import Any, Callable, Optional

from .mesh import Mesh

__all__ = ["to_fem"]


def to_fem(
    mesh: Mesh,
    document: Any = None,
    name: str = "Mesh",
    analysis: Optional[Any] = None,
    progress: Optional[Callable[[float], Any]] = None,
) -> Any:
    """Adds a Fem::FemMeshObject with the mesh to a document, the active one (or a new one) if none.

    Nodes, cells and groups keep their order and names. A volume mesh gets all faces of its
    boundary, which constraints on picked faces need. analysis: a Fem::FemAnalysis that takes the
    mesh; ValueError when it has one already. progress: called with the finished fraction every few
    hundredths of a second, False stops; without it a window shows a dialog and stays alive.
    Raises ValueError, TypeError, Cancelled; the document is then as it was.
    """
    import FreeCAD

    # Not above: they import this package themselves.
    from ..fem import ask
    from ..fem.fem_mesh import fem_mesh
    from ..objects.run import run  # the window's dialog where there is one

    if not isinstance(mesh, Mesh):
        raise TypeError(f"mesh: expected an nmgs.Mesh, got {type(mesh).__name__}")
    if analysis is not None:
        meshes = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemMeshObject")]
        if meshes:
            raise ValueError(f"analysis: {analysis.Label} has a mesh already, {meshes[0].Label}")
    if progress is not None:
        prepared = fem_mesh(mesh, progress)
    else:
        prepared = run(lambda shown: fem_mesh(mesh, shown), "Making the FEM mesh")
    ask.watch()
    if document is None:
        document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
    obj = document.addObject("Fem::FemMeshObject", name)
    obj.FemMesh = prepared
    if analysis is not None:
        analysis.addObject(obj)
    return obj
