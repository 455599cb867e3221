# SPDX-License-Identifier: LGPL-2.1-or-later
"""StructuredMesh: quads of patches or hexahedra of blocks, as a FEM mesh."""

from __future__ import annotations

from typing import Any

from .. import nmgs
from .mesh_base import FIGURES, MeshObject, with_model
from .run import run


class StructuredMesh(MeshObject):
    """Proxy of a Fem::FemMeshObjectPython that follows its Blocks or Patches."""

    view = ("structured_mesh", "StructuredMeshView")
    properties = (
        ("App::PropertyLink", "Blocks", "Mesh", "Blocks or Patches to divide", None, 0),
        (
            "App::PropertyIntegerConstraint",
            "Order",
            "Mesh",
            "1 for linear elements, 2 for quadratic ones",
            (1, 1, 2, 1),
            0,
        ),
        (
            "App::PropertyBool",
            "Split",
            "Mesh",
            "Quads into 2 triangles, hexahedra into 12 tetrahedra",
            False,
            0,
        ),
        ("App::PropertyBool", "Snap", "Mesh", "Put the nodes onto the CAD surface", True, 0),
        (
            "App::PropertyLength",
            "Tolerance",
            "Mesh",
            "Nodes of different blocks closer than this are one; 0 chooses it",
            None,
            0,
        ),
        *FIGURES,
    )

    def make_mesh(self, obj: Any) -> nmgs.Mesh:
        if obj.Blocks is None:
            raise ValueError(f"{obj.Label}: Blocks is empty; choose the blocks or patches to mesh.")
        model = obj.Blocks.Proxy.model(obj.Blocks)
        # A split mesh gets its mid-side nodes after the split, on the edges of the new elements.
        mesh = run(
            lambda progress: model.generate(
                tolerance=obj.Tolerance.Value or None,
                order=1 if obj.Split else obj.Order,
                snap=obj.Snap,
                progress=progress,
            ),
            "Generating the mesh",
        )
        if obj.Split:
            mesh = mesh.split()
            if obj.Order == 2:
                mesh = mesh.to_order(2)
        return mesh

    def mesh(self, obj: Any) -> nmgs.Mesh:
        return with_model(super().mesh(obj), obj.Blocks)


def make(document: Any, name: str = "StructuredMesh") -> Any:
    """A new, empty StructuredMesh object of the document."""
    obj = document.addObject("Fem::FemMeshObjectPython", name)
    StructuredMesh(obj)
    return obj
