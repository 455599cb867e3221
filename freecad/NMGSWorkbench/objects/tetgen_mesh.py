# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGenMesh: tetrahedra that TetGen makes of a solid, a PLC, blocks or another mesh."""

from __future__ import annotations

from typing import Any, List, Sequence, Tuple

from .. import nmgs
from . import sources
from .mesh_base import FIGURES, MeshObject
from .run import run


class TetGenMesh(MeshObject):
    """Proxy of a Fem::FemMeshObjectPython that follows its source."""

    view = ("tetgen_mesh", "TetGenMeshView")
    properties = (
        (
            "App::PropertyLinkSubList",
            "Source",
            "Mesh",
            "Solid, PLC, blocks, patches or mesh whose volume is filled",
            None,
            0,
        ),
        ("App::PropertyString", "Switches", "Mesh", "TetGen's switches", "pq", 0),
        (
            "App::PropertyFloatConstraint",
            "TimeLimit",
            "Mesh",
            "Seconds after which TetGen is stopped; 0 for no limit",
            (0.0, 0.0, 1e9, 10.0),
            0,
        ),
        *FIGURES,
    )

    #: What was meshed last.
    _source: Sequence[Tuple[Any, Any]] = ()

    def culprits(self, names: Sequence[str]) -> List[sources.Entity]:
        """The faces of the source's objects that an error names by their place in its shape."""
        wanted = [name for name in names if name.startswith("Face")]
        if not wanted:
            return []
        faces = sources.picked_shape(self._source).Faces
        found = []
        for name in wanted:
            face = faces[int(name[4:]) - 1]
            for owner in dict.fromkeys(owner for owner, _ in self._source):
                own = sources.shape_of(owner).Faces
                found += [(owner, f"Face{n}") for n, f in enumerate(own, 1) if f.isSame(face)]
        return found

    def make_mesh(self, obj: Any) -> nmgs.Mesh:
        if not obj.Source:
            raise ValueError(f"{obj.Label}: Source is empty; choose what TetGen is to fill.")
        self._source = obj.Source
        source = tetgen_source(obj.Source)
        return run(
            lambda progress: nmgs.tetrahedralize(
                source,
                switches=obj.Switches,
                timeout=obj.TimeLimit or None,
                progress=progress,
            ),
            "TetGen is at work",
        )


def tetgen_source(source: Sequence[Tuple[Any, Any]]) -> Any:
    """What nmgs.tetrahedralize takes, of a LinkSubList's value."""
    first = source[0][0]
    proxy = getattr(first, "Proxy", None)
    for method in ("plc", "model"):
        if hasattr(proxy, method):
            return getattr(proxy, method)(first)
    if hasattr(proxy, "mesh"):
        mesh = proxy.mesh(first)
        return mesh if all(name in _SURFACE for name in mesh.cells) else mesh.boundary()
    return sources.picked_shape(source)


_SURFACE = frozenset(("triangle", "triangle6", "quad", "quad8"))


def make(document: Any, name: str = "TetGenMesh") -> Any:
    """A new, empty TetGenMesh object of the document."""
    obj = document.addObject("Fem::FemMeshObjectPython", name)
    TetGenMesh(obj)
    return obj
