# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis's own files: N2S and N3S problem setups (Tables C.1, C.2)."""

from __future__ import annotations

from typing import Any

from . import _kernel
from .block_model import BlockModel
from .grading import positions


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
