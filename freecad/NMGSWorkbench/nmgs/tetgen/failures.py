# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why there is no mesh: an unfinished run of the worker as a TetGenError that names the facets."""

from __future__ import annotations

import re
import signal
from typing import Any, Callable, List, Optional, Sequence

from .. import _kernel
from ..errors import TetGenError
from ..plc import PLC
from ..plc_problem import PLCProblem, problems_of
from .results import TetGenData
from .worker import Outcome

#: Meaning of TetGen's exit codes, and of the worker's own from 100 on.
MEANINGS = {
    1: "not enough memory",
    2: "an internal error of TetGen",
    3: "the facets intersect each other",
    4: "a feature of the input is smaller than the tolerance (-T)",
    5: "two facets are so close that no element fits between (-Y may help)",
    10: "TetGen does not accept the input",
    101: "the worker and this workbench are of different versions",
    200: "the boundary would need Steiner points, and -YY forbids them",
}
MEMORY, INPUT, PROTOCOL = 1, 10, 101

#: Problems of a PLC in the order in which they explain a failure.
CULPRITS = (
    "crossing_facets",
    "open_edge",
    "degenerate_facet",
    "duplicate_facet",
    "nonplanar_facet",
    "hole_outside",
)

#: A facet in TetGen's words: "#12" behind the nodes of a triangle, or "facet 12".
FACET = re.compile(r"\][ ]*#(\d+)|[Ff]acet #?(\d+)")
#: Segments and triangles that TetGen 1.6 names by their nodes alone.
NODES = re.compile(r"(?:1st|2nd|left out):? \[(\d+), ?(\d+)(?:, ?(\d+))?\](?! *#)")
#: Facets whose polygons go with an error, for whoever draws them.
OUTLINED = 1000
#: Problems that a message spells out.
SHOWN = 3

Progress = Optional[Callable[[float], Any]]


def error_of(
    outcome: Outcome, source: Any, timeout: Optional[float], progress: Progress
) -> TetGenError:
    """The error for an answer that is not whole. Raises Cancelled."""
    if outcome.timed_out:
        text = f"TetGen did not finish within {timeout:g} s"
        return TetGenError(text, log=outcome.log, timed_out=True)
    text, code = _words(outcome)
    if code in (MEMORY, PROTOCOL) or outcome.text and code == INPUT:
        return TetGenError("TetGen: " + text, code=code, log=outcome.log)
    return _with_facets("TetGen: " + text, code, source, outcome.log, progress)


def no_tetrahedra(source: Any, data: TetGenData, progress: Progress) -> TetGenError:
    """The error for a run that ended well and left nothing. Raises Cancelled."""
    return _with_facets(
        "TetGen left no tetrahedra: the facets enclose no volume", 0, source, data.log, progress
    )


def _words(outcome: Outcome) -> "tuple[str, int]":
    if outcome.code:
        text = MEANINGS.get(outcome.code, f"error {outcome.code}")
        return (f"{text} ({outcome.text})" if outcome.text else text), outcome.code
    if outcome.status >= 0:
        return f"it ended without a word (exit status {outcome.status})", outcome.status
    try:
        name = signal.Signals(-outcome.status).name
    except ValueError:
        name = f"signal {-outcome.status}"
    text = f"it crashed ({name})"
    if "Background mesh" in outcome.log:
        text += " over the background mesh, as TetGen 1.6 does; give sizes at points instead"
    return text, outcome.status


def _facets_said(log: str, plc: PLC) -> List[int]:
    """0-based facets that TetGen names by their numbers, from 1, or by nodes, from 0."""
    numbers = (int(a or b) - 1 for a, b in FACET.findall(log))
    found = {n for n in numbers if 0 <= n < len(plc)}
    for nodes in NODES.findall(log):
        owners = [set(plc.facets_of_nodes([int(n)]).tolist()) for n in nodes if n]
        found |= set.intersection(*owners)
    return sorted(found)


def _with_facets(text: str, code: int, source: Any, log: str, progress: Progress) -> TetGenError:
    """The error with the facets that TetGen named and those that the check finds."""
    if not isinstance(source, PLC):
        return TetGenError(text, code=code, log=log)
    problems = _culprits(source, progress)
    said = _facets_said(log, source)
    facets = sorted({f for problem in problems for f in problem.facets} | set(said))
    if problems:
        text += ": " + "; ".join(_named(problem, source) for problem in problems[:SHOWN])
        if len(problems) > SHOWN:
            text += f"; and {len(problems) - SHOWN} more"
    elif said:
        text += "; TetGen names facets " + ", ".join(map(str, said))
    error = TetGenError(text, code=code, facets=facets, log=log)
    error.problems = problems  # type: ignore[attr-defined]
    error.entities = names_of(source, facets)  # type: ignore[attr-defined]
    error.outlines = [
        source.points[ring] for facet in facets[:OUTLINED] for ring in source.facet(facet)
    ]
    return error


def _culprits(plc: PLC, progress: Progress) -> List[PLCProblem]:
    """The problems of the kind that explains most."""
    found = problems_of(_kernel.core().check_plc(plc, equal_points=True, progress=progress))
    for fault in CULPRITS:
        problems = [problem for problem in found if problem.fault == fault]
        if problems:
            return problems
    return []


def names_of(plc: PLC, facets: Sequence[int]) -> List[str]:
    """Names of the PLC's groups, for example FaceN, that the facets belong to."""
    if plc.markers is None:
        return []
    markers = {int(plc.markers[facet]) for facet in facets}
    return [name for name, own in plc.groups.items() if markers.intersection(own)]


def _named(problem: PLCProblem, plc: PLC) -> str:
    names = names_of(plc, problem.facets)
    return f"{problem} ({', '.join(names)})" if names else str(problem)
