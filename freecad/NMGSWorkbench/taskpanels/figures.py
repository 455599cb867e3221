# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a mesh object as a line for its panel."""

from __future__ import annotations

from typing import Any


def text(obj: Any) -> str:
    """Nodes, elements of each type and the worst scaled Jacobian."""
    if not obj.ElementCount:
        return "No mesh yet"
    return (
        f"{obj.NodeCount} nodes; {', '.join(obj.Elements)}; "
        f"worst scaled Jacobian {obj.WorstScaledJacobian:.4g}"
    )
