# SPDX-License-Identifier: LGPL-2.1-or-later
"""What StructuredMesh and TetGenMesh share: a FEM mesh with its figures."""

from __future__ import annotations

from typing import Any, Optional

from .. import nmgs
from ..fem.fem_mesh import fem_mesh
from ..fem.from_fem_mesh import mesh_of
from ..nmgs.mesh import CELL_TYPES
from .base import DocumentObject

FIGURES = (
    ("App::PropertyInteger", "NodeCount", "Figures", "Number of nodes", None, 1),
    (
        "App::PropertyInteger",
        "ElementCount",
        "Figures",
        "Number of elements, those of the boundary not counted",
        None,
        1,
    ),
    ("App::PropertyStringList", "Elements", "Figures", "Number of elements of each type", None, 1),
    (
        "App::PropertyFloat",
        "WorstScaledJacobian",
        "Figures",
        "Smallest scaled Jacobian of all elements: 1 is ideal, 0 or less unusable",
        None,
        1,
    ),
)


class MeshObject(DocumentObject):
    """Base; a subclass writes make_mesh(obj) -> nmgs.Mesh."""

    _mesh: Optional[nmgs.Mesh] = None

    def make_mesh(self, obj: Any) -> nmgs.Mesh:
        raise NotImplementedError

    def compute(self, obj: Any) -> None:
        self.put(obj, self.make_mesh(obj))

    def put(self, obj: Any, mesh: nmgs.Mesh) -> None:
        """Makes the mesh obj's own, with its figures."""
        worst = worst_scaled_jacobian(mesh)
        obj.FemMesh = fem_mesh(mesh)
        obj.NodeCount = len(mesh.points)
        top = max((CELL_TYPES[name][1] for name in mesh.cells), default=0)
        counts = {
            name: len(nodes) for name, nodes in mesh.cells.items() if CELL_TYPES[name][1] == top
        }
        obj.ElementCount = sum(counts.values())
        obj.Elements = [f"{name}: {count}" for name, count in counts.items()]
        obj.WorstScaledJacobian = worst
        self._mesh = mesh

    def mesh(self, obj: Any) -> nmgs.Mesh:
        """The mesh that the document holds, as the console API's type."""
        if self._mesh is None:
            self._mesh = mesh_of(obj.FemMesh)
        return self._mesh

    def onChanged(self, obj: Any, prop: str) -> None:
        if prop == "FemMesh":
            self._mesh = None


def worst_scaled_jacobian(mesh: nmgs.Mesh) -> float:
    """The smallest of all elements; 0 for a mesh without elements that have one."""
    if not hasattr(mesh, "quality"):
        return 0.0
    worst = [values.min() for values in mesh.quality().values() if len(values)]
    return float(min(worst)) if worst else 0.0
