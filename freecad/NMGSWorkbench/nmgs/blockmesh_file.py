# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenFOAM's blockMeshDict of a BlockModel: curved edges, gradings, patches (user guide, "Mesh
generation with the blockMesh utility")."""

from __future__ import annotations

from typing import Any, Dict, List, TextIO, Tuple

import numpy as np

from .atomic import replaced_file
from .block_model import BlockModel
from .openfoam_files import REST, header, word

#: Corners of the edges in the order of the thesis's mid-side nodes 9 to 20, 0-based.
EDGES = (
    (0, 1),
    (1, 2),
    (2, 3),
    (3, 0),
    (4, 5),
    (5, 6),
    (6, 7),
    (7, 4),
    (0, 4),
    (1, 5),
    (2, 6),
    (3, 7),
)
#: Corners of a block's faces, seen from outside, and their part a + 3 b + 9 c (see CadLink).
FACES = (
    ((0, 4, 7, 3), 0 + 3 + 9),
    ((1, 2, 6, 5), 2 + 3 + 9),
    ((0, 1, 5, 4), 1 + 0 + 9),
    ((3, 7, 6, 2), 1 + 6 + 9),
    ((0, 3, 2, 1), 1 + 3 + 0),
    ((4, 5, 6, 7), 1 + 3 + 18),
)
#: Points of a curve between its ends.
_BETWEEN = 15
#: A mid-side node is off the straight edge when farther than this share of its length.
_STRAIGHT = 1e-9


def write_blockmesh(path: str, model: BlockModel, scale: float = 1.0) -> None:
    """vertices, blocks with their divisions and gradings, splines for curved edges, and the CAD's
    faces as patches (without CAD blockMesh's own defaultFaces). scale: what blockMesh multiplies
    lengths by, 0.001 for a model in mm. Raises ValueError for patches and problems of the blocks.
    """
    if not isinstance(model, BlockModel) or model.dimension != 3:
        raise ValueError("obj: a blockMeshDict is written of blocks, a BlockModel of 20-node ones")
    problems = model.check()
    if problems:
        raise ValueError(f"obj: {problems[0]}")
    vertices, number = _vertices(model)
    with replaced_file(path) as file:
        file.write(header("dictionary", "blockMeshDict", "system"))
        file.write(f"convertToMeters {scale!r};\n\nvertices\n(\n")
        file.writelines(f"    ({x!r} {y!r} {z!r})\n" for x, y, z in vertices.tolist())
        file.write(");\n\nblocks\n(\n")
        spacing = model.spacing
        for block, corners in enumerate(number.tolist()):
            counts = " ".join(map(str, model.divisions[block].tolist()))
            gradings = " ".join(_grading(spacing[3 * block + d]) for d in range(3))
            file.write(f"    hex ({' '.join(map(str, corners))}) ({counts})\n")
            file.write(f"        simpleGrading ({gradings})\n")
        file.write(");\n\nedges\n(\n")
        _write_edges(file, model, number)
        # Without this, faces in no patch would be of the type "empty", which solvers refuse in 3D.
        file.write(f");\n\ndefaultPatch\n{{\n    name {REST};\n    type patch;\n}}\n")
        file.write("\nboundary\n(\n")
        _write_patches(file, model, number)
        file.write(");\n")


def _vertices(model: BlockModel) -> Tuple[np.ndarray, np.ndarray]:
    """(places, number of each block's corner): corners that the mesh joins are one vertex."""
    coarse = BlockModel(model.nodes, 1)
    mesh = coarse.generate(snap=False, force=True)
    # One element a block, in the order of the blocks; its corners are the block's.
    return mesh.points, mesh.cells["hexahedron"]


def _grading(positions: Any) -> str:
    """blockMesh's grading of these positions from 0 to 1: the ratio of the last cell to the first
    where the sizes are a geometric series, else each cell by itself."""
    if positions is None:
        return "1"
    sizes = np.diff(np.asarray(positions, dtype=float))
    if len(sizes) == 1:
        return "1"
    ratios = sizes[1:] / sizes[:-1]
    if np.allclose(ratios, ratios[0], rtol=1e-9):
        return repr(float(sizes[-1] / sizes[0]))
    return "(" + " ".join(f"({size!r} 1 1)" for size in sizes.tolist()) + ")"


def _write_edges(file: TextIO, model: BlockModel, number: np.ndarray) -> None:
    done = set()
    t = np.linspace(-1, 1, _BETWEEN + 2)[1:-1, None]
    for nodes, corners in zip(model.nodes, number.tolist()):
        for k, (a, b) in enumerate(EDGES):
            key = (min(corners[a], corners[b]), max(corners[a], corners[b]))
            start, middle, end = nodes[a], nodes[8 + k], nodes[b]
            length = np.linalg.norm(end - start)
            off = np.linalg.norm(middle - (start + end) / 2)
            if key in done or off <= _STRAIGHT * length:
                continue
            done.add(key)
            curve = t * (t - 1) / 2 * start + (1 - t * t) * middle + t * (t + 1) / 2 * end
            places = " ".join(f"({x!r} {y!r} {z!r})" for x, y, z in curve.tolist())
            file.write(f"    spline {corners[a]} {corners[b]} ({places})\n")


def _write_patches(file: TextIO, model: BlockModel, number: np.ndarray) -> None:
    found: Dict[tuple, List[Tuple[int, int, List[int]]]] = {}
    for block, corners in enumerate(number.tolist()):
        for at, part in FACES:
            face = [corners[k] for k in at]
            found.setdefault(tuple(sorted(face)), []).append((block, part, face))
    patches: Dict[str, List[List[int]]] = {}
    for entries in found.values():
        if len(entries) != 1 or model.cad is None:
            continue
        block, part, face = entries[0]
        names = [n for dimension, n in model.cad.of(block, part).tolist() if dimension == 2]
        if names:
            patches.setdefault(f"Face{names[0]}", []).append(face)
    for name, faces in patches.items():
        file.write(f"    {word(name)}\n    {{\n        type patch;\n        faces\n        (\n")
        file.writelines(f"            ({' '.join(map(str, face))})\n" for face in faces)
        file.write("        );\n    }\n")
