# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input files, read back by CalculiX and by meshio."""

import subprocess
import sys

import FreeCAD  # noqa: F401
import numpy as np
import Part
import pytest
from element_meshes import mixed

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.nmgs.mesh import CELL_TYPES

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

ALL_TYPES = """*INCLUDE, INPUT=mesh.inp
*ELSET, ELSET=All
%s
*MATERIAL, NAME=M
*ELASTIC
1000., 0.
*SOLID SECTION, ELSET=All, MATERIAL=M
*BOUNDARY
Face1, 1, 3
*STEP
*STATIC
*CLOAD
1, 1, 1.
*EL PRINT, ELSET=All, TOTALS=ONLY
EVOL
*END STEP
""" % ",\n".join(
    map(str, range(1, 22))
)
#: Nodes of the sides of C3D8 from Abaqus's manual, 1-based.
ABAQUS_HEXAHEDRON_SIDES = (
    (1, 2, 3, 4),
    (5, 8, 7, 6),
    (1, 5, 6, 2),
    (2, 6, 7, 3),
    (3, 7, 8, 4),
    (4, 8, 5, 1),
)

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
    if extension == "vtu" and sys.version_info >= (3, 13):
        pytest.skip("meshio's reader of .vtu fails with Python 3.13; VTK's is asked elsewhere")
    path = tmp_path / f"mesh.{extension}"
    nmgs.write(path, mesh)
    back = meshio.read(path)
    assert np.allclose(back.points, mesh.points, rtol=1e-13, atol=1e-13)
    assert (back.cells_dict[kind] == mesh.cells[kind]).all()
    again = nmgs.read(path)
    assert (again.cells[kind] == mesh.cells[kind]).all()


@pytest.mark.parametrize("order", (1, 2))
def test_calculix_and_meshio_read_all_types_of_cells(order, tmp_path):
    """The box of 5 x 1 x 1 in hexahedra, wedges, pyramids and tetrahedra has volume 5."""
    mesh = mixed(order)
    mesh.groups["Ends of all"] = ("node", np.array([0, 1]))
    nmgs.write(tmp_path / "mesh.inp", mesh)
    (tmp_path / "run.inp").write_text(ALL_TYPES)
    done = subprocess.run(
        ["ccx", "run"], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    assert "ERROR" not in done.stdout, done.stdout[-2000:]
    rows = [line.split() for line in (tmp_path / "run.dat").read_text().splitlines()]
    volumes = [float(row[0]) for row in rows if len(row) == 1]
    assert sum(volumes) == pytest.approx(5, rel=1e-5)
    back = nmgs.read(tmp_path / "mesh.inp")
    for kind, cells in mesh.cells.items():
        if CELL_TYPES[kind][1] == 3:
            assert np.array_equal(back.cells[kind], cells)
    assert set(back.groups) >= {"Solid1", "Solid2", "Face1", "Edge1", "Vertex1", "Ends_of_all"}


def test_collapsed_surfaces_lie_on_the_right_sides(tmp_path):
    """The side that is named has the nodes of the pyramid's triangle, by Abaqus's own table."""
    points = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 1]]
    for corners in ([0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]):
        mesh = nmgs.Mesh(
            points,
            {"pyramid": [[0, 1, 2, 3, 4]], "triangle": [corners]},
            {"Side": ("triangle", [0])},
        )
        path = tmp_path / "mesh.inp"
        nmgs.write(path, mesh)
        element, side = path.read_text().split("TYPE=ELEMENT\n")[1].split(", ")
        face = ABAQUS_HEXAHEDRON_SIDES[int(side[1]) - 1]
        nodes = [int(n) for n in path.read_text().split("C3D8")[1].splitlines()[1].split(",")[1:]]
        assert {nodes[n - 1] - 1 for n in face} == set(corners)


def test_plane_elements(tmp_path):
    mesh = nmgs.shapes.square(1.0, divisions=2).generate(order=2)
    for plane, name in ((None, "S8"), ("stress", "CPS8"), ("strain", "CPE8")):
        nmgs.write(tmp_path / "mesh.inp", mesh, plane=plane)
        assert f"TYPE={name}," in (tmp_path / "mesh.inp").read_text()
    with pytest.raises(ValueError, match="axial"):
        nmgs.write(tmp_path / "mesh.inp", mesh, plane="axial")
    assert [p.name for p in tmp_path.iterdir()] == ["mesh.inp"]


def test_unreadable_files_are_named(tmp_path):
    path = tmp_path / "mesh.vtu"
    path.write_text("<nonsense")
    with pytest.raises(nmgs.FormatError, match="mesh.vtu"):
        nmgs.read(path)
    with pytest.raises(FileNotFoundError, match="missing.inp"):
        nmgs.read(tmp_path / "missing.inp")
