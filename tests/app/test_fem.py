# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes in FreeCAD's FEM, solved by CalculiX; the oracles are closed forms and FemMesh itself."""

import FreeCAD
import numpy as np
import Part
import pytest
from element_meshes import mixed
from FreeCAD import Vector

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem import analysis as fem_analysis

LENGTH, HEIGHT, YOUNG, POISSON, LOAD = 100.0, 10.0, 210000.0, 0.3, 1000.0


@pytest.fixture
def document():
    made = FreeCAD.newDocument()
    yield made
    FreeCAD.closeDocument(made.Name)


def box(document):
    part = document.addObject("Part::Box", "Box")
    part.Length, part.Width, part.Height = LENGTH, HEIGHT, HEIGHT
    document.recompute()
    return part


def face_at(part, x):
    return [
        f"Face{n}" for n, f in enumerate(part.Shape.Faces, 1) if abs(f.CenterOfMass.x - x) < 1e-9
    ]


def upright_edge(part):
    edges = enumerate(part.Shape.Edges, 1)
    return [f"Edge{n}" for n, e in edges if abs(e.tangentAt(e.FirstParameter).z) > 0.99][0]


MESHES = {
    "hexahedron20": lambda model: model.generate(order=2),
    "hexahedron": lambda model: model.generate(),
    "tetra10": lambda model: model.generate().split().to_order(2),
}


@pytest.mark.parametrize("kind", MESHES)
def test_cantilever_bends_as_beam_theory_says(document, kind):
    part = box(document)
    mesh = MESHES[kind](nmgs.fit(part, size=5))
    obj = nmgs.to_fem(mesh, document)
    analysis = fem_analysis.static_analysis(
        part,
        obj,
        face_at(part, 0),
        face_at(part, LENGTH),
        LOAD,
        direction=(part, [upright_edge(part)]),
        material={"Name": "Test", "YoungsModulus": f"{YOUNG} MPa", "PoissonRatio": str(POISSON)},
    )
    result = fem_analysis.solve(analysis)
    inertia = HEIGHT**4 / 12
    shear = YOUNG / (2 * (1 + POISSON))
    # Timoshenko: bending plus shear with the rectangle's factor 5/6.
    expected = LOAD * LENGTH**3 / (3 * YOUNG * inertia) + LOAD * LENGTH / (
        5 / 6 * shear * HEIGHT**2
    )
    # Fully integrated 8-node bricks are too stiff in bending with two elements over the height.
    tolerance = 0.15 if kind == "hexahedron" else 0.02
    assert max(result.DisplacementLengths) == pytest.approx(expected, rel=tolerance)


@pytest.mark.parametrize("order", (1, 2))
def test_femmesh_holds_all_cells_boundary_faces_and_groups(document, order):
    part = box(document)
    mesh = nmgs.fit(part, size=5).generate(order=order)
    fem = nmgs.to_fem(mesh, document).FemMesh
    assert fem.NodeCount == len(mesh.points)
    assert fem.HexaCount == 20 * 2 * 2
    assert fem.FaceCount == 4 * 20 * 2 + 2 * 4
    points = np.array([tuple(fem.Nodes[n + 1]) for n in range(fem.NodeCount)])
    assert (points == mesh.points).all()
    names = {fem.getGroupName(g): fem.getGroupElements(g) for g in fem.Groups}
    assert set(names) == set(mesh.groups)
    for number, face in enumerate(part.Shape.Faces, 1):
        assert len(names[f"Face{number}"]) == (8 * 5 if face.Area > 101 else 4)
        # FreeCAD's own search for the face's nodes, by geometry.
        kind, cells = mesh.groups[f"Face{number}"]
        assert set(fem.getNodesByFace(face)) == set((mesh.cells[kind][cells] + 1).ravel().tolist())


def test_boundary_is_completed_without_cad(document):
    mesh = nmgs.fit(Part.makeBox(2, 2, 2), size=1).generate()
    bare = nmgs.Mesh(mesh.points, {"hexahedron": mesh.cells["hexahedron"]})
    assert nmgs.to_fem(bare, document).FemMesh.FaceCount == 24
    part = nmgs.Mesh(
        mesh.points, {"hexahedron": mesh.cells["hexahedron"], "quad": mesh.cells["quad"][:5]}
    )
    assert nmgs.to_fem(part, document).FemMesh.FaceCount == 24


def test_a_load_without_faces_is_an_error(document):
    part = box(document)
    obj = nmgs.to_fem(nmgs.fit(part, size=5).generate(), document)
    elsewhere = document.addObject("Part::Box", "Elsewhere")
    elsewhere.Placement.Base = Vector(500, 0, 0)
    document.recompute()
    analysis = fem_analysis.static_analysis(
        part, obj, face_at(part, 0), face_at(part, LENGTH), LOAD
    )
    force = [o for o in analysis.Group if o.isDerivedFrom("Fem::ConstraintForce")][0]
    force.References = [(elsewhere, "Face1")]
    with pytest.raises(fem_analysis.SolverError):
        fem_analysis.solve(analysis)


def test_pyramids_are_refused(document):
    part = box(document)
    obj = nmgs.to_fem(mixed(), document)
    analysis = fem_analysis.static_analysis(
        part, obj, face_at(part, 0), face_at(part, LENGTH), LOAD
    )
    with pytest.raises(fem_analysis.SolverError, match="7 pyramids"):
        fem_analysis.solve(analysis)


def test_wrong_arguments(document):
    part = box(document)
    with pytest.raises(ValueError, match="Face7"):
        fem_analysis.static_analysis(part, None, ["Face7"], ["Face1"], 1.0)
    with pytest.raises(TypeError, match="str"):
        nmgs.to_fem("mesh", document)
    obj = nmgs.to_fem(nmgs.fit(part, size=5).generate(), document)
    analysis = fem_analysis.static_analysis(
        part, obj, face_at(part, 0), face_at(part, LENGTH), LOAD
    )
    with pytest.raises(ValueError, match="has a mesh already"):
        nmgs.to_fem(nmgs.fit(part).generate(), document, analysis=analysis)
