# SPDX-License-Identifier: LGPL-2.1-or-later
"""Examples: each makes a document as a user would, so that all of it can be changed."""

from __future__ import annotations

from typing import Any, NamedTuple, Tuple

import FreeCAD


class Example(NamedTuple):
    """name: also of the module beside this one, which has make(document), and of the picture."""

    name: str
    title: str
    about: str


EXAMPLES: Tuple[Example, ...] = (
    Example(
        "hemisphere",
        "Hemisphere",
        "The thesis's own example: patches of 8 nodes become quads. Change the sizes or the "
        "divisions, and the mesh follows.",
    ),
    Example(
        "flange",
        "O-grid flange",
        "A core of blocks with rings round it, none of them collapsed, so that all hexahedra "
        "are good. The blocks are given by their nodes.",
    ),
    Example(
        "elbow",
        "Elbow",
        "A round bar with an O-grid, bent by 90 degrees, with elements that grow from both ends.",
    ),
    Example(
        "bracket",
        "Bracket with TetGen",
        "A part that has no obvious blocks: TetGen fills it with tetrahedra of good quality.",
    ),
    Example(
        "cantilever",
        "FEM cantilever",
        "A bar as quadratic hexahedra in an analysis with a support and a load, to be solved.",
    ),
)


def make(name: str) -> Any:
    """A new document with an example; returns it. Raises ValueError for an unknown name."""
    import importlib

    known = {example.name: example for example in EXAMPLES}
    if name not in known:
        raise ValueError(f"example: expected one of {', '.join(known)}, got {name!r}")
    module = importlib.import_module(f".{name}", __package__)
    document = FreeCAD.newDocument(known[name].title.replace(" ", "_").replace("-", "_"))
    document.Label = known[name].title
    try:
        module.make(document)
        document.recompute()
        for obj in document.Objects:
            failure = getattr(getattr(obj, "Proxy", None), "failure", None)
            if failure is not None:
                raise failure
            # Counts on the edges would cover the mesh.
            if hasattr(obj, "Divisions") and hasattr(obj.ViewObject, "ShowCounts"):
                obj.ViewObject.ShowCounts = False
    except BaseException:
        FreeCAD.closeDocument(document.Name)
        raise
    document.clearUndos()
    return document
