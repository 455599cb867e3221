# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts, sizes, quality and worst cells of a mesh."""

import numpy as np
import pytest
from blocks import bent_blocks, bent_patches, cube

from freecad.NMGSWorkbench import nmgs


def test_cube():
    report = cube((2, 3, 4)).generate().report()
    assert report.counts == {"points": 60, "hexahedron": 24}
    assert report.bounds.tolist() == [[0, 0, 0], [1, 1, 1]]
    assert report.volume == pytest.approx(1)
    assert report.area == pytest.approx(6)
    summary = report.metrics["hexahedron"]["scaled_jacobian"]
    assert summary.worst == pytest.approx(1) and summary.mean == pytest.approx(1)
    assert summary.histogram.sum() == 24


@pytest.mark.parametrize("make", [bent_blocks, bent_patches])
def test_summaries_agree_with_the_metrics(make):
    mesh = make().generate()
    report = mesh.report(bins=7, worst=5)
    (cell_type,) = report.metrics
    for metric, summary in report.metrics[cell_type].items():
        values = mesh.quality(metric)[cell_type]
        ordered = np.sort(values)
        better_high = metric in ("scaled_jacobian", "shape", "min_angle")
        worst = ordered[:5] if better_high else ordered[::-1][:5]
        assert summary.worst_values == pytest.approx(worst)
        assert (values[summary.worst_cells] == summary.worst_values).all()
        assert summary.worst == worst[0]
        assert summary.best == (ordered[-1] if better_high else ordered[0])
        assert summary.mean == pytest.approx(values.mean())
        assert len(summary.histogram) == 7 and summary.histogram.sum() == len(values)
        places = mesh.points[mesh.cells[cell_type][summary.worst_cells]].mean(axis=1)
        assert summary.worst_places == pytest.approx(places)


def test_flat_cell_is_the_worst_and_does_not_spoil_the_mean():
    points = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0.5, 3**0.5 / 2, 0]]
    mesh = nmgs.Mesh(points, {"triangle": [[0, 1, 3], [0, 1, 2]]})
    summary = mesh.report().metrics["triangle"]["aspect_ratio"]
    assert summary.worst == np.inf and summary.worst_cells[0] == 1
    assert summary.mean == pytest.approx(1) and summary.infinite == 1
    assert summary.histogram.sum() == 1


def test_text_names_everything():
    mesh = bent_blocks().generate()
    mesh.groups["inlet"] = ("node", np.arange(3, dtype=np.int32))
    text = str(mesh.report())
    for word in ("hexahedron", "volume", "inlet", "3 node", "scaled_jacobian", "0.90 to   1.00"):
        assert word in text


def test_quadratic_mesh():
    report = cube((1, 1, 1)).generate().to_order(2).report()
    metrics = report.metrics["hexahedron20"]
    assert metrics["jacobian_ratio"].worst == pytest.approx(1)
    assert metrics["min_jacobian"].worst == pytest.approx(1)
    assert report.volume == pytest.approx(1) and report.area == pytest.approx(6)


def test_empty_mesh_and_bad_arguments():
    empty = nmgs.Mesh(np.zeros((0, 3)), {})
    assert empty.report().counts == {"points": 0}
    assert "points" in str(empty.report())
    with pytest.raises(ValueError, match="bins.*0"):
        empty.report(bins=0)
    with pytest.raises(ValueError, match="worst.*-1"):
        empty.report(worst=-1)
