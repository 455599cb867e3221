# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn of a mesh: counted by closed forms, areas compared with the shape's own."""

import numpy as np
import pytest

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.plot import PlotOptions, plot

NX, NY, NZ = 2, 3, 4


@pytest.fixture(scope="module")
def hexes():
    return nmgs.shapes.box(2.0, 3.0, 4.0, divisions=(NX, NY, NZ)).generate()


def area(drawn):
    total = 0.0
    for polygons in drawn.polygons:
        corners = drawn.points[polygons].astype(float)
        for a, b in zip(range(1, polygons.shape[1] - 1), range(2, polygons.shape[1])):
            sides = corners[:, a] - corners[:, 0], corners[:, b] - corners[:, 0]
            total += 0.5 * np.linalg.norm(np.cross(*sides), axis=1).sum()
    return total


def test_the_boundary_of_a_box(hexes):
    drawn = plot(hexes)
    assert len(drawn.polygons[1]) == 2 * (NX * NY + NY * NZ + NZ * NX) and not len(
        drawn.polygons[0]
    )
    assert area(drawn) == pytest.approx(2 * (6 + 12 + 8))
    # Euler's formula for a sphere of polygons.
    assert len(drawn.points) - len(drawn.lines) + len(drawn.polygons[1]) == 2


@pytest.mark.parametrize("direction, size", [(0, 12.0), (1, 8.0), (2, 6.0)])
def test_faces_of_one_direction(hexes, direction, size):
    shown = tuple(d == direction for d in range(3))
    drawn = plot(hexes, PlotOptions(directions=shown))
    assert area(drawn) == pytest.approx(2 * size)
    spread = np.ptp(drawn.points[drawn.polygons[1]], axis=1)
    assert np.allclose(spread[:, direction], 0)


def test_simplices(hexes):
    drawn = plot(hexes, PlotOptions(simplices=True))
    assert drawn.types == ["tetra"]
    assert len(drawn.polygons[0]) == 4 * (NX * NY + NY * NZ + NZ * NX)
    assert area(drawn) == pytest.approx(52)


def test_a_cut_leaves_whole_cells(hexes):
    drawn = plot(hexes, PlotOptions(cut=((1.0, 0, 0), (1.0, 0, 0))))
    assert drawn.points[:, 0].max() == pytest.approx(1.0)
    assert area(drawn) == pytest.approx(2 * (3 + 12 + 4))
    assert set(drawn.cells[1][:, 1]) == {
        n for n in range(24) if hexes.points[hexes.cells["hexahedron"][n], 0].mean() < 1
    }
    assert not len(plot(hexes, PlotOptions(cut=((0, 0, 0), (0, 0, 1)))).points)
    with pytest.raises(ValueError, match="normal"):
        plot(hexes, PlotOptions(cut=((0, 0, 0), (0, 0, 0))))


def test_shrunk_cells_have_all_their_faces(hexes):
    drawn = plot(hexes, PlotOptions(shrink=0.5))
    # All but the inner (NX - 2)(NY - 2)(NZ - 2) cells are at the boundary; here that is all.
    assert len(drawn.polygons[1]) == 6 * NX * NY * NZ
    assert area(drawn) == pytest.approx(6 * NX * NY * NZ * 0.25)
    with pytest.raises(ValueError, match="shrink"):
        PlotOptions(shrink=1.0)


def test_some_cells_alone(hexes):
    drawn = plot(hexes, only={"hexahedron": [5]})
    assert len(drawn.polygons[1]) == 6 and (drawn.cells[1] == [0, 5]).all()
    assert not len(plot(hexes, only={}).points)


def test_quadratic_cells_are_drawn_through_their_mid_side_nodes():
    disc = nmgs.shapes.disc(1.0, divisions=3).generate(order=2)
    assert area(plot(disc)) == pytest.approx(disc.report().area, rel=2e-2)
    flat = nmgs.shapes.box(2, 3, 4, divisions=2).generate(order=2)
    drawn = plot(flat)
    assert area(drawn) == pytest.approx(52)
    assert len(drawn.lines) == 2 * (4 * 12 // 2 * 2)
    shrunk = plot(flat, PlotOptions(shrink=0.5))
    assert area(shrunk) == pytest.approx(8 * 52 / 4 * 0.25)


def test_lines_of_a_surface_along_one_direction():
    square = nmgs.shapes.square(1.0, divisions=(3, 2)).generate()
    along_xi = plot(square, PlotOptions(directions=(True, False, True)))
    assert not len(along_xi.polygons[1]) and len(along_xi.lines) == 3 * 3
    both = plot(square)
    assert len(both.polygons[1]) == 6 and len(both.lines) == 3 * 3 + 4 * 2


def test_values_belong_to_their_cells():
    wedge = nmgs.shapes.wedge(divisions=2).generate()
    drawn = plot(wedge)
    quality = wedge.quality()["hexahedron"]
    assert np.array_equal(drawn.cell_values("scaled_jacobian")[1], quality[drawn.cells[1][:, 1]])
