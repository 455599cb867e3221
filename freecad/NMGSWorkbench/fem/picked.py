# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes and faces of picked CAD entities by the mesh's groups, without a search in space.

FEM finds the nodes on a picked face by the distance of every node from it. Groups named FaceN,
EdgeN, VertexN, SolidN know them; a group is believed where its cells do cover the entity.
"""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ..nmgs.abaqus_file import SOLID_FACES
from .fem_mesh import NODE_ORDER

#: A group is taken for the whole of a face or edge when area or length agree this well. Elements
#: with straight sides on a curved face have a little less of it.
_COVERS = 0.1
#: How far a group's node may be off its entity, of the entity's diagonal: straight mid-sides are.
_OFF = 0.02

_CORNERS = {3: 3, 6: 3, 4: 4, 8: 4}


def _ccx_sides() -> Dict[int, List[Tuple[int, ...]]]:
    """Nodes of a volume -> the corners of CalculiX's faces 1, 2, ... by FemMesh's places."""
    result = {}
    for name, order in NODE_ORDER.items():
        sides = SOLID_FACES[name]
        if None not in sides:  # pyramids are unknown to CalculiX
            place = {abaqus: fem for fem, abaqus in enumerate(order)}
            result[len(order)] = [tuple(place[k] for k in side) for side in sides]
    return result


_CCX_SIDES = _ccx_sides()


class MeshByGroups:
    """A Fem.FemMesh whose nodes and faces on CAD entities come from its groups where it has them;
    all else is FemMesh's own. references: (document object, names of its entities), those that
    constraints name."""

    def __init__(self, fem_mesh: Any, references: Any):
        self._mesh = fem_mesh
        self._group: Dict[str, int] = {fem_mesh.getGroupName(g): g for g in fem_mesh.Groups}
        self._named: List[Tuple[Any, str]] = []
        for part, names in references:
            for name in names if isinstance(names, (list, tuple)) else [names]:
                if name in self._group:
                    self._named.append((_global(part, part.Shape.getElement(name)), name))
        self._nodes: Dict[int, Any] = fem_mesh.Nodes if self._named else {}
        self._believed: Dict[int, bool] = {}
        #: Names of the entities that were found by group.
        self.found: List[str] = []

    def __getattr__(self, name: str) -> Any:
        return getattr(self._mesh, name)

    def getNodesByFace(self, shape: Any) -> Any:  # names as FemMesh has them
        return self._nodes_of(shape) or self._mesh.getNodesByFace(shape)

    def getNodesByEdge(self, shape: Any) -> Any:
        return self._nodes_of(shape) or self._mesh.getNodesByEdge(shape)

    def getNodesByVertex(self, shape: Any) -> Any:
        return self._nodes_of(shape) or self._mesh.getNodesByVertex(shape)

    def getFacesByFace(self, shape: Any) -> Any:
        group = self._group_of(shape)
        if group is None or self._mesh.getGroupElementType(group) != "Face":
            return self._mesh.getFacesByFace(shape)
        return sorted(self._mesh.getGroupElements(group))

    def getccxVolumesByFace(self, shape: Any) -> Any:
        """[(volume, number of its face as CalculiX counts)], for pressures."""
        group = self._group_of(shape)
        if group is None or self._mesh.getGroupElementType(group) != "Face":
            return self._mesh.getccxVolumesByFace(shape)
        faces = set()
        for face in self._mesh.getGroupElements(group):
            nodes = self._mesh.getElementNodes(face)
            faces.add(frozenset(nodes[: _CORNERS[len(nodes)]]))
        on = frozenset().union(*faces)
        found = []
        for volume in self._mesh.Volumes:
            nodes = self._mesh.getElementNodes(volume)
            if len(on.intersection(nodes)) < 3 or len(nodes) not in _CCX_SIDES:
                continue
            for number, side in enumerate(_CCX_SIDES[len(nodes)], 1):
                if frozenset(nodes[k] for k in side) in faces:
                    found.append((volume, number))
        return found

    def _nodes_of(self, shape: Any) -> List[int]:
        group = self._group_of(shape)
        if group is None:
            return []
        members = self._mesh.getGroupElements(group)
        if self._mesh.getGroupElementType(group) == "Node":
            return sorted(members)
        element_nodes = self._mesh.getElementNodes
        return sorted({node for member in members for node in element_nodes(member)})

    def _group_of(self, shape: Any) -> Optional[int]:
        for at, (known, name) in enumerate(self._named):
            if known.isSame(shape) or _alike(known, shape):
                if at not in self._believed:
                    self._believed[at] = self._covers(self._group[name], shape)
                    if self._believed[at]:
                        self.found.append(name)
                return self._group[name] if self._believed[at] else None
        return None

    def _covers(self, group: int, shape: Any) -> bool:
        """Whether the group's cells lie on the entity, and cover it."""
        members = self._mesh.getGroupElements(group)
        kind = self._mesh.getGroupElementType(group)
        if not members or kind not in ("Node", "Edge", "Face"):
            return False
        if kind == "Node":
            return self._nodes_cover(members, shape)
        cells = [self._mesh.getElementNodes(member) for member in members]
        sample = [cells[i][0] for i in {0, len(cells) // 2, len(cells) - 1}]
        if not self._is_on(sample, shape):
            return False
        measured, wanted = 0.0, shape.Area if kind == "Face" else shape.Length
        for size in {len(cell) for cell in cells}:
            rows = np.array([cell for cell in cells if len(cell) == size])
            measured += self._measure(rows, kind, size)
        return abs(measured - wanted) <= _COVERS * wanted

    def _nodes_cover(self, members: Any, shape: Any) -> bool:
        nodes = list(members)
        if shape.ShapeType == "Vertex":
            return len(nodes) == 1 and self._is_on(nodes, shape)
        if shape.ShapeType != "Edge" or len(nodes) < 2:
            return False
        if not self._is_on([nodes[0], nodes[len(nodes) // 2], nodes[-1]], shape):
            return False
        points = np.array([tuple(self._nodes[n]) for n in nodes])
        along = np.array([tuple(p) for p in shape.discretize(9)])
        nearest = np.linalg.norm(along[:, None] - points[None], axis=2).min(axis=1)
        return bool(nearest.max() <= shape.Length / (len(nodes) - 1))

    def _measure(self, rows: np.ndarray, kind: str, size: int) -> float:
        corners = rows[:, : 2 if kind == "Edge" else _CORNERS[size]]
        used, place = np.unique(corners, return_inverse=True)
        points = np.array([tuple(self._nodes[n]) for n in used.tolist()])
        p = points[place.reshape(corners.shape)]
        if kind == "Edge":
            return float(np.linalg.norm(p[:, 1] - p[:, 0], axis=1).sum())
        if corners.shape[1] == 3:
            across = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        else:
            across = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
        return float(np.linalg.norm(across, axis=1).sum() / 2)

    def _is_on(self, nodes: Any, shape: Any) -> bool:
        import Part

        limit = _OFF * max(shape.BoundBox.DiagonalLength, 1e-6)
        return all(shape.distToShape(Part.Vertex(self._nodes[node]))[0] <= limit for node in nodes)


def _global(part: Any, element: Any) -> Any:
    """Where the element is in the document, as the mesh is."""
    moved = part.getGlobalPlacement().multiply(part.Placement.inverse())
    if moved.isIdentity():
        return element
    placed = element.copy()
    placed.Placement = moved.multiply(placed.Placement)
    return placed


def _alike(a: Any, b: Any) -> bool:
    """Whether two entities lie in one place: FreeCAD 1.0 hands FEM a copy in global coordinates."""
    if a.ShapeType != b.ShapeType:
        return False
    limit = 1e-7 * max(a.BoundBox.DiagonalLength, 1.0)
    if a.ShapeType == "Vertex":
        return bool(a.Point.distanceToPoint(b.Point) <= limit)
    return (
        a.CenterOfMass.distanceToPoint(b.CenterOfMass) <= limit
        and abs(a.Length - b.Length) <= 10 * limit
        and abs(a.Area - b.Area) <= 1e-6 * max(a.Area, limit)
    )


def install() -> None:
    """From now on, FEM's input writers ask the groups first, from FEM's own panel as well; once is
    enough. Meshes without such groups are searched as ever."""
    from femmesh import meshsetsgetter

    plain = meshsetsgetter.MeshSetsGetter
    if getattr(plain, "asks_groups", False):
        return

    class GetterByGroups(plain):  # type: ignore[misc, valid-type]
        asks_groups = True

        def __init__(self, analysis: Any, *others: Any):
            super().__init__(analysis, *others)
            references = [
                reference
                for member in analysis.Group
                for reference in getattr(member, "References", None) or []
            ]
            self.femmesh = MeshByGroups(self.femmesh, references)

    # FEM looks the class up in its module at each use; there is no argument for it.
    meshsetsgetter.MeshSetsGetter = GetterByGroups
