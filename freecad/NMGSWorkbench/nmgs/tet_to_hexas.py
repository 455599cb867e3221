# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks in any solid: TetGen fills a coarse skin, each tetrahedron becomes four hexahedra."""

from __future__ import annotations

import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

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
#: Largest turn of the surface along an edge of the skin, in radians: each is halved, and a cylinder
#: then loses 0.8 % of its volume. Then how much longer triangles may be along than across the
#: curvature, whether tetrahedra are split that would fold on curved faces (and the skin made finer
#: where hexahedra fold nevertheless), and how often the skin may be made finer. The others where
#: the first leads to no sound hexahedra.
ATTEMPTS = ((0.45, 2.5, False, 3), (0.45, 4.0, True, 4), (0.37, 4.0, True, 4), (0.6, 4.0, True, 4))
#: Rounds of one attempt, at most.
MOST_ROUNDS = 4
#: Triangles of a skin that is not made finer.
MOST_TRIANGLES = 30_000
#: Seconds after which no third round begins; twice as many while there is no sound layout.
PATIENCE = 20.0
#: Scaled Jacobian of the mesh from which blocks are left as they are.
SOUND = 0.001
#: Seconds for one run of TetGen, which takes one or two and on some skins never ends.
TIMEOUT = 10.0

Progress = Optional[Callable[[float], Any]]
#: Blocks that a mesh may divide.
FEW = 400


class _Found(NamedTuple):
    """A layout, the worst scaled Jacobian of its hexahedra, and where they are poor."""

    worst: float
    inside: float
    layout: Any
    folded: np.ndarray
    off_cad: int

    @property
    def sound(self) -> bool:
        return self.worst >= SOUND and self.inside > 0

    @property
    def rank(self) -> Tuple[bool, bool, int, float]:
        """The greater, the better: sound, on the CAD, then by the worst."""
        return self.worst >= SOUND, self.inside > 0, -self.off_cad, self.worst


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
    best: Optional[_Found] = None
    start = time.monotonic()
    tried = list(SWITCHES)
    for attempt in ATTEMPTS:
        if (best is not None and best.sound) or time.monotonic() - start > 2 * PATIENCE:
            break
        found = _best_round(shape, faces, attempt, tried, start, progress)
        if attempt == ATTEMPTS[0]:
            start = time.monotonic()
        if isinstance(found, _Found) and (best is None or found.rank > best.rank):
            best = found
    if best is None:
        reason = "TetGen cannot fill the skin of " + ", ".join(found)
        raise BlockingError(f"no blocks: {reason}", found, [reason] * len(found))
    return _settled(shape, best, list(solids), tolerance, progress)


def _best_round(
    shape: Any,
    faces: Dict[int, List[Tuple[int, bool]]],
    attempt: Tuple[float, float, bool, int],
    tried: List[str],
    start: float,
    progress: Progress,
) -> Union[_Found, List[str]]:
    """The best layout found while the skin is made finer where it is poor; or the names of the
    solids that TetGen cannot fill."""
    kernel = _kernel.cad()
    wanted = sorted({face for rows in faces.values() for face, _ in rows})
    angle, stretch, split, rounds = attempt
    builder = kernel.SkinBuilder(
        shape, wanted, angle=angle, stretch=stretch, progress=_share(progress, 0, 0)
    )
    best: Optional[_Found] = None
    vain = 0  # rounds that made nothing better
    where = np.empty((0, 5))
    skin = builder.skin()
    begun = len(skin.triangles)
    for round_ in range(rounds):
        if round_:
            enough = best is not None and best.sound
            late = round_ > 1 and time.monotonic() - start > (1 if enough else 2) * PATIENCE
            late = late and best is not None
            if vain > (0 if enough else 1) or late or len(skin.triangles) > MOST_TRIANGLES:
                break
            builder.refine(where, _share(progress, round_, 0))
            skin = builder.skin()
            if best is None and not split and len(skin.triangles) > 2 * begun:
                break  # the skin of the next attempt is rather to be filled
        tets: List[Tuple[int, np.ndarray, np.ndarray]] = []
        finer: List[np.ndarray] = []
        for n, own in faces.items():
            inner, cells, trouble = _tetrahedra(shape, skin, n, own, tried, progress)
            tets.append((n, inner, cells))
            finer.append(trouble)
        where = np.concatenate(finer)
        if len(where):
            vain += best is not None
            continue
        layout = kernel.Layout(shape)
        worst, inside, where, off = kernel.tets_to_hexas(
            shape, skin, tets, layout, progress, split=split
        )
        found = _Found(worst, inside, layout, where, off)
        better = best is None or found.rank > best.rank
        vain = 0 if better else vain + 1
        if better:
            best = found
        if not len(where) or not split:
            break
    if best is None:
        return [f"Solid{n}" for n, where in zip(faces, finer) if len(where)]
    return best


def _settled(
    shape: Any, found: _Found, solids: List[int], tolerance: float, progress: Progress
) -> Dict[str, Any]:
    """The blocks of a layout whose mesh, as it is generated by default, is sound. The entry "whole"
    tells of each block whether it is one element of it: many blocks are as fine as a mesh. Few are
    halved until they are within the tolerance, and divided, if that does not fold them."""
    kernel = _kernel.cad()
    raw = kernel.tet_blocks(shape, found.layout, solids, np.inf, progress)
    if len(raw["nodes"]) <= FEW:
        finer = kernel.tet_blocks(shape, found.layout, solids, tolerance, progress)
        for blocks in (finer, raw) if len(finer["nodes"]) > len(raw["nodes"]) else (raw,):
            if _worst(shape, blocks, progress) >= max(SOUND, 0.5 * found.worst):
                return blocks
    raw["whole"] = np.ones(len(raw["nodes"]), bool)
    worst = _worst_of_each(shape, raw, progress) if found.worst < SOUND else {}
    names = [name for name, quality in worst.items() if not quality > 0]
    if names:
        x, y, z = found.folded[0, :3] if len(found.folded) else (np.nan,) * 3
        reason = f"hexahedra would be inside out near ({x:.6g}, {y:.6g}, {z:.6g})"
        raise BlockingError(f"no blocks: {reason}", names, [reason] * len(names))
    return raw


def _worst(shape: Any, raw: Dict[str, Any], progress: Progress) -> float:
    """Least scaled Jacobian of the mesh that is generated by default, less than SOUND where nodes
    of its leave the CAD."""
    from .cad import default_divisions, linked  # only here: cad.py imports this module

    model = linked(shape, raw)
    default_divisions(model)
    mesh = model.generate(progress=progress)
    worst = float(mesh.quality()["hexahedron"].min())
    return min(worst, 0.5 * SOUND) if len(mesh.off_cad) else worst


def _worst_of_each(shape: Any, raw: Dict[str, Any], progress: Progress) -> Dict[str, float]:
    """Least scaled Jacobian of the mesh in each solid, by the solid's name."""
    from .cad import default_divisions, linked  # only here: cad.py imports this module

    model = linked(shape, raw)
    default_divisions(model)
    mesh = model.generate(progress=progress)
    quality = mesh.quality()["hexahedron"]
    names = [entry["entity"] for entry in raw["report"]]
    return {name: float(quality[mesh.groups[name][1]].min()) for name in names}


def _share(progress: Progress, round_: int, part: int) -> Progress:
    if progress is None:
        return None
    return lambda fraction: progress((round_ + 0.5 * part + 0.5 * fraction) / MOST_ROUNDS)


def _tetrahedra(
    shape: Any,
    skin: Any,
    solid: int,
    faces: Sequence[Tuple[int, bool]],
    tried: List[str],
    progress: Progress,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Inner points, tetrahedra (in the skin's numbers, then the inner points), and where the skin
    must be finer (x, y, z, radius, size) because TetGen had to put points into it.

    tried: switches, in the order in which they are tried; those that do not end are taken out."""
    own = np.isin(skin.faces, [face for face, _ in faces])
    bounding = np.isin(skin.faces, [face for face, bounds in faces if bounds])
    triangles = skin.triangles[own]
    lines = _inner_lines(shape, skin, solid)
    used = np.unique(np.concatenate([triangles.reshape(-1), lines.reshape(-1)]))
    local = np.searchsorted(used, triangles).astype(np.int32)
    own_points = _kernel.cad().inner_points(shape, solid)
    if len(lines) and len(own_points):  # ends of edges inside are the skin's
        ends = skin.points[np.unique(lines)]
        own_points = own_points[[not (ends == p).all(axis=1).any() for p in own_points]]
    plc = PLC(
        np.concatenate([skin.points[used], own_points]),
        local,
        markers=skin.faces[own],
        edges=np.searchsorted(used, lines).astype(np.int32) if len(lines) else None,
    )
    last: Optional[TetGenError] = None
    nothing = np.empty((0, 3)), np.empty((0, 4), np.int32)
    chosen = None
    for switches in list(tried):
        try:
            mesh = tetrahedralize(plc, switches, TIMEOUT, progress)
        except TetGenError as error:
            last = error
            if error.timed_out and len(tried) > 1:
                tried.remove(switches)  # nor will it end on a finer skin
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
    missing = _not_edges(np.searchsorted(used, lines), cells)
    if len(missing):  # TetGen put points on them, or they cross the skin
        ends = skin.points[lines[missing]]
        length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        return (*nothing, np.column_stack([ends.mean(axis=1), length, 0.5 * length]))
    number = np.concatenate(
        [used, len(skin.points) + np.arange(len(mesh.points) - len(used))]
    ).astype(np.int32)
    return mesh.points[len(used) :], number[cells], np.empty((0, 5))


def _inner_lines(shape: Any, skin: Any, solid: int) -> np.ndarray:
    """(N, 2) points of the segments of the edges inside a solid."""
    chains = [skin.edges[edge] for edge in _kernel.cad().inner_edges(shape, solid)]
    rows = [pair for chain in chains for pair in zip(chain, chain[1:])]
    return np.array(rows, np.int32).reshape(-1, 2)


def _not_edges(lines: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """Which rows of lines are no edges of the tetrahedra."""
    if not len(lines):
        return np.empty(0, int)
    pairs = [cells[:, [i, j]] for i in range(4) for j in range(i + 1, 4)]
    edges = set(map(tuple, np.sort(np.concatenate(pairs), axis=1).tolist()))
    rows = np.sort(lines, axis=1).tolist()
    return np.flatnonzero([tuple(row) not in edges for row in rows])


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
