# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same CAD in 20-node hexahedra of fitted blocks, and in tetra10 of TetGen and of Gmsh."""

import contextlib
import os

import FreeCAD

from freecad.NMGSWorkbench import nmgs
from freecad.NMGSWorkbench.fem.from_fem_mesh import mesh_of
from freecad.NMGSWorkbench.nmgs.mesh import CELL_TYPES


def _volumes(mesh):
    cells = {k: v for k, v in mesh.cells.items() if CELL_TYPES[k][1] == 3}
    return nmgs.Mesh(mesh.points, cells)


def hexahedra(shape, size, **options):
    """Blocks over the CAD by nmgs.fit, hexahedron20."""
    return _volumes(nmgs.fit(shape, size=size, **options).generate(order=2))


def tetgen(shape, size):
    """TetGen, tetra10 with the nodes on the CAD; no tetrahedron larger than a regular one."""
    volume = size**3 / (6 * 2**0.5)
    switches = f"pq1.4a{volume:.12f}o2"
    deviation = 1e-3 * shape.BoundBox.DiagonalLength
    mesh = nmgs.tetrahedralize(shape, switches, snap=True, deviation=deviation)
    return _volumes(mesh)


def gmsh(shape, size):
    """Gmsh through FreeCAD's own FEM mesh object, second order."""
    import ObjectsFem
    from femmesh import gmshtools

    document = FreeCAD.newDocument("Gmsh", hidden=True, temp=True)
    try:
        part = document.addObject("Part::Feature", "Part")
        part.Shape = shape
        obj = ObjectsFem.makeMeshGmsh(document, "Mesh")
        # "Part" became "Shape" in FreeCAD 1.0.
        setattr(obj, "Part" if hasattr(obj, "Part") else "Shape", part)
        obj.ElementOrder = "2nd"
        obj.CharacteristicLengthMax = f"{size} mm"
        document.recompute()
        with _quiet():
            problem = gmshtools.GmshTools(obj).create_mesh()
        if problem or not obj.FemMesh.VolumeCount:
            raise RuntimeError(f"Gmsh: {problem or 'no tetrahedra'}")
        mesh = mesh_of(obj.FemMesh)
    finally:
        FreeCAD.closeDocument(document.Name)
    return _volumes(mesh)


@contextlib.contextmanager
def _quiet():
    """FreeCAD's tools print from C++."""
    kept = os.dup(1)
    with open(os.devnull, "w") as nowhere:
        os.dup2(nowhere.fileno(), 1)
        try:
            yield
        finally:
            os.dup2(kept, 1)
            os.close(kept)


MESHERS = {"hex20": hexahedra, "TetGen tet10": tetgen, "Gmsh tet10": gmsh}
