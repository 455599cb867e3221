# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same blocks after a dimension of the CAD has changed: nmgs.refit."""

from __future__ import annotations

from typing import Any, Callable, Optional

from . import _kernel
from .block_model import BlockModel, CadLink
from .cad import as_shape, brep_bytes


def refit(
    model: BlockModel, shape: Any, progress: Optional[Callable[[float], Any]] = None
) -> BlockModel:
    """A copy of a fitted model over a shape whose dimensions have changed.

    model: what nmgs.fit made. shape: a Part.Shape, a list of them or a document object, whose
    faces, edges and vertices are joined as those of the model's shape are, number by number.
    Blocks, divisions and grading stay; nodes keep to the entities that they lie on. The report's
    errors are measured anew; no block is halved.
    Raises GeometryError that names the first part whose topology has changed, ValueError for a
    model that was not fitted.
    """
    if model.cad is None:
        raise ValueError("model: expected blocks that nmgs.fit laid over CAD, got a free model")
    after = _kernel.cad().CadShape(brep_bytes(as_shape(shape)))
    fitted = [entry for entry in model.report if entry["method"]]
    nodes, errors = _kernel.cad().refit(
        model.cad.shape,
        after,
        model.nodes,
        model.divisions,
        model.cad.offsets,
        model.cad.entities,
        [(entry["first_block"], entry["blocks"]) for entry in fitted],
        progress,
    )
    result = model.copy()
    result.nodes = nodes
    result.cad = CadLink(after, model.cad.offsets, model.cad.entities, model.cad.corners)
    result.cad.whole = model.cad.whole
    result.report = [dict(entry) for entry in model.report]
    measured = iter(errors)
    for entry in result.report:
        if entry["method"]:
            entry["error"], entry["place"] = next(measured)
    return result


def follows(model: BlockModel, before: BlockModel, tolerance: Optional[float] = None) -> bool:
    """Whether refitted blocks are as good as a new fit's: as near to the CAD as the tolerance (a
    thousandth of the diagonal) or as they were before, and none turned over."""
    if model.cad is None:
        raise ValueError("model: expected blocks that nmgs.fit laid over CAD, got a free model")
    accepted = 1e-3 * model.cad.shape.diagonal if tolerance is None else tolerance
    for entry, old in zip(model.report, before.report):
        if entry["method"] and entry["error"] > max(accepted, 2 * old["error"]):
            return False
    return not any(p.kind in ("folded", "collapsed", "mirrored") for p in model.check())
