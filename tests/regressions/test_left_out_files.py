# SPDX-License-Identifier: LGPL-2.1-or-later
"""TetGen 1.6 wrote the triangles that it left out into the folder for temporary files, and there
they stayed whenever it ended by itself."""

import pathlib
import tempfile

import numpy as np
import pytest

from freecad.NMGSWorkbench import nmgs

TURNED = np.array([[0.2, 0.2, -0.5], [0.8, 0.3, 1.5], [0.3, 0.8, 1.5]])
CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
FACETS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def left_out():
    return set(pathlib.Path(tempfile.gettempdir()).glob("nmgs-tet-*"))


@pytest.mark.parametrize("switches", ("p", "pd", "pq"))
def test_no_file_stays(switches):
    plc = nmgs.PLC(np.vstack([CUBE, TURNED]), [*FACETS, [8, 9, 10]])
    before = left_out()
    try:
        nmgs.tetrahedralize(plc, switches)
    except nmgs.TetGenError as error:
        assert 6 in error.facets
    assert left_out() <= before
