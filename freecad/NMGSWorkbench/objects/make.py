# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects of files and of the console API's results."""

from __future__ import annotations

import os
from typing import Any

from .. import nmgs
from . import blocking, blocks, imported_mesh, patches, plc


def blocks_from_file(document: Any, path: str) -> Any:
    """Patches or Blocks of a .n2s or .n3s file. Raises nmgs.FormatError."""
    model = nmgs.read(path)
    obj = blocks_from_model(document, model, _title(path))
    obj.File = path
    obj.recompute()
    return obj


def blocks_from_model(document: Any, model: nmgs.BlockModel, name: str = "") -> Any:
    """Patches or Blocks that hold the model's nodes and divisions."""
    module = patches if model.dimension == 2 else blocks
    obj = module.make(document)
    if name:
        obj.Label = name
    blocking.fill(obj, model)
    return obj


def mesh_from_file(document: Any, path: str) -> Any:
    """A mesh object of a file; with its Blocks or Patches when the file holds them, as N2R does."""
    mesh = nmgs.read(path)
    obj = imported_mesh.make(document, mesh)
    obj.Label = _title(path)
    obj.File = path
    if mesh.model is not None:
        obj.Blocks = blocks_from_model(document, mesh.model)
        obj.Blocks.recompute()
        obj.Blocks.Visibility = False
    return obj


def plc_from_file(document: Any, path: str) -> Any:
    """A Plc object of a .node, .poly or .smesh file."""
    obj = plc.make(document, nmgs.read(path))
    obj.Label = _title(path)
    obj.File = path
    return obj


def _title(path: str) -> str:
    return os.path.splitext(os.path.basename(path))[0]
