# SPDX-License-Identifier: LGPL-2.1-or-later
"""ImportedMesh: a mesh that was read from a file and follows nothing."""

from __future__ import annotations

from typing import Any

from .. import nmgs
from .mesh_base import FIGURES, MeshObject, with_model


class ImportedMesh(MeshObject):
    """Proxy of a Fem::FemMeshObjectPython; a recompute leaves the mesh as it is."""

    view = ("imported_mesh", "ImportedMeshView")
    properties = (
        ("App::PropertyString", "File", "Mesh", "File that the mesh was read from", None, 1),
        (
            "App::PropertyLink",
            "Blocks",
            "Mesh",
            "The blocks or patches that the file says the mesh was made of",
            None,
            0,
        ),
        *FIGURES,
    )

    def mesh(self, obj: Any) -> nmgs.Mesh:
        return with_model(super().mesh(obj), obj.Blocks)

    def compute(self, obj: Any) -> None:
        """Nothing to follow, nothing to do."""


def make(document: Any, mesh: nmgs.Mesh, name: str = "Mesh") -> Any:
    """A new ImportedMesh object that holds the mesh."""
    obj = document.addObject("Fem::FemMeshObjectPython", name)
    ImportedMesh(obj).put(obj, mesh)
    return obj
