# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes by the CAD's own names: counts on edges, boundary layers on faces.

Both work on a model that nmgs.fit laid over CAD, and hold along whole chains of blocks (see
BlockModel.chains), over all solids that share nodes.
"""

from __future__ import annotations

import collections
from typing import Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _kernel, grading
from .block_model import DIRECTIONS, BlockModel
from .errors import BlockingError, GeometryError

#: Part codes (a + 3 b + 9 c) of the middles of a block's edges, by direction.
_EDGES = {
    0: [1 + 3 * b + 9 * c for c in (0, 2) for b in (0, 2)],
    1: [a + 3 + 9 * c for c in (0, 2) for a in (0, 2)],
    2: [a + 3 * b + 9 for b in (0, 2) for a in (0, 2)],
}


def set_edge_counts(model: BlockModel, counts: Mapping[str, int]) -> None:
    """Elements along CAD edges.

    counts: {"Edge3": 12, ...}. An edge that several blocks share out is divided among them by
    length. Edges that are not named keep their divisions unless a chain links them to one that is.
    Raises BlockingError that names the blocks and the chain that links edges with other counts,
    or the edge whose count is less than its blocks; GeometryError for an edge without blocks,
    ValueError.
    """
    raw = _chains(model)
    hard: Dict[Tuple[int, int], int] = {}
    for name, count in counts.items():
        number = _number(name, "Edge")
        if count != int(count) or count < 1:
            raise ValueError(f"counts: expected a whole number from 1 on, got {count!r} for {name}")
        segments = _segments(model, number)
        if not segments:
            raise GeometryError(f"counts: no block lies on {name}", [name])
        chains = collections.Counter(
            int(raw["chain"][element, direction]) for element, direction in segments.values()
        )
        first = {int(raw["chain"][e, d]): (e, d) for e, d in reversed(list(segments.values()))}
        lengths = {chain: float(raw["length"][first[chain]]) for chain in chains}
        shares = _shared_out(int(count), chains, lengths)
        if shares is None:
            reason = (
                f"{name} is made of {len(segments)} blocks' edges in {len(chains)} chains: "
                f"{count} elements cannot be divided among them"
            )
            raise BlockingError(reason, [name], [reason])
        for chain, share in shares.items():
            element, direction = first[chain]
            if hard.setdefault((element, direction), share) != share:
                reason = f"{name}: its count of {count} contradicts another edge's of its chain"
                raise BlockingError(reason, [name], [reason])
    model.set_divisions(hard=hard, soft=_present(model))


def set_boundary_layers(
    model: BlockModel,
    faces: Sequence[str],
    first: float,
    growth: float = 1.2,
    layers: Optional[int] = None,
) -> None:
    """Thin elements at CAD faces.

    faces: ["Face3", ...]. first: height of the first element, on the mean length of the first block
    at the face. growth: how much higher each is than the one before it. layers: how many there
    are; None until they are as high as the elements that are there now. The rest of the direction
    is divided evenly, in elements no longer than now.
    Raises BlockingError that names the block that is too thin, or a chain that comes back to itself
    turned round; GeometryError for a face without blocks, ValueError.
    """
    if not 0 < first < float("inf"):
        raise ValueError(f"first: expected a height above 0, got {first!r}")
    if not 1 <= growth < 10:
        raise ValueError(f"growth: expected 1 to 10, got {growth!r}")
    if layers is not None and (layers != int(layers) or layers < 1):
        raise ValueError(f"layers: expected a whole number from 1 on, got {layers!r}")
    if model.dimension != 3:
        raise ValueError("model: boundary layers need blocks, got patches")
    raw = _chains(model)
    ends: Dict[int, Dict[bool, Tuple[int, int]]] = collections.defaultdict(dict)
    for name in faces:
        found = list(_sides(model, _number(name, "Face")))
        if not found:
            raise GeometryError(f"faces: no block lies on {name}", [name])
        for element, direction, high in found:
            turned = bool(raw["reversed"][element, direction])
            chain = int(raw["chain"][element, direction])
            ends[chain].setdefault(high != turned, (element, direction))
    for chain, walls in ends.items():
        if raw["twisted"][chain]:
            walls = {False: next(iter(walls.values())), True: next(iter(walls.values()))}
        element, direction = next(iter(walls.values()))
        length = float(raw["length"][element, direction])
        size = length / int(model.divisions[element, direction])
        heights = _layer_heights(first, growth, size, layers)
        rest = length - len(walls) * sum(heights)
        if rest <= 0 and layers is None:
            # Thin: as many layers as find room, the last ones as high as what is left.
            while heights and rest <= 0:
                rest += len(walls) * heights.pop()
        if rest <= 0 or not heights:
            name = f"Block{element + 1}"
            reason = (
                f"{name} is {length:.6g} long along {DIRECTIONS[direction]}: too short for its "
                f"boundary layers of {first:.6g} and more"
            )
            raise BlockingError(reason, [name], [reason])
        core = [rest / max(1, int(np.ceil(rest / size - 1e-9)))]
        core *= max(1, int(np.ceil(rest / size - 1e-9)))
        sizes = (heights if False in walls else []) + core
        sizes += heights[::-1] if True in walls else []
        if raw["reversed"][element, direction]:
            sizes.reverse()
        model.set_divisions(hard={(element, direction): len(sizes)}, soft=_present(model))
        spacing = grading.positions(np.concatenate([[0.0], np.cumsum(sizes)]))
        model.set_grading(element, direction, spacing)


def _layer_heights(first: float, growth: float, size: float, layers: Optional[int]) -> List[float]:
    heights = [first]
    limit = 1000 if layers is None else layers
    while len(heights) < limit and (layers is not None or heights[-1] * growth < size):
        heights.append(heights[-1] * growth)
        if growth == 1 and layers is None:
            break
    return heights


def _chains(model: BlockModel) -> dict:
    if model.cad is None:
        raise ValueError("model: expected blocks that nmgs.fit laid over CAD, got a free model")
    return _kernel.core().chains(model.nodes, model.divisions, corners=model._corners())


def _number(name: str, kind: str) -> int:
    digits = name[len(kind) :] if isinstance(name, str) and name.startswith(kind) else ""
    if not digits.isdigit():
        raise ValueError(f"expected a name like {kind}3, got {name!r}")
    return int(digits)


def _bound(model: BlockModel, dimension: int, number: int) -> np.ndarray:
    """(element, part) rows of the parts that lie on one entity."""
    link = model.cad
    assert link is not None
    rows = np.flatnonzero((link.entities[:, 0] == dimension) & (link.entities[:, 1] == number))
    parts = np.searchsorted(link.offsets, rows, side="right") - 1
    return np.stack([parts // 27, parts % 27], axis=1)


def _segments(model: BlockModel, number: int) -> Dict[Tuple[float, ...], Tuple[int, int]]:
    """The blocks' edges on a CAD edge, each once: its middle node's place -> (element,
    direction)."""
    codes = {code: direction for direction, list_ in _EDGES.items() for code in list_}
    middle = {code: node for node, code in enumerate(_node_codes(model.dimension))}
    size = model.cad.shape.diagonal  # type: ignore[union-attr]
    result: Dict[Tuple[float, ...], Tuple[int, int]] = {}
    for element, code in _bound(model, 1, number).tolist():
        if code not in codes:  # a corner inside the CAD's edge
            continue
        place = model.nodes[element, middle[code]]
        key = tuple(np.round(place / (1e-7 * size)).tolist())
        result.setdefault(key, (element, codes[code]))
    return result


def _sides(model: BlockModel, number: int):
    """(element, direction, at its high end) of the blocks' faces on a CAD face."""
    for element, code in _bound(model, 2, number).tolist():
        digits = (code % 3, code // 3 % 3, code // 9)
        for direction in range(3):
            if digits[direction] != 1 and digits.count(1) == 2:
                yield element, direction, digits[direction] == 2


def _node_codes(dimension: int) -> List[int]:
    """Part codes of an element's nodes, in the thesis's order."""
    corners = [(0, 0), (2, 0), (2, 2), (0, 2)]
    middles = [(1, 0), (2, 1), (1, 2), (0, 1)]
    if dimension == 2:
        return [a + 3 * b for a, b in corners + middles]
    codes = [a + 3 * b + 9 * c for c in (0, 2) for a, b in corners]
    codes += [a + 3 * b + 9 * c for c in (0, 2) for a, b in middles]
    return codes + [a + 3 * b + 9 for a, b in corners]


def _shared_out(
    count: int, chains: Mapping[int, int], lengths: Mapping[int, float]
) -> Optional[Dict[int, int]]:
    """Elements of each chain, in proportion to its length, that make up the count; each chain
    counts as often as it comes along the edge. None where they cannot."""
    shares = {chain: 1 for chain in chains}
    left = count - sum(chains.values())
    while left > 0:
        able = [chain for chain, times in chains.items() if times <= left]
        if not able:
            return None
        longest = max(able, key=lambda chain: (lengths[chain] / shares[chain], -chain))
        shares[longest] += 1
        left -= chains[longest]
    return shares if left == 0 else None


def _present(model: BlockModel) -> Dict[Tuple[int, int], int]:
    return {
        (element, direction): int(count)
        for (element, direction), count in np.ndenumerate(model.divisions)
    }
