# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes for FreeCAD's FEM workbench: nmgs.to_fem. FreeCAD is imported when it is used."""

from __future__ import annotations

from typing import Any, Optional

from ..fem.fem_mesh import fem_mesh
from .mesh import Mesh

__all__ = ["fem_mesh", "to_fem"]


def to_fem(
    mesh: Mesh, document: Any = None, name: str = "Mesh", analysis: Optional[Any] = None
) -> Any:
    """Adds a Fem::FemMeshObject with the mesh to a document, the active one (or a new one) if none.

    analysis: a Fem::FemAnalysis that takes the mesh; ValueError when it has one already.
    Raises ValueError, TypeError.
    """
    import FreeCAD

    if not isinstance(mesh, Mesh):
        raise TypeError(f"mesh: expected an nmgs.Mesh, got {type(mesh).__name__}")
    if analysis is not None:
        meshes = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemMeshObject")]
        if meshes:
            raise ValueError(f"analysis: {analysis.Label} has a mesh already, {meshes[0].Label}")
    prepared = fem_mesh(mesh)
    if document is None:
        document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
    obj = document.addObject("Fem::FemMeshObject", name)
    obj.FemMesh = prepared
    if analysis is not None:
        analysis.addObject(obj)
    return obj
