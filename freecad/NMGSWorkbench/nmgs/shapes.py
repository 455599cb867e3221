# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ready-made blocks (thesis 4.3.2 i). Placed as FreeCAD's own primitives are: boxes with a corner
at the origin, round bodies with their axis on z and their base, or centre, at the origin.

All nodes lie on the true shape, at the middle of its parameters. Round things have an O-grid: a
core with blocks round it, none of them collapsed. Patches are seen from outside (flat ones from
+z); blocks are right-handed. Common arguments:

divisions: elements along each direction of a block, one number for all or one each, as each
    function says. "around" counts a piece of a quarter of a circle.
pieces: blocks into which each block is cut along each direction. A quarter of a circle becomes one
    quadratic arc a piece, and what is missing to the true shape falls with the third power of
    pieces or faster. Where one piece would be far off, which is on a sphere, two are the default.

All raise ValueError that names the argument and its value.
"""

from __future__ import annotations

from typing import Callable, List, Sequence, Tuple, Union

import numpy as np

from .block_model import BlockModel

Divisions = Union[int, Sequence[int]]
#: Points (..., 3) at natural coordinates (..., 2 | 3) in [-1, 1].
Map = Callable[[np.ndarray], np.ndarray]
#: A block: its map and its divisions.
Block = Tuple[Map, Tuple[int, ...]]

_QUAD8 = np.array(
    [[-1, -1], [1, -1], [1, 1], [-1, 1], [0, -1], [1, 0], [0, 1], [-1, 0]], dtype=np.float64
)
_HEXA20 = np.array(
    [(x, y, -1) for x, y in _QUAD8[:4]]
    + [(x, y, 1) for x, y in _QUAD8[:4]]
    + [(x, y, -1) for x, y in _QUAD8[4:]]
    + [(x, y, 1) for x, y in _QUAD8[4:]]
    + [(x, y, 0) for x, y in _QUAD8[:4]],
    dtype=np.float64,
)
#: Half-width of a core's corners, as a part of the radius, and how far its sides bulge.
_CORE = 0.55
_BULGE = 0.2


def _positive(**values: float) -> None:
    for name, value in values.items():
        if isinstance(value, bool) or not np.isscalar(value) or not 0 < value < np.inf:
            raise ValueError(f"{name}: expected a number above 0, got {value!r}")


def _counts(divisions: Divisions, names: Sequence[str]) -> Tuple[int, ...]:
    values = np.asarray(divisions)
    if values.ndim == 0:
        values = np.broadcast_to(values, len(names))
    good = values.shape == (len(names),) and np.issubdtype(values.dtype, np.integer)
    if not good or (values < 1).any() or (values >= 2**31).any():
        raise ValueError(
            f"divisions: expected a whole number from 1 on, or one each for {', '.join(names)}; "
            f"got {divisions!r}"
        )
    return tuple(int(value) for value in values)


def _model(blocks: List[Block], pieces: int, reference: str) -> BlockModel:
    if isinstance(pieces, bool) or not isinstance(pieces, (int, np.integer)) or pieces < 1:
        raise ValueError(f"pieces: expected a whole number from 1 on, got {pieces!r}")
    dimension = len(blocks[0][1])
    natural = _QUAD8 if dimension == 2 else _HEXA20
    nodes = []
    divisions = []
    for mapping, counts in blocks:
        for cell in np.ndindex(*(pieces,) * dimension):
            # xi runs fastest; the ends of a piece are the same numbers on both sides.
            at = np.array(cell[::-1])
            nodes.append(mapping((2 * at + 1 + natural - pieces) / pieces))
            divisions.append(counts)
    return BlockModel(np.array(nodes), np.array(divisions), reference)


def _xyz(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    return np.stack(np.broadcast_arrays(x, y, z), axis=-1)


def _arc(t: np.ndarray, quarter: int) -> np.ndarray:
    """Points of the unit circle, in the plane, for t in [-1, 1] over a quarter about its middle."""
    angle = np.pi / 4 * t + np.pi / 2 * quarter
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def _core_square(s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """The bulged core of the unit disc, for s, t in [-1, 1]; in the plane."""
    half = _CORE / np.sqrt(2)
    return half * np.stack(
        [s * (1 + _BULGE * (1 - t * t)), t * (1 + _BULGE * (1 - s * s))], axis=-1
    )


def _turned(plane: np.ndarray, quarter: int) -> np.ndarray:
    x, y = plane[..., 0], plane[..., 1]
    for _ in range(quarter % 4):
        x, y = -y, x
    return np.stack([x, y], axis=-1)


def _ring(inner: float, outer: float, quarter: int) -> Callable[..., np.ndarray]:
    def mapping(r: np.ndarray, s: np.ndarray) -> np.ndarray:
        radius = 0.5 * ((1 - r) * inner + (1 + r) * outer)
        return radius[..., None] * _arc(s, quarter)

    return mapping


def _disc_maps() -> List[Tuple[Callable[..., np.ndarray], str]]:
    """Plane maps of the unit disc: ("core": s, t) and four ("ring": outward r, around s)."""

    def ring(quarter: int) -> Callable[..., np.ndarray]:
        def mapping(r: np.ndarray, s: np.ndarray) -> np.ndarray:
            inner = _turned(_core_square(np.ones_like(s), s), quarter)
            w = 0.5 * (1 + r)[..., None]
            return (1 - w) * inner + w * _arc(s, quarter)

        return mapping

    return [(_core_square, "core")] + [(ring(q), "ring") for q in range(4)]


# Surfaces


def square(
    size: Union[float, Sequence[float]] = 1.0, divisions: Divisions = 4, pieces: int = 1
) -> BlockModel:
    """A square, or a rectangle for size (x, y). divisions: (x, y)."""
    sides = np.broadcast_to(np.asarray(size, dtype=np.float64), 2)
    _positive(size=float(sides[0]))
    _positive(size=float(sides[1]))
    counts = _counts(divisions, ("x", "y"))

    def mapping(n: np.ndarray) -> np.ndarray:
        plane = 0.5 * (n + 1) * sides
        return _xyz(plane[..., 0], plane[..., 1], 0.0)

    return _model([(mapping, counts)], pieces, "square")


def disc(radius: float = 1.0, divisions: Divisions = 4, pieces: int = 1) -> BlockModel:
    """A disc of five patches. divisions: (around, radial)."""
    _positive(radius=radius)
    around, radial = _counts(divisions, ("around", "radial"))
    return _model(_disc_blocks(radius, around, radial, 0.0, False), pieces, "disc")


def _disc_blocks(radius: float, around: int, radial: int, height: float, down: bool) -> List[Block]:
    blocks: List[Block] = []
    for plane_map, kind in _disc_maps():

        def mapping(n: np.ndarray, plane_map: Callable[..., np.ndarray] = plane_map) -> np.ndarray:
            u, v = (n[..., 1], n[..., 0]) if down else (n[..., 0], n[..., 1])
            plane = radius * plane_map(u, v)
            return _xyz(plane[..., 0], plane[..., 1], height)

        counts = (around, around) if kind == "core" else (radial, around)
        blocks.append((mapping, counts[::-1] if down else counts))
    return blocks


def _lateral_blocks(
    bottom: float, top: float, height: float, around: int, along: int
) -> List[Block]:
    blocks: List[Block] = []
    for quarter in range(4):

        def mapping(n: np.ndarray, quarter: int = quarter) -> np.ndarray:
            w = 0.5 * (1 + n[..., 1])
            plane = ((1 - w) * bottom + w * top)[..., None] * _arc(n[..., 0], quarter)
            return _xyz(plane[..., 0], plane[..., 1], height * w)

        blocks.append((mapping, (around, along)))
    return blocks


def cylinder_surface(
    radius: float = 1.0,
    height: float = 1.0,
    divisions: Divisions = 4,
    caps: bool = False,
    pieces: int = 1,
) -> BlockModel:
    """The lateral surface of a cylinder, of four patches; with caps, five more at each end.

    divisions: (around, along, radial); radial is for the caps.
    """
    _positive(radius=radius, height=height)
    around, along, radial = _counts(divisions, ("around", "along", "radial"))
    blocks = _lateral_blocks(radius, radius, height, around, along)
    if caps:
        blocks += _disc_blocks(radius, around, radial, 0.0, True)
        blocks += _disc_blocks(radius, around, radial, height, False)
    return _model(blocks, pieces, "surface of a cylinder")


def cone_surface(
    radius: float = 1.0,
    height: float = 1.0,
    top_radius: float = 0.0,
    divisions: Divisions = 4,
    pieces: int = 1,
) -> BlockModel:
    """The lateral surface of a cone. Cut off at top_radius, four patches; divisions: (around,
    along). With an apex, three patches a quarter, so that none is collapsed; divisions: (around,
    along), where along counts from the rim half-way up, and a quarter of the rim has 2 around.
    """
    _positive(radius=radius, height=height)
    if top_radius != 0:
        _positive(top_radius=top_radius)
    around, along = _counts(divisions, ("around", "along"))
    if top_radius > 0:
        blocks = _lateral_blocks(radius, top_radius, height, around, along)
        return _model(blocks, pieces, "surface of a cone")
    blocks = []
    for quarter in range(4):

        def cone(bary: np.ndarray, quarter: int = quarter) -> np.ndarray:
            # bary: of the apex, and of the ends of the rim.
            apex, a, b = bary[..., 0], bary[..., 1], bary[..., 2]
            rho = a + b
            t = np.divide(b - a, rho, out=np.zeros_like(rho), where=rho > 0)
            plane = (radius * rho)[..., None] * _arc(t, quarter)
            return _xyz(plane[..., 0], plane[..., 1], height * apex)

        for corner in range(3):

            def mapping(n: np.ndarray, cone: Map = cone, corner: int = corner) -> np.ndarray:
                return cone(_triangle_part(n, corner))

            # Corner 0 is at the apex, 1 and 2 are at the rim.
            counts = ((around, around), (around, along), (along, around))[corner]
            blocks.append((mapping, counts))
    return _model(blocks, pieces, "surface of a cone")


def _triangle_part(n: np.ndarray, corner: int) -> np.ndarray:
    """Barycentric coordinates of the quarter of a triangle at a corner: natural (-1, -1) is the
    corner, (1, -1) and (-1, 1) the middles of the edges to the next and the last corner, (1, 1) the
    centroid."""
    u = 0.5 * (1 + n[..., 0])
    v = 0.5 * (1 + n[..., 1])
    here, following, last = np.eye(3)[[corner, (corner + 1) % 3, (corner + 2) % 3]]
    ends = np.stack(
        [here, (here + following) / 2, (here + following + last) / 3, (here + last) / 2]
    )
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=-1)
    return weights @ ends


def _cube_direction(s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Unit vectors over the face +z of a cube, equal angles apart, for s, t in [-1, 1]."""
    x = np.tan(np.pi / 4 * s)
    y = np.tan(np.pi / 4 * t)
    vectors = _xyz(x, y, 1.0)
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


#: Rotations that bring the face +z of a cube to each of its six faces.
_CUBE_FACES = [
    np.array(rows, dtype=np.float64)
    for rows in (
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[1, 0, 0], [0, -1, 0], [0, 0, -1]],
        [[0, 0, 1], [1, 0, 0], [0, 1, 0]],
        [[0, 0, -1], [-1, 0, 0], [0, 1, 0]],
        [[-1, 0, 0], [0, 0, 1], [0, 1, 0]],
        [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
    )
]


def sphere_surface(radius: float = 1.0, divisions: Divisions = 4, pieces: int = 2) -> BlockModel:
    """A sphere of six patches, times pieces squared. divisions: (around,)."""
    _positive(radius=radius)
    (around,) = _counts(divisions, ("around",))
    blocks: List[Block] = []
    for face in _CUBE_FACES:

        def mapping(n: np.ndarray, face: np.ndarray = face) -> np.ndarray:
            return radius * _cube_direction(n[..., 0], n[..., 1]) @ face.T

        blocks.append((mapping, (around, around)))
    return _model(blocks, pieces, "sphere")


def _slerp(a: np.ndarray, b: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Along the great circle from unit vector a to b."""
    angle = np.arccos(np.clip((a * b).sum(axis=-1), -1, 1))
    sine = np.sin(angle)
    return (np.sin((1 - w) * angle)[..., None] * a + np.sin(w * angle)[..., None] * b) / sine[
        ..., None
    ]


def _cap_direction(s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Unit vectors over the top patch of a hemisphere, its corners at 50 degrees from the pole."""
    corner = np.deg2rad(50)
    reach = np.arctan(np.tan(corner) / np.sqrt(2))
    vectors = _xyz(np.tan(reach * s), np.tan(reach * t), 1.0)
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def _side_direction(s: np.ndarray, t: np.ndarray, quarter: int) -> np.ndarray:
    """Unit vectors over a side patch of a hemisphere: s along the equator, t up to the cap."""
    plane = _arc(s, quarter)
    equator = _xyz(plane[..., 0], plane[..., 1], 0.0)
    rim = _cap_direction(np.ones_like(s), s)
    xy = _turned(rim[..., :2], quarter)
    cap = _xyz(xy[..., 0], xy[..., 1], rim[..., 2])
    return _slerp(equator, cap, 0.5 * (1 + t))


def hemisphere(radius: float = 1.0, divisions: Divisions = 4, pieces: int = 1) -> BlockModel:
    """The upper half of a sphere of five patches (thesis Fig. 2.4). divisions: (around, up)."""
    _positive(radius=radius)
    around, up = _counts(divisions, ("around", "up"))
    blocks: List[Block] = [
        (lambda n: radius * _cap_direction(n[..., 0], n[..., 1]), (around, around))
    ]
    for quarter in range(4):

        def mapping(n: np.ndarray, quarter: int = quarter) -> np.ndarray:
            return radius * _side_direction(n[..., 0], n[..., 1], quarter)

        blocks.append((mapping, (around, up)))
    return _model(blocks, pieces, "hemisphere")


def _swept(plane: np.ndarray, s: np.ndarray, quarter: int, radius: float) -> np.ndarray:
    """A place (r, z) of a torus's section, turned about z by the angle of s in its quarter."""
    ring = (radius + plane[..., 0])[..., None] * _arc(s, quarter)
    return _xyz(ring[..., 0], ring[..., 1], plane[..., 1])


def _check_torus(radius: float, tube_radius: float) -> None:
    _positive(radius=radius, tube_radius=tube_radius)
    if tube_radius >= radius:
        raise ValueError(
            f"tube_radius: expected less than the radius {radius!r}, got {tube_radius!r}"
        )


def torus_surface(
    radius: float = 1.0, tube_radius: float = 0.25, divisions: Divisions = 4, pieces: int = 1
) -> BlockModel:
    """A torus of 16 patches. divisions: (along, around) of the ring and of its section."""
    _check_torus(radius, tube_radius)
    along, around = _counts(divisions, ("along", "around"))
    blocks: List[Block] = []
    for ring in range(4):
        for section in range(4):

            def mapping(n: np.ndarray, ring: int = ring, section: int = section) -> np.ndarray:
                return _swept(tube_radius * _arc(n[..., 1], section), n[..., 0], ring, radius)

            blocks.append((mapping, (along, around)))
    return _model(blocks, pieces, "torus")


# Solids


def box(
    length: float = 1.0,
    width: float = 1.0,
    height: float = 1.0,
    divisions: Divisions = 4,
    pieces: int = 1,
) -> BlockModel:
    """A box along x, y, z. divisions: (x, y, z)."""
    _positive(length=length, width=width, height=height)
    counts = _counts(divisions, ("x", "y", "z"))
    sides = np.array([length, width, height], dtype=np.float64)
    return _model([(lambda n: 0.5 * (n + 1) * sides, counts)], pieces, "box")


def cube(size: float = 1.0, divisions: Divisions = 4, pieces: int = 1) -> BlockModel:
    """A cube. divisions: (x, y, z)."""
    _positive(size=size)
    model = box(size, size, size, divisions, pieces)
    model.reference = "cube"
    return model


def _frustum_blocks(
    bottom: float, top: float, height: float, counts: Tuple[int, int, int]
) -> List[Block]:
    around, radial, along = counts
    blocks: List[Block] = []
    for plane_map, kind in _disc_maps():

        def mapping(n: np.ndarray, plane_map: Callable[..., np.ndarray] = plane_map) -> np.ndarray:
            w = 0.5 * (1 + n[..., 2])
            plane = ((1 - w) * bottom + w * top)[..., None] * plane_map(n[..., 0], n[..., 1])
            return _xyz(plane[..., 0], plane[..., 1], height * w)

        blocks.append((mapping, (around if kind == "core" else radial, around, along)))
    return blocks


def cylinder(
    radius: float = 1.0, height: float = 1.0, divisions: Divisions = 4, pieces: int = 1
) -> BlockModel:
    """A cylinder of five blocks. divisions: (around, radial, along)."""
    _positive(radius=radius, height=height)
    counts = _counts(divisions, ("around", "radial", "along"))
    return _model(_frustum_blocks(radius, radius, height, counts), pieces, "cylinder")


#: Hexahedra of a tetrahedron cut at its edges' middles: for each corner the other three, in the
#: order that makes a right-handed block of a right-handed tetrahedron.
_TETRA_PARTS = ((0, 1, 2, 3), (1, 2, 0, 3), (2, 0, 1, 3), (3, 0, 2, 1))


def _tetra_part(n: np.ndarray, part: Sequence[int]) -> np.ndarray:
    """Barycentric coordinates of the quarter of a tetrahedron at corner part[0]."""
    u, v, w = (0.5 * (1 + n[..., d]) for d in range(3))
    unit = np.eye(4)[list(part)]
    result = np.zeros(n.shape[:-1] + (4,))
    for i, wu in ((0, 1 - u), (1, u)):
        for j, wv in ((0, 1 - v), (1, v)):
            for k, ww in ((0, 1 - w), (1, w)):
                corners = [0] + [c for c, on in ((1, i), (2, j), (3, k)) if on]
                result += (wu * wv * ww)[..., None] * unit[corners].mean(axis=0)
    return result


def cone(
    radius: float = 1.0,
    height: float = 1.0,
    top_radius: float = 0.0,
    divisions: Divisions = 4,
    pieces: int = 1,
) -> BlockModel:
    """A cone. Cut off at top_radius, five blocks; divisions: (around, radial, along). With an apex,
    four blocks a quarter, so that none is collapsed; divisions: one number for all their edges.
    """
    _positive(radius=radius, height=height)
    if top_radius != 0:
        _positive(top_radius=top_radius)
        counts = _counts(divisions, ("around", "radial", "along"))
        return _model(_frustum_blocks(radius, top_radius, height, counts), pieces, "cone")
    (count,) = _counts(divisions, ("edges",))
    blocks: List[Block] = []
    for quarter in range(4):
        a, b = radius * _arc(np.array([-1.0, 1.0]), quarter)
        corners = np.array([[0, 0, 0], [*a, 0], [*b, 0], [0, 0, height]], dtype=np.float64)

        def solid(
            bary: np.ndarray,
            quarter: int = quarter,
            corners: np.ndarray = corners,
            a: np.ndarray = a,
            b: np.ndarray = b,
        ) -> np.ndarray:
            points = bary @ corners
            rho = bary[..., 1] + bary[..., 2]
            t = np.divide(bary[..., 2] - bary[..., 1], rho, out=np.zeros_like(rho), where=rho > 0)
            chord = 0.5 * ((1 - t)[..., None] * a + (1 + t)[..., None] * b)
            whole = rho + bary[..., 0]
            weight = np.divide(rho * rho, whole, out=np.zeros_like(rho), where=whole > 0)
            # The bulge from chord to arc, whole on the lateral surface and fading to the axis.
            points[..., :2] += weight[..., None] * (radius * _arc(t, quarter) - chord)
            return points

        for part in _TETRA_PARTS:

            def mapping(
                n: np.ndarray, solid: Map = solid, part: Sequence[int] = part
            ) -> np.ndarray:
                return solid(_tetra_part(n, part))

            blocks.append((mapping, (count, count, count)))
    return _model(blocks, pieces, "cone")


def tube(
    radius: float = 1.0,
    inner_radius: float = 0.5,
    height: float = 1.0,
    divisions: Divisions = 4,
    pieces: int = 1,
) -> BlockModel:
    """A tube of four blocks. divisions: (around, radial, along)."""
    _positive(radius=radius, inner_radius=inner_radius, height=height)
    if inner_radius >= radius:
        raise ValueError(
            f"inner_radius: expected less than the radius {radius!r}, got {inner_radius!r}"
        )
    around, radial, along = _counts(divisions, ("around", "radial", "along"))
    blocks: List[Block] = []
    for quarter in range(4):

        def mapping(n: np.ndarray, quarter: int = quarter) -> np.ndarray:
            plane = _ring(inner_radius, radius, quarter)(n[..., 0], n[..., 1])
            return _xyz(plane[..., 0], plane[..., 1], 0.5 * height * (1 + n[..., 2]))

        blocks.append((mapping, (radial, around, along)))
    return _model(blocks, pieces, "tube")


def _core_cube(n: np.ndarray) -> np.ndarray:
    """The bulged core of the unit ball."""
    half = _CORE / np.sqrt(3)
    squares = _BULGE * (1 - n * n)
    bulge = np.stack([squares[..., [1, 2]], squares[..., [2, 0]], squares[..., [0, 1]]], axis=-2)
    return half * n * (1 + bulge).prod(axis=-1)


def ball(radius: float = 1.0, divisions: Divisions = 4, pieces: int = 2) -> BlockModel:
    """A ball of seven blocks, times pieces cubed. divisions: (around, radial)."""
    _positive(radius=radius)
    around, radial = _counts(divisions, ("around", "radial"))
    blocks: List[Block] = [(lambda n: radius * _core_cube(n), (around, around, around))]
    for face in _CUBE_FACES:

        def mapping(n: np.ndarray, face: np.ndarray = face) -> np.ndarray:
            s, t = n[..., 0], n[..., 1]
            w = 0.5 * (1 + n[..., 2])[..., None]
            inner = _core_cube(_xyz(s, t, 1.0))
            return radius * ((1 - w) * inner + w * _cube_direction(s, t)) @ face.T

        blocks.append((mapping, (around, around, radial)))
    return _model(blocks, pieces, "ball")


def _core_half(s: np.ndarray, t: np.ndarray, w: np.ndarray) -> np.ndarray:
    """The core of the upper half of the unit ball, w in [-1, 1] from its base up: the directions of
    the hemisphere's patches, drawn in, so that the blocks round it run straight out."""
    base = _core_square(s, t)
    top = _CORE * _cap_direction(s, t)
    # The top is a little flatter than the sphere inside it.
    top = _xyz(top[..., 0], top[..., 1], _CORE * (0.75 + 0.25 * top[..., 2] / _CORE) * 0.9)
    up = 0.5 * (1 + w)
    plane = (1 - up)[..., None] * base + up[..., None] * top[..., :2]
    return _xyz(plane[..., 0], plane[..., 1], up * top[..., 2])


def half_ball(radius: float = 1.0, divisions: Divisions = 4, pieces: int = 2) -> BlockModel:
    """The upper half of a ball of six blocks, times pieces cubed.

    divisions: (around, radial, up)."""
    _positive(radius=radius)
    around, radial, up = _counts(divisions, ("around", "radial", "up"))

    def core(n: np.ndarray) -> np.ndarray:
        return radius * _core_half(n[..., 0], n[..., 1], n[..., 2])

    def top(n: np.ndarray) -> np.ndarray:
        s, t = n[..., 0], n[..., 1]
        w = 0.5 * (1 + n[..., 2])[..., None]
        inner = _core_half(s, t, np.ones_like(s))
        return radius * ((1 - w) * inner + w * _cap_direction(s, t))

    blocks: List[Block] = [(core, (around, around, up)), (top, (around, around, radial))]
    for quarter in range(4):

        def side(n: np.ndarray, quarter: int = quarter) -> np.ndarray:
            s, t = n[..., 0], n[..., 1]
            w = 0.5 * (1 + n[..., 2])[..., None]
            wall = _core_half(np.ones_like(s), s, t)
            xy = _turned(wall[..., :2], quarter)
            inner = _xyz(xy[..., 0], xy[..., 1], wall[..., 2])
            return radius * ((1 - w) * inner + w * _side_direction(s, t, quarter))

        blocks.append((side, (around, up, radial)))
    return _model(blocks, pieces, "half ball")


def torus(
    radius: float = 1.0, tube_radius: float = 0.25, divisions: Divisions = 4, pieces: int = 1
) -> BlockModel:
    """A torus of twenty blocks. divisions: (around, radial, along); along counts a quarter of the
    ring, around a quarter of its section."""
    _check_torus(radius, tube_radius)
    around, radial, along = _counts(divisions, ("around", "radial", "along"))
    blocks: List[Block] = []
    for ring in range(4):
        for plane_map, kind in _disc_maps():

            def mapping(
                n: np.ndarray, ring: int = ring, plane_map: Callable[..., np.ndarray] = plane_map
            ) -> np.ndarray:
                # Against the ring's sense, so that the block is right-handed.
                section = tube_radius * plane_map(n[..., 0], n[..., 1])
                return _swept(section, -n[..., 2], ring, radius)

            blocks.append((mapping, (around if kind == "core" else radial, around, along)))
    return _model(blocks, pieces, "torus")


def wedge(
    length: float = 1.0,
    width: float = 1.0,
    height: float = 1.0,
    divisions: Divisions = 4,
    pieces: int = 1,
) -> BlockModel:
    """A ramp: the right-angled triangle of sides length along x and height along z, drawn by width
    along y. Three blocks. divisions: (section, along); an edge of the section has 2 section."""
    _positive(length=length, width=width, height=height)
    section, along = _counts(divisions, ("section", "along"))
    corners = np.array([[0.0, 0.0], [length, 0.0], [0.0, height]])
    blocks: List[Block] = []
    for corner in range(3):

        def mapping(n: np.ndarray, corner: int = corner) -> np.ndarray:
            plane = _triangle_part(n[..., :2], corner) @ corners
            # From the far side: (x, z) with -y is right-handed.
            return _xyz(plane[..., 0], 0.5 * width * (1 - n[..., 2]), plane[..., 1])

        blocks.append((mapping, (section, section, along)))
    return _model(blocks, pieces, "wedge")


#: All shapes by name, surfaces first; for menus.
NAMES: Tuple[str, ...] = (
    "square",
    "disc",
    "cylinder_surface",
    "cone_surface",
    "hemisphere",
    "sphere_surface",
    "torus_surface",
    "cube",
    "box",
    "cylinder",
    "cone",
    "tube",
    "ball",
    "half_ball",
    "torus",
    "wedge",
)
