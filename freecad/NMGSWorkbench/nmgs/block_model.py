# SPDX-License-Identifier: LGPL-2.1-or-later
"""BlockModel: curved 8-node patches or 20-node blocks, to be divided (NMGS-SSMG, NMGS-SVMG)."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np

from . import _kernel
from .errors import BlockingError
from .grading import Grading
from .mesh import Mesh


DIRECTIONS = ("xi", "eta", "zeta")
#: (element, direction): from 0 on, or the direction's name.
Direction = Tuple[int, Union[int, str]]


@dataclasses.dataclass(frozen=True)
class Problem:
    """kind: folded, collapsed, mirrored, divisions, spacing, gap or overlap. blocks: one name or
    two, as "Block2". place: where. text: the whole sentence."""

    kind: str
    blocks: Tuple[str, ...]
    place: Tuple[float, float, float]
    text: str

    def __str__(self) -> str:
        return self.text


class CadLink:
    """What the blocks lie on. shape: the kernel's CadShape.

    Parts of a block are numbered a + 3 b + 9 c, with a, b, c = 0, 1, 2 for the low end, the inside
    and the high end along xi, eta, zeta (c = 0 for patches). entities: int32 (K, 2), dimension
    (0 vertex, 1 edge, 2 face, 3 solid) and FreeCAD's 1-based number; those of part p of block e are
    entities[offsets[27 e + p] : offsets[27 e + p + 1]].
    corners: int32 (NE, 8 | 4), points that the blocks' corners are: corners with one number are
    one, others never, however near. None: by place.
    """

    def __init__(
        self,
        shape: Any,
        offsets: np.ndarray,
        entities: np.ndarray,
        corners: Optional[np.ndarray] = None,
    ):
        self.shape = shape
        self.offsets = offsets
        self.entities = entities
        self.corners = corners
        #: bool (NE,), blocks that default divisions leave in one element; None: no such.
        self.whole: Optional[np.ndarray] = None

    def of(self, block: int, part: int) -> np.ndarray:
        """Entities of a part of a block (0-based)."""
        at = 27 * block + part
        return self.entities[self.offsets[at] : self.offsets[at + 1]]


class BlockModel:
    """Curved elements in the thesis's node order, with their divisions.

    nodes: float64 (NE, 8 | 20, 3), corners first. divisions: int32 (NE, 2 | 3), elements along xi,
    eta (, zeta), or one row for all. reference: the user's text, one line.
    Raises ValueError that names the argument, the element (1-based) and the value.
    """

    def __init__(self, nodes: np.ndarray, divisions: np.ndarray, reference: str = ""):
        self.nodes = np.ascontiguousarray(nodes, dtype=np.float64)
        if self.nodes.ndim != 3 or self.nodes.shape[1:] not in ((8, 3), (20, 3)):
            raise ValueError(
                f"nodes: expected shape (NE, 8, 3) or (NE, 20, 3), got {self.nodes.shape}"
            )
        if not len(self.nodes):
            raise ValueError("nodes: expected one element or more, got none")
        if not np.isfinite(self.nodes).all():
            element, node = np.argwhere(~np.isfinite(self.nodes))[0][:2]
            raise ValueError(f"nodes: node {node + 1} of element {element + 1} is not finite")
        self.divisions = self._checked_divisions(divisions)
        self.reference = self._checked_reference(reference)
        #: The CAD that nmgs.fit laid the blocks over, or None.
        self.cad: Optional[CadLink] = None
        #: grading[element][direction]: a Grading. Uniform where nothing is set; see set_grading.
        self.grading = [[Grading()] * self.dimension for _ in range(len(self))]
        #: What nmgs.fit found out, one entry a face or solid; empty for other models.
        self.report: list = []

    @property
    def dimension(self) -> int:
        """2 for patches, 3 for blocks."""
        return 2 if self.nodes.shape[1] == 8 else 3

    def __len__(self) -> int:
        return len(self.nodes)

    def _checked_divisions(self, divisions: np.ndarray) -> np.ndarray:
        values = np.asarray(divisions)
        if values.dtype.kind not in "iuf" or not np.isfinite(values).all():
            raise ValueError(f"divisions: expected whole numbers, got {divisions!r}")
        shape = (len(self.nodes), self.dimension)
        if values.ndim == 0 or values.shape == shape[1:]:
            values = np.broadcast_to(values, shape)
        if values.shape != shape:
            raise ValueError(f"divisions: expected shape {shape}, got {values.shape}")
        bad = np.argwhere((values != np.floor(values)) | (values < 1) | (values > 2**31 - 1))
        if len(bad):
            element, direction = bad[0]
            raise ValueError(
                f"divisions: element {element + 1} has {values[element, direction]} along "
                f"{DIRECTIONS[direction]}; expected a whole number from 1 on"
            )
        return np.ascontiguousarray(values, dtype=np.int32)

    @staticmethod
    def _checked_reference(reference: str) -> str:
        if not isinstance(reference, str):
            raise TypeError(f"reference: expected text, got {type(reference).__name__}")
        if "\n" in reference or "\r" in reference:
            raise ValueError("reference: expected one line of text")
        return reference

    def _corners(self) -> Optional[np.ndarray]:
        """Numbers of the corners' points, where the CAD gave any for these very elements."""
        corners = None if self.cad is None else self.cad.corners
        return corners if corners is not None and len(corners) == len(self) else None

    @property
    def spacing(self) -> List[Optional[np.ndarray]]:
        """Positions from 0 to 1 of the lattice planes, of all elements' directions one after the
        other; None where uniform. Raises ValueError naming the element and direction."""
        if len(self.grading) != len(self) or any(len(g) != self.dimension for g in self.grading):
            raise ValueError(
                f"grading: expected {len(self)} elements of {self.dimension} directions"
            )
        result = []
        for element, (row, counts) in enumerate(zip(self.grading, self.divisions)):
            for direction, (grading, count) in enumerate(zip(row, counts)):
                try:
                    result.append(grading.positions(int(count)))
                except ValueError as error:
                    raise ValueError(
                        f"grading: element {element + 1} along {DIRECTIONS[direction]}: {error}"
                    ) from error
        return result

    def chains(self, tolerance: Optional[float] = None) -> np.ndarray:
        """int32 (NE, 2 | 3): directions with one number are one chain of opposite and shared edges;
        they must have one count and one spacing."""
        raw = _kernel.core().chains(
            self.nodes, self.divisions, self._checked_tolerance(tolerance), self._corners()
        )
        return raw["chain"]

    def chain_senses(self, tolerance: Optional[float] = None) -> Dict[str, np.ndarray]:
        """The chains in full: "chain" (NE, 2 | 3) as chains() gives it; "reversed" (NE, 2 | 3),
        true where the direction runs against its chain; "length" (NE, 2 | 3), the mean arc length
        of the edges along it; "twisted", for each chain whether it comes back turned round."""
        return _kernel.core().chains(self.nodes, self.divisions, self._checked_tolerance(tolerance))

    def set_divisions(
        self,
        size: Optional[float] = None,
        hard: Optional[Mapping[Direction, int]] = None,
        soft: Optional[Mapping[Direction, int]] = None,
    ) -> None:
        """Divisions that agree over the whole model.

        hard, soft: {(element, direction): count}; elements from 0, directions 0 to 2 or "xi",
        "eta", "zeta". A chain with hard counts gets that count, else the largest soft one, else,
        given size, the fewest divisions with no element longer than it on the chain's longest edge,
        else the largest of its present ones. Raises BlockingError naming the blocks and the chain
        that links them when hard counts contradict each other, ValueError.
        """
        if size is not None and not 0 < size < float("inf"):
            raise ValueError(f"size: expected a length above 0, got {size!r}")
        wishes = []
        for name, counts in (("hard", hard), ("soft", soft)):
            for key, count in (counts or {}).items():
                element, direction = self._checked_direction(key)
                if count != int(count) or not 1 <= count < 2**31:
                    raise ValueError(
                        f"{name}: expected a whole number from 1 on for {key!r}, got {count!r}"
                    )
                wishes.append((element, direction, int(count), name == "hard"))
        self.divisions = _kernel.core().solve_divisions(
            self.nodes,
            self.divisions,
            wishes,
            0.0 if size is None else float(size),
            corners=self._corners(),
        )

    def with_divisions(
        self,
        size: Optional[float] = None,
        hard: Optional[Mapping[Direction, int]] = None,
        soft: Optional[Mapping[Direction, int]] = None,
    ) -> "BlockModel":
        """A copy with other divisions; see set_divisions."""
        model = self.copy()
        model.set_divisions(size, hard, soft)
        return model

    def set_grading(
        self, element: int, direction: Union[int, str], grading: Grading, chain: bool = True
    ) -> None:
        """Grades a direction of an element and, with chain, all directions that must agree with it,
        turned round where they run the other way.

        Sizes of the grading are taken on the mean arc length of this element's edges along the
        direction. Raises BlockingError where a chain comes back to itself turned round and the
        grading is not symmetric, ValueError.
        """
        element, direction = self._checked_direction((element, direction))
        raw = _kernel.core().chains(self.nodes, self.divisions, corners=self._corners())
        if grading.needs_length:
            length = float(raw["length"][element, direction])
            grading = dataclasses.replace(grading, length=length)
        spacing = grading.positions(int(self.divisions[element, direction]))
        if not chain:
            self.grading[element][direction] = grading
            return
        number = raw["chain"][element, direction]
        symmetric = spacing is None or np.allclose(spacing, 1 - spacing[::-1], rtol=0, atol=1e-9)
        if raw["twisted"][number] and not symmetric:
            name = f"Block{element + 1}"
            reason = (
                f"{name} along {DIRECTIONS[direction]} is in a chain that comes back to it turned "
                "round: only a symmetric grading fits"
            )
            raise BlockingError(reason, [name], [reason])
        turned = grading.reversed()
        for e, d in np.argwhere(raw["chain"] == number):
            same = raw["reversed"][e, d] == raw["reversed"][element, direction]
            self.grading[e][d] = grading if same else turned

    def _checked_direction(self, key: Direction) -> Tuple[int, int]:
        try:
            element, direction = key
        except (TypeError, ValueError):
            raise ValueError(f"expected (element, direction), got {key!r}") from None
        names = DIRECTIONS[: self.dimension]
        if not isinstance(element, (int, np.integer)) or not 0 <= element < len(self):
            raise ValueError(f"element: expected 0 to {len(self) - 1}, got {element!r}")
        if direction in names:
            return int(element), names.index(direction)
        if not isinstance(direction, (int, np.integer)) or not 0 <= direction < self.dimension:
            raise ValueError(
                f"direction: expected 0 to {self.dimension - 1} or one of {', '.join(names)}, "
                f"got {direction!r}"
            )
        return int(element), int(direction)

    def copy(self) -> "BlockModel":
        """A model of its own with the same blocks; the CAD that they lie on is shared."""
        model = BlockModel(self.nodes.copy(), self.divisions.copy(), self.reference)
        model.grading = [list(row) for row in self.grading]
        model.cad = self.cad
        model.report = list(self.report)
        return model

    def check(self, tolerance: Optional[float] = None) -> List[Problem]:
        """What is wrong with the blocks before meshing; empty where nothing is.

        Folded, collapsed and mirrored blocks, blocks that meet with different divisions or
        gradings, nearly meet, or overlap. A gap is more than the tolerance and less than a fifth
        of the smallest element edge. Raises ValueError.
        """
        raw = _kernel.core().check(
            self.nodes,
            self.divisions,
            self.spacing,
            self._checked_tolerance(tolerance),
            self._corners(),
        )
        return [
            Problem(kind, tuple(f"Block{b + 1}" for b in (first, second) if b >= 0), place, text)
            for kind, first, second, place, text in raw
        ]

    @staticmethod
    def _checked_tolerance(tolerance: Optional[float]) -> float:
        if tolerance is None:
            return -1.0
        if not 0 <= tolerance < float("inf"):
            raise ValueError(f"tolerance: expected 0 or more, got {tolerance!r}")
        return float(tolerance)

    def generate(
        self,
        tolerance: Optional[float] = None,
        order: int = 1,
        snap: bool = True,
        progress: Optional[Callable[[float], Any]] = None,
        force: bool = False,
    ) -> Mesh:
        """Structured mesh: quads of patches, hexahedra of blocks.

        tolerance: nodes of different blocks closer than this are one; None for 1e-4 of the
        smallest element edge. order: 1 or 2 (quad8, hexahedron20). snap: put the nodes onto the
        CAD that the model was fitted to. progress: called with the finished fraction, False stops.
        force: mesh blocks with problems (see check) as they are instead of refusing.
        Raises BlockingError that names the blocks, Cancelled, ValueError.
        """
        if order not in (1, 2):
            raise ValueError(f"order: expected 1 or 2, got {order!r}")
        accepted = self._checked_tolerance(tolerance)
        if snap and self.cad is not None:
            from .cad import generate_on_cad  # only here: cad.py imports this module

            raw = generate_on_cad(self, order, accepted, progress, bool(force))
            mesh = Mesh(raw["points"], raw["cells"], raw["groups"], model=self)
            mesh.off_cad = raw["off_cad"]
            return mesh
        raw = _kernel.core().generate(
            self.nodes,
            self.divisions,
            spacing=self.spacing,
            tolerance=accepted,
            force=bool(force),
            progress=progress,
            corners=self._corners(),
        )
        mesh = Mesh(raw["points"], raw["cells"], raw["groups"], model=self)
        return mesh if order == 1 else mesh.to_order(2)

    def __repr__(self) -> str:
        kind = "patches" if self.dimension == 2 else "blocks"
        return f"<nmgs.BlockModel: {len(self)} {kind}>"
