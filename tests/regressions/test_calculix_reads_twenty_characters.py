# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX stopped at coordinates like -1.7763568394002505E-15: it reads 20 characters a number."""

import numpy as np

from freecad.NMGSWorkbench import nmgs


def test_coordinates_fit_into_twenty_characters(tmp_path):
    points = np.array([[-1.7763568394002505e-15, -1 / 3, 1e300], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    path = tmp_path / "mesh.inp"
    nmgs.write(path, nmgs.Mesh(points, {"tetra": [[0, 1, 2, 3]]}))
    lines = path.read_text().split("*ELEMENT")[0].splitlines()[3:]
    written = [[field.strip() for field in line.split(",")[1:]] for line in lines]
    assert max(len(field) for row in written for field in row) <= 20
    assert np.allclose(np.array(written, dtype=float), points, rtol=1e-13, atol=0)
