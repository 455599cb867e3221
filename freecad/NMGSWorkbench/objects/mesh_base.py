# SPDX-License-Identifier: LGPL-2.1-or-later
"""What StructuredMesh and TetGenMesh share: a FEM mesh with its figures."""

from __future__ import annotations

import hashlib
from typing import Any, Dict, Optional

import FreeCAD
import numpy as np

from .. import nmgs
from ..fem import ask
from ..fem.fem_mesh import fem_mesh
from ..fem.from_fem_mesh import mesh_of
from ..nmgs.mesh import CELL_TYPES
from . import mesh_store, preferences
from .base import DocumentObject
from .run import run

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
    (
        "App::PropertyFileIncluded",
        "Data",
        "Mesh",
        "The mesh while FemMesh is empty: it is large, and FEM has not asked for it yet",
        None,
        2,
    ),
    ("App::PropertyString", "Content", "Figures", "Hash of the mesh", None, 2),
)
#: Ends Content while that is so.
_HELD = ":held"


#: Earlier meshes that are kept for undo: at most so many of an object, and so many bytes.
_KEPT_MESHES = 20
_KEPT_BYTES = 1 << 28


ask.watch()
_NOTHING = nmgs.Mesh(np.zeros((0, 3)), {})


class MeshObject(DocumentObject):
    """Base; a subclass writes make_mesh(obj) -> nmgs.Mesh.

    FreeCAD 0.20 overwrites a FemMesh in place, so that undo brings back every property but this
    one. Content, a hash of the mesh, is brought back; what it is the hash of is kept here.
    """

    _mesh: Optional[nmgs.Mesh] = None
    #: Content of what FemMesh holds.
    _shown = ""
    _kept: Optional[Dict[str, nmgs.Mesh]] = None

    def make_mesh(self, obj: Any) -> nmgs.Mesh:
        raise NotImplementedError

    def compute(self, obj: Any) -> None:
        self.put(obj, self.make_mesh(obj))

    def put(self, obj: Any, mesh: nmgs.Mesh) -> None:
        """Makes the mesh obj's own, with its figures."""
        cells = sum(len(nodes) for nodes in mesh.cells.values())
        # FreeCAD's view of a FemMesh holds the window up for about 10 s a million elements.
        late = FreeCAD.GuiUp and cells > preferences.most_filled()
        # Off the main thread, as all that takes long.
        worst, shown, prepared = run(
            lambda progress: (
                worst_scaled_jacobian(mesh),
                hash_of(mesh),
                fem_mesh(mesh if not late else _NOTHING, progress),
            ),
            "Handing the mesh over",
        )
        if self._shown and self._shown not in (self._kept or {}):
            self._keep(self._shown, self.mesh(obj))
        obj.FemMesh = prepared
        if late:
            mesh_store.put(obj, "Data", mesh)
            shown += _HELD
        elif obj.Data:
            obj.Data = ""
        obj.NodeCount = len(mesh.points)
        top = max((CELL_TYPES[name][1] for name in mesh.cells), default=0)
        counts = {
            name: len(nodes) for name, nodes in mesh.cells.items() if CELL_TYPES[name][1] == top
        }
        obj.ElementCount = sum(counts.values())
        obj.Elements = [f"{name}: {count}" for name, count in counts.items()]
        obj.WorstScaledJacobian = worst
        self._mesh = mesh
        self._shown = shown
        self._keep(self._shown, mesh)
        obj.Content = self._shown

    def mesh(self, obj: Any) -> nmgs.Mesh:
        """The mesh that the document holds, as the console API's type."""
        if self._mesh is None:
            self._mesh = mesh_store.get(obj.Data) if obj.Data else mesh_of(obj.FemMesh)
        return self._mesh

    def fill(self, obj: Any) -> None:
        """Fills FemMesh where that was put off: FEM asks for it."""
        if not obj.Data:
            return
        mesh = self.mesh(obj)
        obj.FemMesh = run(lambda progress: fem_mesh(mesh), "Handing the mesh to FEM")
        obj.Data = ""
        self._mesh = mesh
        self._shown = obj.Content.replace(_HELD, "")
        self._keep(self._shown, mesh)
        obj.Content = self._shown

    def onChanged(self, obj: Any, prop: str) -> None:
        if prop in ("FemMesh", "Data"):
            self._mesh = None
        elif prop == "Content" and self._shown and obj.Content != self._shown:
            self._bring_back(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        super().onDocumentRestored(obj)
        self._shown = obj.Content

    def _keep(self, content: str, mesh: nmgs.Mesh) -> None:
        kept = self._kept = self._kept or {}
        kept.pop(content, None)
        kept[content] = mesh
        while len(kept) > 1 and (
            len(kept) > _KEPT_MESHES or sum(size_of(mesh) for mesh in kept.values()) > _KEPT_BYTES
        ):
            del kept[next(iter(kept))]

    def _bring_back(self, obj: Any) -> None:
        """After undo, redo or abort: the mesh that the other properties tell of."""
        mesh = (self._kept or {}).get(obj.Content)
        if mesh is None:
            # Too old or too large to have been kept; the next recompute makes it again.
            obj.touch()
            return
        self._shown = obj.Content
        obj.FemMesh = fem_mesh(_NOTHING if obj.Content.endswith(_HELD) else mesh)
        self._mesh = mesh


def with_model(mesh: nmgs.Mesh, blocks: Any) -> nmgs.Mesh:
    """The mesh; one out of a document gets its blocks back."""
    if mesh.model is None and blocks is not None:
        mesh.model = blocks.Proxy.model(blocks)
    return mesh


def hash_of(mesh: nmgs.Mesh) -> str:
    """The same for the same points, cells and groups."""
    digest = hashlib.blake2b(mesh.points.tobytes(), digest_size=16)
    for name, nodes in sorted(mesh.cells.items()):
        digest.update(name.encode())
        digest.update(nodes.tobytes())
    for name, (kind, indices) in sorted(mesh.groups.items()):
        digest.update(f"{name}\n{kind}\n".encode())
        digest.update(indices.tobytes())
    return digest.hexdigest()


def size_of(mesh: nmgs.Mesh) -> int:
    """Bytes of the mesh's arrays."""
    groups = sum(indices.nbytes for _, indices in mesh.groups.values())
    return mesh.points.nbytes + sum(nodes.nbytes for nodes in mesh.cells.values()) + groups


def worst_scaled_jacobian(mesh: nmgs.Mesh) -> float:
    """The smallest of all elements; 0 for a mesh without elements that have one."""
    worst = [values.min() for values in mesh.quality().values() if len(values)]
    return float(min(worst)) if worst else 0.0
