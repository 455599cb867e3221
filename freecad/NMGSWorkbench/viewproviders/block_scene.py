# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks in the scene graph: curved edges, counts on them, and the chain of an edge with arrows."""

from __future__ import annotations

from typing import Any, Dict

import numpy as np
from pivy import coin

from ..nmgs.block_model import BlockModel
from ..objects.block_edges import BLOCK_DIRECTIONS, PATCH_DIRECTIONS, curve, unique_edges
from . import scene_nodes as nodes

CHAIN: nodes.Colour = (0.85, 0.10, 0.45)
EDGE: nodes.Colour = (0.90, 0.45, 0.10)
COUNT: nodes.Colour = (0.05, 0.20, 0.45)
#: Texts on more edges than this hide the blocks.
MOST_COUNTS = 150
_SAMPLES = np.linspace(0.0, 1.0, 13)


def directions(model: BlockModel) -> np.ndarray:
    """Direction and sense of each local edge: (4 | 12, 2)."""
    return PATCH_DIRECTIONS if model.dimension == 2 else BLOCK_DIRECTIONS


def counted_edges(model: BlockModel) -> np.ndarray:
    """The rows of unique_edges that carry a count: all of them, or, where they are too many to be
    read, the longest edge of each chain, those of the longest chains' edges first."""
    rows = unique_edges(model.nodes)
    if len(rows) <= MOST_COUNTS:
        return rows
    ends = np.array([curve(model.nodes, *row, np.array([0.0, 0.5, 1.0])) for row in rows])
    lengths = np.linalg.norm(np.diff(ends, axis=1), axis=2).sum(axis=1)
    chain_of = model.chain_senses()["chain"][rows[:, 0], directions(model)[rows[:, 1], 0]]
    longest_first = np.argsort(-lengths, kind="stable")
    _, first = np.unique(chain_of[longest_first], return_index=True)
    return rows[longest_first[np.sort(first)[:MOST_COUNTS]]]


def counts(model: BlockModel) -> Any:
    """The number of elements along edges, as texts in their middles."""
    group = nodes.on_top()
    table = directions(model)
    for element, edge in counted_edges(model):
        place = curve(model.nodes, element, edge, np.array([0.5]))[0]
        words = str(model.divisions[element, table[edge, 0]])
        group.addChild(nodes.label(place, words, COUNT))
    return group


def edges(model: BlockModel, colour: nodes.Colour = EDGE, width: float = 3.0) -> Any:
    """All curved edges."""
    curves = np.array([curve(model.nodes, *row, _SAMPLES) for row in unique_edges(model.nodes)])
    return nodes.polylines(curves.reshape(-1, len(_SAMPLES), 3), colour, width)


def chain(model: BlockModel, element: int, direction: int, chains: Dict[str, np.ndarray]) -> Any:
    """The edges that change with a direction of an element: thick, with an arrow along the chain's
    sense on each and a dot at each node. chains: model.chain_senses()."""
    group = nodes.on_top()
    table = directions(model)
    number, turned = chains["chain"], chains["reversed"]
    wanted = number[element, direction]
    size = float(np.ptp(model.nodes.reshape(-1, 3), axis=0).max()) or 1.0
    curves, places = [], []
    spacing = model.spacing
    for e, local in unique_edges(model.nodes):
        along = table[local, 0]
        if number[e, along] != wanted:
            continue
        curves.append(curve(model.nodes, e, local, _SAMPLES))
        at = spacing[e * model.dimension + along]
        if at is None:
            at = np.linspace(0.0, 1.0, model.divisions[e, along] + 1)
        places.append(curve(model.nodes, e, local, at))
        around = curve(model.nodes, e, local, np.array([0.4, 0.5, 0.6]))
        way = around[2] - around[0]
        if turned[e, along] != turned[element, direction]:
            way = -way
        length = min(0.07 * size, 0.35 * float(np.linalg.norm(curves[-1][-1] - curves[-1][0])))
        if np.linalg.norm(way) > 0 and length > 0:
            group.addChild(nodes.arrow(around[1], way, length, CHAIN))
    if curves:
        group.addChild(nodes.polylines(np.array(curves), CHAIN, 5.0))
        group.addChild(nodes.dots(np.concatenate(places), CHAIN, 7.0))
    return group


def separator() -> Any:
    return coin.SoSeparator()
