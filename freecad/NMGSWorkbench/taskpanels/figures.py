# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a mesh object as a line for its panel."""

from __future__ import annotations

from typing import Any

from ..texts import tr


def text(obj: Any) -> str:
    """Nodes, elements of each type and the worst scaled Jacobian."""
    if not obj.ElementCount:
        return tr("No mesh yet")
    return tr("{nodes} nodes; {elements}; worst scaled Jacobian {worst}").format(
        nodes=obj.NodeCount,
        elements=", ".join(obj.Elements),
        worst=f"{obj.WorstScaledJacobian:.4g}",
    )
