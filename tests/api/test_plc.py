# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLC: arrays, checks before meshing, mends."""

import numpy as np
import pytest
from tetgen_cases import (
    CUBE,
    CUBE_FACETS,
    check_mesh,
    crossing_plc,
    cube,
    rotation,
    surface_volume,
    together,
)

from freecad.NMGSWorkbench import nmgs


def faults(plc, **options):
    return sorted({problem.fault for problem in plc.check(**options)})


def test_accepts_every_form_of_facet():
    quads = nmgs.PLC(CUBE, np.array(CUBE_FACETS))
    lists = nmgs.PLC(CUBE, CUBE_FACETS)
    nested = nmgs.PLC(CUBE, [[f] for f in CUBE_FACETS])
    for plc in (quads, lists, nested):
        assert len(plc) == 6
        assert [f[0].tolist() for f in map(plc.facet, range(6))] == CUBE_FACETS


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"points": [[0, 0]], "facets": []}, "points: expected shape"),
        ({"points": [[0, 0, float("inf")]], "facets": []}, "points: row 0"),
        ({"points": CUBE, "facets": [[0, 1, 8]]}, "facet 0 has node 8"),
        ({"points": CUBE, "facets": [[0, 1, 2], [0, -1, 2]]}, "facet 1 has node -1"),
        ({"points": CUBE, "facets": [[0.5, 1, 2]]}, "facet 0"),
        ({"points": CUBE, "facets": [[0, 1, 2]], "markers": [1, 2]}, "markers: expected 1"),
        ({"points": CUBE, "facets": [[0, 1, 2]], "regions": [[1, 2, 3]]}, "regions"),
        ({"points": CUBE, "facets": [[0, 1, 2]], "facet_holes": {1: [[0, 0, 0]]}}, "facet_holes"),
        ({"points": CUBE, "facets": [], "point_sizes": [1]}, "point_sizes: expected 8"),
    ],
)
def test_bad_arrays_are_named(arguments, words):
    with pytest.raises(ValueError, match=words):
        nmgs.PLC(**arguments)


def test_a_good_plc_has_no_problems():
    assert cube().check() == []
    assert together(cube(), cube(0.5, at=(3, 0, 0))).check() == []


def test_shared_inner_facet_is_no_problem():
    points = np.vstack([CUBE, CUBE[[1, 3, 5, 7]] + [1, 0, 0]])
    second = [[1, 8, 9, 3], [5, 7, 11, 10], [1, 5, 10, 8], [3, 9, 11, 7], [8, 10, 11, 9]]
    plc = nmgs.PLC(points, CUBE_FACETS + second)
    assert not {"crossing_facets", "open_edge", "duplicate_facet"} & set(faults(plc))


def test_facet_with_hole_and_segment():
    points = np.vstack([CUBE, [[0.25, 0.25, 0], [0.75, 0.25, 0], [0.75, 0.75, 0], [0.25, 0.75, 0]]])
    bottom = [[0, 2, 3, 1], [8, 9, 10, 11]]
    holed = nmgs.PLC(points, [bottom, *CUBE_FACETS[1:]], facet_holes={0: [[0.5, 0.5, 0]]})
    assert faults(holed) == ["open_edge"]
    inlaid = nmgs.PLC(points, [bottom, *CUBE_FACETS[1:]])  # the inner polygon is not cut out
    assert faults(inlaid) == []
    covered = nmgs.PLC(
        points, [bottom, *CUBE_FACETS[1:], [8, 9, 10, 11]], facet_holes={0: [[0.5, 0.5, 0]]}
    )
    assert not {"open_edge", "crossing_facets"} & set(faults(covered))
    check_mesh(nmgs.tetrahedralize(covered, "p"), volume=1.0)


def test_each_fault_is_found_with_its_place():
    twice = nmgs.PLC(np.vstack([CUBE, CUBE[:1]]), [[8, 2, 3, 1], *CUBE_FACETS[1:]])
    (problem,) = twice.check()
    assert (problem.fault, problem.points) == ("duplicate_point", (8, 0))

    line = nmgs.PLC(np.vstack([CUBE, [[0.5, 0, 0]]]), [*CUBE_FACETS, [0, 8, 1]])
    assert "degenerate_facet" in faults(line)

    doubled = nmgs.PLC(CUBE, [*CUBE_FACETS, CUBE_FACETS[2][::-1]])
    found = [p for p in doubled.check() if p.fault == "duplicate_facet"]
    assert [p.facets for p in found] == [(6, 2)]

    bent = CUBE.copy()
    bent[0] += [0, 0, -0.1]
    found = [p for p in nmgs.PLC(bent, CUBE_FACETS).check() if p.fault == "nonplanar_facet"]
    assert (0,) in [p.facets for p in found]
    # Newell's plane of a unit square with one corner 0.1 down: all corners are 0.025 off, nearly.
    assert found[0].amount == pytest.approx(0.025, rel=0.02)

    opened = nmgs.PLC(CUBE, CUBE_FACETS[1:])
    found = opened.check()
    assert {p.fault for p in found} == {"open_edge"}
    assert {p.points for p in found} == {(0, 1), (1, 3), (2, 3), (0, 2)}

    turned = nmgs.PLC(CUBE, [CUBE_FACETS[0][::-1], *CUBE_FACETS[1:]])
    assert [(p.fault, p.facets) for p in turned.check()] == [("flipped_facet", (0,))]

    inside = nmgs.PLC(CUBE, [f[::-1] for f in CUBE_FACETS])
    (problem,) = inside.check()
    assert problem.fault == "inside_out"
    assert problem.amount == pytest.approx(1.0)

    outside = nmgs.PLC(CUBE, CUBE_FACETS, holes=[[2, 2, 2]], regions=[[0.5, 0.5, 0.5, 1]])
    assert [(p.fault, p.points) for p in outside.check()] == [("hole_outside", (0,))]


def test_a_cavity_looks_inwards():
    inner = cube(0.5, at=(0.25, 0.25, 0.25))
    flipped = nmgs.PLC(inner.points, [inner.facet(f)[0][::-1] for f in range(6)])
    assert together(cube(), flipped).check() == []
    assert faults(together(cube(), inner)) == ["inside_out"]


def test_crossing_facets_and_where():
    triangle = np.array([[0.5, 0.5, -0.5], [0.5, 0.5, 0.5], [0.9, 0.2, 0.5]])
    plc = together(cube(), nmgs.PLC(triangle, [[0, 1, 2]]))
    crossing = [p for p in plc.check() if p.fault == "crossing_facets"]
    assert [p.facets for p in crossing] == [(0, 6)]
    assert crossing[0].place[2] == 0


@pytest.mark.parametrize("gap", [1e-6, 1e-9, 0.0])
def test_depth_decides_beyond_the_tolerance(gap):
    """Two unit cubes overlap by the gap: beyond 1e-8 of the size they cross."""
    plc = together(cube(), cube(at=(1 - gap, 0.25, 0.25)))
    found = "crossing_facets" in faults(plc)
    assert found  # facets that lie in each other without shared edges intersect at any depth
    apart = together(cube(), cube(at=(1 + 1e-6, 0.25, 0.25)))
    assert apart.check() == []


@pytest.mark.parametrize("seed", range(20))
def test_crossings_agree_with_sampling(seed):
    """Brute force over triangles in double precision, for boxes in general position."""
    plc = crossing_plc(seed)
    found = {p.facets for p in plc.check() if p.fault == "crossing_facets"}
    expected = set()
    for a in range(len(plc)):
        for b in range(a):
            if a // 6 != b // 6 and quads_cross(
                plc.points[plc.facet(a)[0]], plc.points[plc.facet(b)[0]]
            ):
                expected.add((b, a))
    assert found == expected


def quads_cross(p, q):
    return edge_pierces(p, q) or edge_pierces(q, p)


def edge_pierces(p, q):
    """An edge of one parallelogram goes through the other."""
    normal = np.cross(q[1] - q[0], q[3] - q[0])
    for k in range(4):
        a, b = p[k], p[(k + 1) % 4]
        da, db = (a - q[0]) @ normal, (b - q[0]) @ normal
        if da * db < 0:
            x = a + da / (da - db) * (b - a) - q[0]
            s, t = np.linalg.lstsq(np.column_stack([q[1] - q[0], q[3] - q[0]]), x, rcond=None)[0]
            if 0 < s < 1 and 0 < t < 1:
                return True
    return False


def test_any_place_and_size_gives_the_same_answer():
    random = np.random.default_rng(5)
    plc = crossing_plc(1)
    facets = [p.facets for p in plc.check()]
    for scale in (1e-6, 1e6):
        moved = crossing_plc(1)
        moved.points = (moved.points * scale) @ rotation(random).T
        assert [p.facets for p in moved.check()] == facets


def test_mend_says_what_it_did_and_changes_no_geometry():
    points = np.vstack([CUBE, CUBE[:4], [[0.5, 0, 0]]])
    facets = [[8, 10, 11, 9], *CUBE_FACETS[1:], CUBE_FACETS[1], [0, 12, 1]]
    facets[3] = facets[3][::-1]
    plc = nmgs.PLC(points, facets, markers=[1, 2, 3, 4, 5, 6, 7, 8])
    mended = plc.mend()
    assert mended.notes == [
        "merged 4 duplicate points",
        "removed 1 facets without area",
        "removed 1 duplicate facets",
        "turned 1 facets",
    ]
    assert mended.check() == []
    assert mended.old_facets.tolist() == [0, 1, 2, 3, 4, 5]
    assert mended.markers.tolist() == [1, 2, 3, 4, 5, 6]
    assert surface_volume(mended) == pytest.approx(1.0, rel=1e-15)
    check_mesh(nmgs.tetrahedralize(mended, "pq"), volume=1.0)
    assert plc.check() != []  # the old one is as it was


def test_mend_leaves_a_good_plc_alone():
    mended = cube().mend()
    assert mended.notes == []
    assert np.array_equal(mended.polygon_nodes, cube().polygon_nodes)
    assert np.array_equal(mended.points, CUBE)


def test_cancel():
    with pytest.raises(nmgs.Cancelled):
        cube().check(progress=lambda _: False)
