# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every switch of TetGen 1.5 and 1.6 as a row: name, letter, default, range, sentence.

The rows were read off TetGen's own command line parser; the sentences follow its manual.
"""

from __future__ import annotations

from typing import Any, Dict, NamedTuple, Optional, Tuple

BOTH = ("1.5", "1.6")


class Switch(NamedTuple):
    """One option. slot: None for the switch itself, n for the n-th number behind it (from 0)."""

    name: str
    letter: str
    slot: Optional[int]
    default: Any  # its type is the option's: bool, int or float; None: no limit
    low: float
    high: float
    versions: Tuple[str, ...]
    sentence: str
    suffix: str = ""  # of a flag: "1" of "X1"
    number: type = float  # of the value where the default is None


def _flag(name: str, letter: str, sentence: str, versions: Any = BOTH, suffix: str = "") -> Switch:
    return Switch(name, letter, None, False, 0, 1, versions, sentence, suffix)


def _count(name: str, letter: str, most: int, sentence: str, versions: Any = BOTH) -> Switch:
    return Switch(name, letter, None, 0, 0, most, versions, sentence)


def _number(
    name: str, letter: str, slot: int, default: Any, low: float, high: float, sentence: str,
    versions: Any = BOTH,
) -> Switch:  # fmt: skip
    number = type(default) if default is not None else float
    return Switch(name, letter, slot, default, low, high, versions, sentence, "", number)


INFINITY = float("inf")
V15, V16 = ("1.5",), ("1.6",)

SWITCHES: Tuple[Switch, ...] = (
    _flag("plc", "p", "Meshes a piecewise linear complex: its facets are kept."),
    _number("facet_angle", "p", 0, 179.9, 0.0, 180.0,
            "Facets that meet at a larger dihedral angle, in degrees, count as one plane."),
    _number("small_facet_angle", "p", 2, 15.0, 0.0, 180.0,
            "Facets that meet at a smaller dihedral angle, in degrees, are treated as sharp.", V16),
    _number("collinear_angle", "p", 3, 179.9, 0.0, 180.0,
            "Segments that meet at a larger angle, in degrees, count as one line.", V16),
    _count("keep_boundary", "Y", 1, "Keeps the boundary's triangles as they are.", V15),
    _count("keep_boundary", "Y", 2,
           "Keeps the boundary's triangles; 2: no Steiner points on the boundary at all.", V16),
    _number("suppress_steiner", "Y", 0, 2, 0, 9,
            "Steiner points: 0 stay in the boundary, 1 move inside, 2 are removed too.", V15),
    _number("suppress_steiner", "Y", 1, 2, 0, 9,
            "Steiner points: 0 stay in the boundary, 1 move inside, 2 are removed too.", V16),
    _number("add_steiner", "Y", 1, 1, 0, 9,
            "With Y, how Steiner points are put into segments: algorithm 1 or 2.", V15),
    _number("add_steiner", "Y", 2, 1, 0, 9,
            "With Y, how Steiner points are put into segments: algorithm 1 or 2.", V16),
    _flag("refine", "r", "Refines or rebuilds a mesh of tetrahedra."),
    _number("growth_ratio", "r", 0, 0.0, 0.0, INFINITY,
            "Refinement stops when the mesh has grown by this ratio; 0: no limit.", V16),
    _number("refine_progress", "r", 1, 0.333, 0.0, INFINITY,
            "Least share of bad elements that each round of refinement must remove.", V16),
    _flag("quality", "q", "Refines the mesh until its elements are well shaped."),
    _number("radius_edge_ratio", "q", 0, 2.0, 0.0, INFINITY,
            "Largest ratio of a tetrahedron's circumradius to its shortest edge."),
    _number("min_dihedral", "q", 1, 0.0, 0.0, 70.0,
            "Smallest dihedral angle of a tetrahedron, in degrees.", V15),
    _number("min_dihedral", "q", 1, 3.5, 0.0, 70.0,
            "Smallest dihedral angle of a tetrahedron, in degrees.", V16),
    _number("max_dihedral", "o", 1, 165.0, 0.0, 180.0,
            "Largest dihedral angle, in degrees, that optimisation leaves.", V15),
    _number("max_dihedral", "o", 1, 177.0, 0.0, 180.0,
            "Largest dihedral angle, in degrees, that optimisation leaves.", V16),
    _number("max_aspect_ratio", "o", 2, 1000.0, 1.0, INFINITY,
            "Largest aspect ratio that optimisation leaves.", V16),
    _number("max_edge_ratio", "o", 3, 100.0, 1.0, INFINITY,
            "Largest ratio of longest to shortest edge that optimisation leaves.", V16),
    _flag("coarsen", "R", "Coarsens the mesh: removes points that sizes or marks make needless."),
    _number("coarsen_by", "R", 0, 0, 0, 9,
            "What is removed: 0 points by marker and size, 1 a fraction of the inner points."),
    _number("coarsen_fraction", "R", 1, 1.0, 0.0, 1.0, "With R1, the fraction of inner points."),
    _flag("region_attributes", "A", "Gives every tetrahedron the attribute of its region."),
    _number("max_volume", "a", 0, None, 0.0, INFINITY, "Largest volume of a tetrahedron."),
    _flag("volumes", "a", "Largest volumes as given for each region, or for each tetrahedron."),
    _flag("sizes", "m", "Edge lengths as given at points, or in a background mesh."),
    _number("size_scale", "m", 0, 1.0, 0.0, INFINITY, "Factor on the given sizes.", V16),
    _flag("insert_points", "i", "Inserts the additional points."),
    _flag("conforming", "D", "Makes the boundary's triangles Delaunay too."),
    _number("conforming_level", "D", 0, 3, 1, 3,
            "What is refined for Delaunay: 1 segments, 2 facets too, 3 tetrahedra too.",
            V15),
    _number("conforming_level", "D", 0, 7, 1, 7,
            "What is refined for quality: sum of 1 segments, 2 facets, 4 tetrahedra.", V16),
    _number("max_steiner", "S", 0, None, 0, 2**31 - 1, "Most points that may be added.")._replace(
        number=int),
    _number("order", "o", 0, 1, 1, 2, "2: tetrahedra of ten nodes."),
    _number("optimization", "O", 0, 2, 0, 9,
            "How hard the mesh is optimised: 0 not at all.", V15),
    _number("optimization", "O", 0, 3, 0, 9,
            "How hard the mesh is optimised by flips: 0 not at all.", V16),
    _number("optimization_scheme", "O", 1, 7, 0, 7,
            "Means of optimisation: sum of 1 flips, 2 smoothing, 4 insertion and removal."),
    _number("optimization_rounds", "O", 2, 3, 0, 9, "Most rounds of optimisation.", V16),
    _number("smooth", "s", 0, 3, 0, 7,
            "Points that are smoothed: sum of 1 inner, 2 on facets, 4 on segments.", V16),
    _number("smooth_rounds", "s", 1, 7, 0, 1000, "Most rounds of smoothing.", V16),
    _number("smooth_factor", "s", 2, 0.3, 0.0, 1.0, "Relaxation of smoothing.", V16),
    _number("tolerance", "T", 0, 1e-8, 0.0, 1.0,
            "Relative tolerance: points this near to a plane lie in it."),
    _flag("convex", "c", "Keeps the tetrahedra outside, out to the convex hull."),
    _flag("diagnose", "d", "Finds facets that intersect, and meshes nothing."),
    _flag("keep_facets", "M", "Does not merge facets in one plane."),
    _flag("keep_points", "M", "Does not merge points that are very close."),
    _flag("weighted", "w", "Weighted Delaunay: the first attribute of each point is its weight."),
    _number("weights_as_heights", "w", 0, 0, 0, 9, "1: the weight is the lifted height itself."),
    _flag("inexact", "X", "No exact arithmetic: faster, and it may fail."),
    _flag("no_static_filter", "X", "Exact arithmetic without the static filter before it.", BOTH,
          "1"),
    _flag("flips", "l", "Delaunay by incremental flips in place of Bowyer-Watson.", V15),
    _flag("flip_insert", "L", "Inserts points by flips in place of cavities."),
    _number("sort_threshold", "b", 0, 64, 0, 2**31 - 1,
            "Points are sorted in rounds of at least this many; 0: not sorted."),
    _number("sort_ratio", "b", 1, 0.125, 0.0, 1.0, "Size of a round over that of the next."),
    _number("hilbert_limit", "b", 2, 8, 1, 2**31 - 1, "Points in a cell of the Hilbert curve."),
    _number("hilbert_order", "b", 3, 52, -1, 60, "Depth of the Hilbert curve; -1: as needed."),
    _count("all_faces", "f", 1, "Returns all triangles, not those of the boundary only."),
    _count("all_edges", "e", 1, "Returns all edges, not the segments only."),
    _count("neighbours", "n", 2, "1: neighbours of tetrahedra; 2: those of triangles too."),
    _flag("voronoi", "v", "Returns the Voronoi diagram of a set of points.", V15),
    _flag("keep_unused", "J", "Keeps points that no tetrahedron uses."),
    _flag("no_markers", "B", "Returns no markers."),
    _flag("no_tetrahedra", "E", "Returns no tetrahedra."),
    _flag("no_triangles", "F", "Returns no triangles and no edges."),
    _flag("reverse", "z", "Turns every tetrahedron inside out.", V16, "1"),
    _count("check", "C", 2, "1: TetGen checks its mesh; 2: and that it is Delaunay."),
    _count("verbose", "V", 4, "How much TetGen tells in its log."),
    _flag("no_warnings", "W", "No warnings in the log.", V16),
    _number("block_size", "x", 0, 8188, 1, 2**31 - 1, "Tetrahedra that memory is got for at once."),
)  # fmt: skip

#: Switches that concern TetGen's own files or screen, accepted and left out: there are none here.
FILE_SWITCHES: Dict[str, str] = {
    "z": "numbers from 0, as all arrays here do",
    "N": "no file of nodes",
    "I": "no numbers in file names",
    "g": "a file for Medit",
    "k": "a file for ParaView",
    "Q": "no output on the screen",
}

#: Switches that cannot work here.
REFUSED: Dict[str, str] = {
    "h": "it prints a help text",
    "?": "it prints a help text",
    "H": "it reads a file; give its points as holes",
    "s": "TetGen 1.5 has it for its own development only",
}


def switches_of(version: str) -> Tuple[Switch, ...]:
    """The rows that TetGen of this version ("1.5" or "1.6") has."""
    return tuple(row for row in SWITCHES if version in row.versions)
