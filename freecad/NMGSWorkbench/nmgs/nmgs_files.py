# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis's own files: N2S and N3S setups, N2R and N3R results (Tables C.1 to C.4)."""

from __future__ import annotations

from typing import Any, Callable, Optional

from . import _kernel
from .block_model import BlockModel
from .grading import positions
from .mesh import Mesh

ProgressCallback = Optional[Callable[[float], Any]]


def _model_of(raw: dict) -> BlockModel:
    model = BlockModel(raw["nodes"], raw["divisions"], raw["reference"])
    directions = model.dimension
    for at, spacing in enumerate(raw["spacing"]):
        if spacing is not None:
            model.grading[at // directions][at % directions] = positions(spacing)
    return model


def _read_setup(path: str, dimension: int, numbering: str) -> BlockModel:
    return _model_of(_kernel.core().read_setup(path, dimension, numbering))


def read_n2s(path: str, numbering: str = "corners-first") -> BlockModel:
    """Patches of an NMGS-SSMG problem setup file. numbering: "corners-first" or "perimeter"."""
    return _read_setup(path, 2, numbering)


def read_n3s(path: str, numbering: str = "corners-first") -> BlockModel:
    """Blocks of an NMGS-SVMG problem setup file. numbering: "corners-first" or "perimeter"."""
    return _read_setup(path, 3, numbering)


def _write_setup(path: str, model: Any, dimension: int, format: str) -> None:
    if not isinstance(model, BlockModel):
        raise ValueError(f"obj: {format} holds a BlockModel, got {type(model).__name__}")
    if model.dimension != dimension:
        kind = {2: "8-node patches", 3: "20-node blocks"}
        raise ValueError(f"obj: {format} holds {kind[dimension]}, got {kind[model.dimension]}")
    _kernel.core().write_setup(path, model.nodes, model.divisions, model.spacing, model.reference)


def write_n2s(path: str, model: BlockModel) -> None:
    """Writes patches as an NMGS-SSMG problem setup file.

    The grading follows the table's numbers in lines in parentheses, which readers skip.
    """
    _write_setup(path, model, 2, "n2s")


def write_n3s(path: str, model: BlockModel) -> None:
    """Writes blocks as an NMGS-SVMG problem setup file; the grading as write_n2s does."""
    _write_setup(path, model, 3, "n3s")


def _read_result(path: str, dimension: int, numbering: str, progress: ProgressCallback) -> Mesh:
    raw = _kernel.core().read_result(path, dimension, numbering, progress)
    cell = "quad" if dimension == 2 else "hexahedron"
    return Mesh(raw["points"], {cell: raw["cells"]}, model=_model_of(raw))


def read_n2r(
    path: str, numbering: str = "corners-first", progress: ProgressCallback = None
) -> Mesh:
    """Quads of an NMGS-SSMG result file, with the model they came from. Its diagonals and related
    nodes are checked and left out: mesh.split() and mesh.related_nodes() give them."""
    return _read_result(path, 2, numbering, progress)


def read_n3r(
    path: str, numbering: str = "corners-first", progress: ProgressCallback = None
) -> Mesh:
    """Hexahedra of an NMGS-SVMG result file, with the model they came from. Its tetrahedra and
    related nodes are checked and left out: mesh.split() and mesh.related_nodes() give them."""
    return _read_result(path, 3, numbering, progress)


def _write_result(path: str, mesh: Any, dimension: int, progress: ProgressCallback) -> None:
    format = f"n{dimension}r"
    cell = "quad" if dimension == 2 else "hexahedron"
    if not isinstance(mesh, Mesh):
        raise ValueError(f"obj: {format} holds a Mesh, got {type(mesh).__name__}")
    model = mesh.model
    if model is None:
        raise ValueError(
            f"obj: {format} holds a mesh with the blocks it was generated from, but mesh.model is "
            "None"
        )
    if model.dimension != dimension:
        kind = {2: "8-node patches", 3: "20-node blocks"}
        raise ValueError(
            f"obj: {format} holds a mesh of {kind[dimension]}, but mesh.model has "
            f"{kind[model.dimension]}"
        )
    if cell not in mesh.cells:
        raise ValueError(
            f"obj: {format} holds {cell} cells, but the mesh has {', '.join(mesh.cells) or 'none'}"
        )
    _kernel.core().write_result(
        path,
        model.nodes,
        model.divisions,
        model.spacing,
        model.reference,
        mesh.points,
        mesh.cells[cell],
        progress,
    )


def write_n2r(path: str, mesh: Mesh, progress: ProgressCallback = None) -> None:
    """Writes a generated surface mesh as an NMGS-SSMG result file; needs mesh.model.

    Raises ValueError when the mesh has no model, or cells that did not come from it.
    """
    _write_result(path, mesh, 2, progress)


def write_n3r(path: str, mesh: Mesh, progress: ProgressCallback = None) -> None:
    """Writes a generated solid mesh and its tetrahedra as an NMGS-SVMG result file."""
    _write_result(path, mesh, 3, progress)
