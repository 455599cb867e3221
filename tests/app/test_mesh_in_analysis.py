# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FEM workbench takes the mesh objects as they are: a bar in tension, solved by CalculiX."""

import shutil

import pytest

from freecad.NMGSWorkbench.fem.analysis import solve, static_analysis
from freecad.NMGSWorkbench.objects import blocks, structured_mesh

pytestmark = pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")


@pytest.mark.parametrize("order", [1, 2])
def test_structured_mesh(document, box, order, tmp_path):
    laid = blocks.make(document)
    laid.Source = [(box, ("Solid1",))]
    laid.Size = 5
    made = structured_mesh.make(document)
    made.Blocks, made.Order = laid, order
    document.recompute()
    # Face5 and Face6 are bottom and top; the load is along its face's normal.
    analysis = static_analysis(box, made, ["Face5"], ["Face6"], 1000.0)
    result = solve(analysis, str(tmp_path))
    assert len(result.NodeNumbers) == made.NodeCount
    longest = max(abs(vector.z) for vector in result.DisplacementVectors)
    # F L / (E A) of a bar; the held end cannot bulge, which makes it a little stiffer.
    assert longest == pytest.approx(1000 * 30 / (210000 * 200), rel=0.06)
