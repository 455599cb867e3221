# SPDX-License-Identifier: LGPL-2.1-or-later
"""BlockModel.grading as lines of text in a property, and back."""

from __future__ import annotations

import dataclasses
import json
from typing import List, Sequence

from .. import nmgs
from ..nmgs.grading import Grading


def lines(model: nmgs.BlockModel) -> List[str]:
    """One line of JSON a direction, elements one after the other; none where all are uniform."""
    gradings = [grading for row in model.grading for grading in row]
    if all(grading == Grading() for grading in gradings):
        return []
    return [_line(grading) for grading in gradings]


def _line(grading: Grading) -> str:
    plain = dataclasses.asdict(Grading())
    values = dataclasses.asdict(grading)
    return json.dumps({key: value for key, value in values.items() if value != plain[key]})


def put(model: nmgs.BlockModel, text: Sequence[str]) -> None:
    """Sets the model's grading from the lines. Raises ValueError that names the line."""
    if not text:
        return
    count = model.dimension
    if len(text) != len(model) * count:
        raise ValueError(
            f"Grading: expected none or {len(model) * count} lines, one a direction of each "
            f"element, got {len(text)}"
        )
    for at, line in enumerate(text):
        try:
            values = json.loads(line or "{}")
            grading = Grading(**{**values, "values": tuple(values.get("values", ()))})
        except (TypeError, ValueError) as error:
            raise ValueError(f"Grading: line {at + 1}: {error}") from error
        model.grading[at // count][at % count] = grading
