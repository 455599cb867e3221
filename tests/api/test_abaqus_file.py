# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input files, read back by CalculiX and by meshio."""

import subprocess

import FreeCAD  # noqa: F401
import numpy as np
import Part
import pytest

from freecad.NMGSWorkbench import nmgs

DECK = """*INCLUDE, INPUT=mesh.inp
*MATERIAL, NAME=M
*ELASTIC
1000., 0.
*SOLID SECTION, ELSET=Solid1, MATERIAL=M
*BOUNDARY
{held}, 1, 3
*STEP
*STATIC
*DLOAD
{pulled}, P, -10.
*NODE PRINT, NSET={pulled}
U
*EL PRINT, ELSET=Solid1, TOTALS=ONLY
EVOL
*END STEP
"""

MESHES = {
    "hexahedron": lambda model: model.generate(),
    "hexahedron20": lambda model: model.generate(order=2),
    "tetra": lambda model: model.generate().split(),
    "tetra10": lambda model: model.generate().split().to_order(2),
}


@pytest.mark.parametrize("kind", MESHES)
def test_calculix_reads_elements_sets_and_surfaces(kind, tmp_path):
    """A bar of 4 x 1 x 1 pulled by 10 at E = 1000 without contraction grows by 10 / 1000 * 4."""
    shape = Part.makeBox(4, 1, 1)
    held, pulled = (
        [f"Face{n}" for n, f in enumerate(shape.Faces, 1) if abs(f.CenterOfMass.x - x) < 1e-9][0]
        for x in (0, 4)
    )
    mesh = MESHES[kind](nmgs.fit(shape, size=0.5))
    assert kind in mesh.cells
    nmgs.write(tmp_path / "mesh.inp", mesh)
    (tmp_path / "run.inp").write_text(DECK.format(held=held, pulled=pulled))
    done = subprocess.run(
        ["ccx", "run"], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    assert "ERROR" not in done.stdout, done.stdout[-2000:]
    lines = (tmp_path / "run.dat").read_text().splitlines()
    values = [line.split() for line in lines if line.strip()]
    moves = [[float(v) for v in row[1:]] for row in values if len(row) == 4 and row[0].isdigit()]
    assert np.allclose(moves, [[0.04, 0, 0]], atol=1e-6)
    volume = [float(row[0]) for row in values if len(row) == 1][-1]
    assert volume == pytest.approx(4.0, rel=1e-5)


@pytest.mark.parametrize("extension", ("inp", "vtu"))
@pytest.mark.parametrize("kind", MESHES)
def test_meshio_reads_it_back(kind, extension, tmp_path):
    import meshio

    mesh = MESHES[kind](nmgs.fit(Part.makeBox(4, 1, 1), size=0.5))
    path = tmp_path / f"mesh.{extension}"
    nmgs.write(path, mesh)
    back = meshio.read(path)
    assert np.allclose(back.points, mesh.points, rtol=1e-13, atol=1e-13)
    assert (back.cells_dict[kind] == mesh.cells[kind]).all()
    again = nmgs.read(path)
    assert (again.cells[kind] == mesh.cells[kind]).all()


def test_pieces_that_have_no_element_are_refused_and_the_file_stays(tmp_path):
    path = tmp_path / "mesh.inp"
    path.write_text("mine")
    pyramid = nmgs.Mesh(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]], {"pyramid": [[0, 1, 2, 3, 4]]}
    )
    with pytest.raises(ValueError, match="pyramid"):
        nmgs.write(path, pyramid)
    assert path.read_text() == "mine"
    assert [p.name for p in tmp_path.iterdir()] == ["mesh.inp"]


def test_unreadable_files_are_named(tmp_path):
    path = tmp_path / "mesh.vtu"
    path.write_text("<nonsense")
    with pytest.raises(nmgs.FormatError, match="mesh.vtu"):
        nmgs.read(path)
    with pytest.raises(FileNotFoundError, match="missing.inp"):
        nmgs.read(tmp_path / "missing.inp")
