# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why there is no mesh: an unfinished run of the worker as a TetGenError in words."""

from __future__ import annotations

import re
import signal
from typing import Any, List

from ..errors import TetGenError
from ..plc import PLC
from .results import TetGenData
from .worker import Outcome

MEANINGS = {
    1: "not enough memory",
    2: "an internal error of TetGen",
    3: "the facets intersect each other",
    4: "a feature of the input is smaller than the tolerance (-T)",
    5: "two facets are so close that the mesh cannot come between (-Y may help)",
    10: "TetGen does not accept the input",
    101: "the worker and this workbench are of different versions",
    200: "the boundary has Steiner points (-YY)",
}

#: A facet in TetGen's words: "#12" behind the nodes of a triangle, or "facet 12".
FACET = re.compile(r"\][ ]*#(\d+)|[Ff]acet #?(\d+)")


def _facets_said(log: str, count: int) -> List[int]:
    """0-based facets that TetGen names; it counts from 1."""
    numbers = (int(a or b) - 1 for a, b in FACET.findall(log))
    return sorted({n for n in numbers if 0 <= n < count})


def error_of(outcome: Outcome, source: Any, timeout: "float | None") -> TetGenError:
    """The error for an outcome that is not whole."""
    if outcome.timed_out:
        return TetGenError(
            f"TetGen did not finish within {timeout:g} s", code=0, facets=(), log=outcome.log
        )
    facets = _facets_said(outcome.log, len(source)) if isinstance(source, PLC) else []
    if outcome.code:
        text = MEANINGS.get(outcome.code, f"error {outcome.code}")
        code = outcome.code
        if outcome.text:
            text += f" ({outcome.text})"
    else:
        code = outcome.status
        text = f"TetGen ended without a word (exit status {outcome.status})"
        if outcome.status < 0:
            try:
                name = signal.Signals(-outcome.status).name
            except ValueError:
                name = str(-outcome.status)
            text = f"TetGen crashed ({name})"
    if facets:
        text += "; facets " + ", ".join(map(str, facets))
    return TetGenError("TetGen: " + text, code=code, facets=facets, log=outcome.log)


def no_tetrahedra(source: Any, data: TetGenData) -> TetGenError:
    """The error for a run that ended well and left nothing: the surface does not close."""
    return TetGenError("TetGen left no tetrahedra: the surface encloses no volume", log=data.log)
