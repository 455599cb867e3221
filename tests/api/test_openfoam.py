# SPDX-License-Identifier: LGPL-2.1-or-later
"""polyMesh and blockMeshDict, checked by OpenFOAM's own checkMesh and blockMesh."""

import os
import re
import shutil
import subprocess

import FreeCAD
import numpy as np
import Part
import pytest
from element_meshes import MIXED_VOLUME, mixed, unit

from freecad.NMGSWorkbench import nmgs

needs_openfoam = pytest.mark.skipif(
    shutil.which("checkMesh") is None, reason="OpenFOAM is not installed"
)
HEAD = "FoamFile {{ version 2.0; format ascii; class dictionary; object {0}; }}\n"
SCHEMES = ("ddt", "grad", "div", "laplacian", "interpolation", "snGrad")
FILES = {
    "controlDict": "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1;"
    " deltaT 1; writeControl timeStep; writeInterval 1;",
    "fvSchemes": "".join(f"{name}Schemes {{ default none; }}\n" for name in SCHEMES),
    "fvSolution": "",
}


@pytest.fixture
def case(tmp_path):
    (tmp_path / "system").mkdir()
    (tmp_path / "constant").mkdir()
    for name, text in FILES.items():
        (tmp_path / "system" / name).write_text(HEAD.format(name) + text)
    return tmp_path


def run(program, case, *arguments):
    # Debian's programs look for their etc folder by this variable.
    environment = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}
    done = subprocess.run(
        [program, "-case", str(case), *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env=environment,
    )
    assert "FATAL" not in done.stdout, done.stdout[-2000:]
    return done.stdout


def volume_of(text):
    return float(re.search(r"Total volume = ([-0-9.e+]*[0-9])", text).group(1))


def fitted():
    shape = Part.makeCylinder(2, 3, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 90)
    return shape, nmgs.fit(shape, size=0.5)


@needs_openfoam
def test_all_cells_and_groups(case):
    mesh = mixed()
    nmgs.write(case / "constant" / "polyMesh", mesh)
    told = run("checkMesh", case)
    assert "Mesh OK" in told
    counts = {"hexahedra": 2, "prisms": 2, "pyramids": 7, "tetrahedra": 10, "polyhedra": 0}
    for name, count in counts.items():
        assert re.search(rf"{name}:\s+{count}\b", told), name
    assert volume_of(told) == pytest.approx(MIXED_VOLUME, rel=1e-5)
    assert "Face1" in told and "defaultFaces" in told
    assert re.search(r"Solid1\s+2\b", told) and re.search(r"Solid2\s+10\b", told)


@needs_openfoam
def test_faces_of_the_cad_are_patches(case):
    shape, model = fitted()
    mesh = model.generate()
    nmgs.write(case / "constant" / "polyMesh", mesh, scale=0.001)
    told = run("checkMesh", case)
    assert "Mesh OK" in told
    patches = re.findall(r"^\s+(\w+)\s+\d+\s+\d+\s+ok", told, re.M)
    assert set(patches) == {f"Face{n}" for n in range(1, 6)}
    assert volume_of(told) == pytest.approx(mesh.report().volume * 1e-9, rel=1e-5)


@needs_openfoam
def test_blockmesh_makes_the_same_mesh(case):
    shape, model = fitted()
    nmgs.write(case / "system" / "blockMeshDict", model)
    run("blockMesh", case)
    told = run("checkMesh", case)
    assert "Mesh OK" in told
    ours = model.generate()
    assert re.search(rf"cells:\s+{len(ours.cells['hexahedron'])}\b", told)
    assert re.search(rf"points:\s+{len(ours.points)}\b", told)
    assert volume_of(told) == pytest.approx(ours.report().volume, rel=1e-3)
    back = nmgs.read(case / "constant" / "polyMesh")
    assert {name for name in back.groups if name.startswith("Face")} == {
        f"Face{n}" for n in range(1, 6)
    }
    for number, face in enumerate(shape.Faces, 1):
        kind, cells = back.groups[f"Face{number}"]
        corners = back.points[back.cells[kind][cells]].reshape(-1, 3)
        assert all(face.distToShape(Part.Vertex(*p))[0] < 0.01 for p in np.unique(corners, axis=0))


@needs_openfoam
def test_gradings(case):
    """A geometric grading is one ratio, any other a list of the cells: the nodes are ours."""
    planes = (0, 0.1, 0.15, 0.5, 0.6, 0.95, 1)
    for grading in (nmgs.grading.geometric(1.3), nmgs.grading.positions(planes)):
        model = nmgs.shapes.box(3, 2, 1, divisions=[6, 3, 2])
        model.set_grading(0, "xi", grading)
        nmgs.write(case / "system" / "blockMeshDict", model)
        run("blockMesh", case)
        back = nmgs.read(case / "constant" / "polyMesh")
        ours = model.generate().points
        key = np.lexsort(np.round(ours, 6).T)
        other = np.lexsort(np.round(back.points, 6).T)
        assert np.allclose(ours[key], back.points[other], atol=1e-5)


@pytest.mark.parametrize("kind", ("hexahedron", "wedge", "pyramid", "tetra"))
def test_there_and_back(kind, tmp_path):
    mesh = unit(kind)
    nmgs.write(tmp_path / "polyMesh", mesh)
    back = nmgs.read(tmp_path / "polyMesh")
    assert np.array_equal(back.points, mesh.points)
    assert len(back.cells[kind]) == len(mesh.cells[kind])
    # Each cell may start from another of its nodes.
    for ours, theirs in zip(mesh.cells[kind], back.cells[kind]):
        assert set(ours) == set(theirs)
    assert back.quality("volume")[kind] == pytest.approx(mesh.quality("volume")[kind])


def test_faces_are_in_upper_triangular_order(tmp_path):
    nmgs.write(tmp_path / "polyMesh", unit("tetra"))

    def labels(name):
        text = (tmp_path / "polyMesh" / name).read_text().rpartition("}")[2]
        return [int(w) for w in text[text.index("(") + 1 : text.rindex(")")].split()]

    owner, neighbour = labels("owner"), labels("neighbour")
    pairs = list(zip(owner, neighbour))
    assert pairs == sorted(pairs) and all(a < b for a, b in pairs)


def test_refused(tmp_path):
    with pytest.raises(ValueError, match="hexahedron20"):
        nmgs.write(tmp_path / "polyMesh", mixed(2))
    with pytest.raises(ValueError, match="volume"):
        nmgs.write(tmp_path / "polyMesh", unit("quad"))
    with pytest.raises(ValueError, match="20-node"):
        nmgs.write(tmp_path / "blockMeshDict", nmgs.shapes.square())
    with pytest.raises(ValueError, match="20-node"):
        nmgs.write(tmp_path / "blockMeshDict", mixed())
    hexahedron = unit("hexahedron", divisions=1)
    thrice = np.repeat(hexahedron.cells["hexahedron"], 3, axis=0)
    with pytest.raises(ValueError, match="share the face"):
        nmgs.write(tmp_path / "polyMesh", nmgs.Mesh(hexahedron.points, {"hexahedron": thrice}))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ("points", "faces", "owner", "neighbour"))
def test_a_broken_file_is_named(name, tmp_path):
    folder = tmp_path / "polyMesh"
    nmgs.write(folder, unit("hexahedron"))
    text = (folder / name).read_text()
    (folder / name).write_text(text[: len(text) // 2].replace(")", " ").replace("(", " "))
    with pytest.raises(nmgs.FormatError, match="polyMesh"):
        nmgs.read(folder)
    (folder / name).unlink()
    with pytest.raises(FileNotFoundError):
        nmgs.read(folder)
