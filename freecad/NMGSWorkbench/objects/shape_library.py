# SPDX-License-Identifier: LGPL-2.1-or-later
"""The console API's ready-made shapes, by name and arguments as a document keeps them."""

from __future__ import annotations

import inspect
import json
from typing import Any, Dict, List, NamedTuple, Tuple

from .. import nmgs


class Argument(NamedTuple):
    """name; kind: "length", "angle", "count" or "counts"; default, in the function's own type."""

    name: str
    kind: str
    default: Any


def names() -> Tuple[str, ...]:
    """Of all shapes, surfaces first."""
    return nmgs.shapes.NAMES


def arguments(name: str) -> List[Argument]:
    """What a shape takes. Raises ValueError for a name that is not of the library."""
    if name not in nmgs.shapes.NAMES:
        raise ValueError(f"library: no such shape {name!r}; known: {', '.join(nmgs.shapes.NAMES)}")
    result = []
    for parameter in inspect.signature(getattr(nmgs.shapes, name)).parameters.values():
        kind = "length"
        if parameter.name == "divisions":
            kind = "counts"
        elif isinstance(parameter.default, int):
            kind = "count"
        elif "angle" in parameter.name:
            kind = "angle"
        result.append(Argument(parameter.name, kind, parameter.default))
    return result


def make_model(name: str, text: str) -> nmgs.BlockModel:
    """The shape. text: its arguments as JSON. Raises ValueError that names the argument."""
    known = {argument.name for argument in arguments(name)}
    try:
        given: Dict[str, Any] = json.loads(text or "{}")
    except ValueError as error:
        raise ValueError(f"Arguments: not JSON: {error}") from error
    if not isinstance(given, dict) or set(given) - known:
        raise ValueError(f"Arguments: expected some of {', '.join(sorted(known))}, got {text}")
    return getattr(nmgs.shapes, name)(**given)
