# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worker's answer is looked over before it is used."""

import numpy as np
import pytest
from tetgen_cases import cube

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.tetgen import worker
from freecad.NMGSWorkbench.nmgs.tetgen.validity import fault_of

POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)
TETRA = np.array([[0, 1, 2, 3], [1, 2, 3, 4]], np.int32)


def answer(**changes):
    arrays = {
        "points": POINTS,
        "tetra": np.array([[0, 1, 2, 3], [1, 2, 3, 4]], np.int32),
        "triangles": np.array([[0, 2, 1]], np.int32),
        "triangle_markers": np.array([1], np.int32),
        "neighbours": np.array([[1, -1, -1, -1], [-1, -1, -1, 0]], np.int32),
    }
    arrays.update(changes)
    return arrays


def test_valid_answers():
    assert fault_of(answer()) == ""
    assert fault_of(answer(tetra=TETRA[:, [1, 0, 2, 3]]), -1) == ""
    assert fault_of({"points": POINTS}) == ""
    # Thinner than floating point can tell, and right.
    thin = POINTS * [1, 1, 1e-200]
    assert fault_of({"points": thin, "tetra": TETRA[:1]}) == ""


@pytest.mark.parametrize(
    "changes, words",
    [
        ({"tetra": TETRA[:, [1, 0, 2, 3]]}, "tetrahedron 0 has the volume"),
        ({"points": POINTS * [1, 1, 0]}, "tetrahedron 0 has the volume 0"),
        ({"tetra": TETRA + 1}, "row 1 of tetra has a number outside 0 to 4"),
        ({"triangles": -TETRA[:1, :3]}, "row 0 of triangles"),
        ({"neighbours": np.full((2, 4), 2, np.int32)}, "row 0 of neighbours"),
        ({"triangle_markers": np.zeros(3, np.int32)}, "3 triangle_markers for 1 triangles"),
        ({"points": POINTS * np.nan}, "node 0 is not finite"),
    ],
)
def test_faults_are_named(changes, words):
    assert words in fault_of(answer(**changes))


def test_an_invalid_answer_is_an_error(monkeypatch):
    run = worker.run

    def spoilt(*args, **kwargs):
        outcome = run(*args, **kwargs)
        outcome.arrays["tetra"][:, [0, 1]] = outcome.arrays["tetra"][:, [1, 0]]
        return outcome

    monkeypatch.setattr(worker, "run", spoilt)
    with pytest.raises(nmgs.TetGenError, match="not valid: tetrahedron 0"):
        nmgs.tetrahedralize(cube(), "p")
