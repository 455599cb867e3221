# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random undo, redo, change and recompute of a document; test_random_steps.py runs some of them,
scripts/random-steps a thousand."""

import random

import FreeCAD
import numpy as np

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.objects import blocks, make, structured_mesh, tetgen_mesh


def build(document):
    """A box with blocks and meshes, and blocks given by their nodes with a mesh."""
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    laid = blocks.make(document, "Blocks")
    laid.Source = [(box, ("Solid1",))]
    laid.Size = 5
    mesh = structured_mesh.make(document, "Hexes")
    mesh.Blocks = laid
    tets = tetgen_mesh.make(document, "Tets")
    tets.Source = [(box, ("Solid1",))]
    given = make.blocks_from_model(document, nmgs.shapes.cube(10.0, 2), "Given")
    other = structured_mesh.make(document, "Others")
    other.Blocks = given
    document.recompute()


def _by_label(document, label):
    return next(obj for obj in document.Objects if label in (obj.Name, obj.Label))


def _change(document, rng):
    """One change of a property, as an undo step."""
    box, laid = _by_label(document, "Box"), _by_label(document, "Blocks")
    mesh, tets = _by_label(document, "Hexes"), _by_label(document, "Tets")
    given, other = _by_label(document, "Given"), _by_label(document, "Others")
    changes = (
        lambda: setattr(box, "Length", rng.randint(5, 20)),
        lambda: setattr(box, "Height", rng.randint(5, 20)),
        lambda: setattr(laid, "Size", rng.choice((3, 4, 5, 8))),
        lambda: setattr(mesh, "Order", rng.choice((1, 2))),
        lambda: setattr(mesh, "Split", rng.random() < 0.5),
        lambda: setattr(tets, "Switches", rng.choice(("pq", "p", "pqa20"))),
        lambda: setattr(given, "Divisions", [rng.randint(1, 4) for _ in range(3)]),
        lambda: setattr(other, "Order", rng.choice((1, 2))),
    )
    document.openTransaction("Change")
    rng.choice(changes)()
    if rng.random() < 0.6:
        document.recompute()
    document.commitTransaction()


def walk(document, steps, seed):
    """So many random steps."""
    rng = random.Random(seed)
    for _ in range(steps):
        kind = rng.random()
        if kind < 0.45:
            _change(document, rng)
        elif kind < 0.65:
            document.undo()
        elif kind < 0.8:
            document.redo()
        else:
            document.recompute()


def content(document):
    """All results as plain values: meshes both as the document and as the console API has them."""
    result = {}
    for obj in document.Objects:
        proxy = getattr(obj, "Proxy", None)
        if hasattr(proxy, "mesh"):
            mesh = proxy.mesh(obj)
            fem = obj.FemMesh
            result[obj.Name] = (
                np.round(mesh.points, 9).tolist(),
                {name: cells.tolist() for name, cells in mesh.cells.items()},
                obj.ElementCount,
                obj.NodeCount,
                fem.NodeCount,
                fem.VolumeCount,
            )
        elif hasattr(proxy, "model"):
            model = proxy.model(obj)
            result[obj.Name] = (
                np.round(model.nodes, 9).tolist(),
                model.divisions.tolist(),
                list(obj.Divisions),
                len(obj.Shape.Edges),
            )
    return result


def fresh(document):
    """The same document with everything computed anew."""
    for obj in document.Objects:
        proxy = getattr(obj, "Proxy", None)
        for name in ("_model", "_mesh"):
            if hasattr(proxy, name):
                setattr(proxy, name, None)
        obj.touch()
    document.recompute()
    return content(document)


def run(steps, seed):
    """Walks, then compares with a fresh recompute; returns the names that differ."""
    document = FreeCAD.newDocument("Random")
    document.UndoMode = 1
    try:
        build(document)
        walk(document, steps, seed)
        document.recompute()
        walked = content(document)
        again = fresh(document)
        return [name for name in again if walked.get(name) != again[name]]
    finally:
        FreeCAD.closeDocument(document.Name)
