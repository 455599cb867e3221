# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks in any solid: TetGen fills a coarse skin, each tetrahedron becomes four hexahedra."""

from __future__ import annotations

import time
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np

from . import _kernel
from .errors import BlockingError, GeometryError, TetGenError
from .plc import PLC
from .tetgen.tetrahedralize import tetrahedralize

#: Name of the strategy.
METHOD = "tet-to-hex"
#: TetGen's switches in the order in which they are tried. -Y: the skin stays as it is; -A: parts
#: of the volume that faces separate get numbers.
SWITCHES = ("pYAq1.6/8", "pYA")
#: Most tetrahedra for one triangle of the skin; more of them come from TetGen's quality alone.
MOST = 12
#: How often the skin is made finer where hexahedra fold or TetGen cannot keep it.
ROUNDS = 5
#: Largest turn of the surface along an edge of the skin, in radians: each is halved, and a cylinder
#: then loses 0.8 % of its volume.
ANGLE = 0.45
#: Seconds after which no further round begins.
PATIENCE = 40.0
#: Seconds for one run of TetGen.
TIMEOUT = 60.0

Progress = Optional[Callable[[float], Any]]


def fill(
    shape: Any, solids: Sequence[int], tolerance: float, progress: Progress = None
) -> Dict[str, Any]:
    """Blocks of the solids (1-based) of a kernel's CadShape, as the kernel's fit() returns them.

    Solids that share faces share nodes. tolerance: blocks are halved until no face of theirs is
    farther than this from its CAD face. Raises BlockingError that names the solids which cannot be
    filled, GeometryError, Cancelled.
    """
    kernel = _kernel.cad()
    faces = {n: kernel.solid_faces(shape, n) for n in solids}
    wanted = sorted({face for rows in faces.values() for face, _ in rows})
    limits = np.empty((0, 5))
    best: Tuple[float, Any] = (-np.inf, None)
    start = time.monotonic()
    vain = 0  # rounds that made nothing better
    for round_ in range(ROUNDS):
        if vain > 1 or (best[1] is not None and time.monotonic() - start > PATIENCE):
            break
        skin = kernel.make_skin(
            shape, wanted, angle=ANGLE, limits=limits, progress=_share(progress, round_, 0)
        )
        tets: List[Tuple[int, np.ndarray, np.ndarray]] = []
        finer: List[np.ndarray] = []
        for n in solids:
            inner, cells, trouble = _tetrahedra(shape, skin, n, faces[n], progress)
            tets.append((n, inner, cells))
            finer.append(trouble)
        where = np.concatenate(finer)
        if not len(where):
            layout = kernel.Layout(shape)
            worst, where = kernel.tets_to_hexas(shape, skin, tets, layout, progress)
            vain = 0 if worst > best[0] else vain + 1
            if worst > best[0]:
                best = (worst, layout)
        if not len(where):
            break
        limits = np.concatenate([limits, where])
    if best[1] is None:
        names = [f"Solid{n}" for n in solids]
        reason = "TetGen cannot fill the skin of " + ", ".join(names)
        raise BlockingError(f"no blocks: {reason}", names, [reason] * len(names))
    return kernel.tet_blocks(shape, best[1], list(solids), tolerance, progress)


def _share(progress: Progress, round_: int, part: int) -> Progress:
    if progress is None:
        return None
    return lambda fraction: progress((round_ + 0.5 * part + 0.5 * fraction) / ROUNDS)


def _tetrahedra(
    shape: Any, skin: Any, solid: int, faces: Sequence[Tuple[int, bool]], progress: Progress
) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Inner points, tetrahedra (in the skin's numbers, then the inner points), and where the skin
    must be finer (x, y, z, radius, size) because TetGen had to put points into it."""
    own = np.isin(skin.faces, [face for face, _ in faces])
    bounding = np.isin(skin.faces, [face for face, bounds in faces if bounds])
    triangles = skin.triangles[own]
    used, local = np.unique(triangles, return_inverse=True)
    local = local.reshape(-1, 3).astype(np.int32)
    plc = PLC(skin.points[used], local, markers=skin.faces[own])
    last: Optional[TetGenError] = None
    nothing = np.empty((0, 3)), np.empty((0, 4), np.int32)
    chosen = None
    for switches in SWITCHES:
        try:
            mesh = tetrahedralize(plc, switches, TIMEOUT, progress)
        except TetGenError as error:
            last = error
            continue
        if len(mesh.cells["tetra"]) > MOST * len(local) + 1000 and switches != SWITCHES[-1]:
            continue
        added = _points_on_skin(mesh, len(used))
        if len(added):
            chosen = chosen if chosen is not None else (mesh, added)
            continue
        chosen = (mesh, added)
        break
    if chosen is None:
        corners = skin.points[used][local]
        facets = last.facets if last is not None else []
        spheres = _spheres(corners[facets] if facets else corners)
        if not facets:  # TetGen does not say where: finer everywhere
            spheres[:, 4] *= 1.4
        return (*nothing, spheres)
    mesh, added = chosen
    if len(added):
        places = mesh.points[added]
        size = _size_near(skin.points[used], local, places)
        return (*nothing, np.column_stack([places, 1.5 * size, 0.5 * size]))
    inside = _inside(mesh, skin.points, skin.triangles[bounding], solid)
    cells = mesh.cells["tetra"][inside]
    number = np.concatenate(
        [used, len(skin.points) + np.arange(len(mesh.points) - len(used))]
    ).astype(np.int32)
    return mesh.points[len(used) :], number[cells], np.empty((0, 5))


def _points_on_skin(mesh: Any, count: int) -> np.ndarray:
    """Nodes of the boundary's triangles that TetGen added."""
    nodes = np.unique(mesh.cells["triangle"])
    return nodes[nodes >= count]


def _spheres(corners: np.ndarray) -> np.ndarray:
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    return np.column_stack([corners.mean(axis=1), longest, 0.5 * longest])


def _size_near(points: np.ndarray, triangles: np.ndarray, places: np.ndarray) -> np.ndarray:
    corners = points[triangles]
    middles = corners.mean(axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    nearest = [int(np.argmin(((middles - p) ** 2).sum(axis=1))) for p in places]
    return longest[nearest]


def _inside(mesh: Any, points: np.ndarray, triangles: np.ndarray, solid: int) -> np.ndarray:
    """Which tetrahedra are in the solid, part by part of what its faces separate."""
    numbers = mesh.tetgen.attributes
    cells = mesh.cells["tetra"]
    if numbers is None:
        return np.ones(len(cells), bool)
    parts = numbers[:, -1]
    p = mesh.points[cells]
    volume = np.abs(np.linalg.det(p[:, 1:] - p[:, :1]))
    kept = np.zeros(len(cells), bool)
    for part in np.unique(parts):
        mine = np.flatnonzero(parts == part)
        centre = p[mine[np.argmax(volume[mine])]].mean(axis=0)
        if _encloses(points[triangles], centre):
            kept[mine] = True
    if not kept.any():
        raise GeometryError(f"Solid{solid} encloses no volume", [f"Solid{solid}"])
    return kept


def _encloses(corners: np.ndarray, place: np.ndarray) -> bool:
    """Odd number of triangles to the outside, in most of some directions."""
    odd = 0
    directions = np.array([[0.93, 0.24, 0.27], [-0.29, -0.93, 0.23], [0.31, -0.22, 0.92]])
    a, u, v = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    s = place - a
    for d in directions:
        h = np.cross(d, v)
        det = (u * h).sum(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            x = (s * h).sum(axis=1) / det
            q = np.cross(s, u)
            y = (q @ d) / det
            t = (v * q).sum(axis=1) / det
            hit = (x >= 0) & (y >= 0) & (x + y <= 1) & (t > 0)
        odd += int(hit.sum()) % 2
    return odd >= 2
