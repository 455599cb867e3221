# SPDX-License-Identifier: LGPL-2.1-or-later
"""A static analysis of a mesh in one call, and its solution by CalculiX through FreeCAD's FEM."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from ..nmgs.errors import Error
from .calculix_process import run_calculix
from .picked import install

#: A face's name, or the document object that it belongs to and its name.
Face = Union[str, Tuple[Any, str]]
#: Called with a job that takes a progress callback and with words for the user; gives its result.
Runner = Callable[[Callable[[Any], Any], str], Any]

#: FreeCAD's own steel, S235, as its material card has it.
STEEL = {
    "Name": "Steel",
    "YoungsModulus": "210000 MPa",
    "PoissonRatio": "0.30",
    "Density": "7900 kg/m^3",
}


class SolverError(Error):
    """FEM's checks or CalculiX refused the analysis; the message has their words."""


def static_analysis(
    part: Any,
    mesh: Any,
    fixed: Sequence[Face],
    loaded: Sequence[Face],
    force: float = 0.0,
    direction: Optional[Any] = None,
    material: Optional[Dict[str, str]] = None,
    pressure: float = 0.0,
    reverse: bool = False,
) -> Any:
    """A Fem::FemAnalysis: faces held, a force in N spread over others, or a pressure on them in
    MPa, solved on mesh.

    part: the document object whose faces are named ("Face1"); faces of others are pairs of object
    and name. mesh: a Fem::FemMeshObject on it.
    direction: (object, sub-elements) of a straight edge or plane face that gives the force's
    direction; None for the loaded face's inward normal. reverse: the other way round. material:
    FreeCAD's material keys, steel if none. pressure: above 0 into the part.
    Raises ValueError when a face is not of its object, or without exactly one of force and
    pressure.
    """
    import ObjectsFem

    held, pressed = _references(part, fixed), _references(part, loaded)
    if bool(force) == bool(pressure):
        raise ValueError(f"force, pressure: expected one other than 0, got {force}, {pressure}")
    document = mesh.Document
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    analysis.addObject(_make_solver(document))
    steel = ObjectsFem.makeMaterialSolid(document, "Material")
    steel.Material = dict(material or STEEL)
    analysis.addObject(steel)
    hold = ObjectsFem.makeConstraintFixed(document, "Fixed")
    hold.References = held
    analysis.addObject(hold)
    if pressure:
        load = ObjectsFem.makeConstraintPressure(document, "Pressure")
        load.References = pressed
        _set_number(load, "Pressure", pressure, "MPa")
    else:
        load = ObjectsFem.makeConstraintForce(document, "Force")
        load.References = pressed
        _set_number(load, "Force", force, "N")
        if direction is not None:
            load.Direction = direction
    load.Reversed = reverse
    analysis.addObject(load)
    analysis.addObject(mesh)
    document.recompute()
    return analysis


def _references(part: Any, faces: Sequence[Face]) -> List[Tuple[Any, str]]:
    result = []
    for face in faces:
        owner, name = (part, face) if isinstance(face, str) else face
        number = name[4:]
        if not name.startswith("Face") or not number.isdigit():
            raise ValueError(f"faces: expected names like 'Face1', got {name!r}")
        if not 1 <= int(number) <= len(owner.Shape.Faces):
            raise ValueError(f"faces: {owner.Label} has no {name}")
        result.append((owner, name))
    return result


def _make_solver(document: Any) -> Any:
    import ObjectsFem

    # The name drifted between FreeCAD 0.20 and 1.0.
    make = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or getattr(
        ObjectsFem, "makeSolverCalculixCcxTools"
    )
    solver = make(document, "CalculiX")
    solver.AnalysisType = "static"
    solver.GeometricalNonlinearity = "linear"
    return solver


def _set_number(load: Any, name: str, value: float, unit: str) -> None:
    # A float on 0.20, a quantity with a unit from 1.0 on.
    setattr(load, name, value if isinstance(getattr(load, name), float) else f"{value} {unit}")


def solve(analysis: Any, folder: Optional[str] = None, run: Optional[Runner] = None) -> Any:
    """Runs CalculiX and returns the result object, a Fem::FemResultObject, also in the analysis.

    folder: where the input file and CalculiX's output go; None for a temporary one. run: how
    CalculiX itself is waited for, plainly if none; the document is not touched meanwhile.
    Raises SolverError with the words of FEM's checks or of CalculiX, Cancelled.
    """
    from femtools import ccxtools

    solvers = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemSolverObjectPython")]
    if len(solvers) != 1:
        raise SolverError(f"{analysis.Label} has {len(solvers)} solvers; one is needed")
    _refuse_pyramids(analysis)
    tools = ccxtools.FemToolsCcx(analysis, solvers[0])
    tools.purge_results()
    tools.update_objects()
    tools.setup_working_dir(folder)
    tools.setup_ccx()
    problems = tools.check_prerequisites()
    if problems:
        raise SolverError(problems.strip())
    install()
    tools.write_inp_file()
    if not tools.inp_file_name:
        raise SolverError("FEM could not write CalculiX's input file; see the report view")
    require_loads(tools.inp_file_name)
    binary, path = tools.ccx_binary, tools.inp_file_name
    if run is None:
        code, output = run_calculix(binary, path)
    else:
        code, output = run(lambda progress: run_calculix(binary, path, progress), "CalculiX")
    if code != 0:
        raise SolverError(f"CalculiX ended with code {code}: {output[-2000:]}")
    tools.load_results()
    results = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemResultObject")]
    if not results:
        raise SolverError("CalculiX gave no results")
    return results[0]


def _refuse_pyramids(analysis: Any) -> None:
    # FEM's writer leaves them out without a word, and the result would have holes.
    for obj in analysis.Group:
        if obj.isDerivedFrom("Fem::FemMeshObject") and obj.FemMesh.PyramidCount:
            raise SolverError(
                f"{obj.Label} has {obj.FemMesh.PyramidCount} pyramids, which FEM does not hand to "
                "CalculiX; nmgs.write(path, mesh) as .inp writes them as collapsed hexahedra"
            )


def require_loads(path: str) -> None:
    """Raises SolverError when a *CLOAD or *DLOAD of an input file has no line: FEM writes it empty,
    without a word, when it finds no face of the mesh on the picked one."""
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = [line.strip() for line in file]
    content = [line for line in lines if line and not line.startswith("**")]
    for number, line in enumerate(content):
        if line.upper().startswith(("*CLOAD", "*DLOAD")):
            following = content[number + 1] if number + 1 < len(content) else "*"
            if following.startswith("*"):
                raise SolverError(
                    f"{path}: {line} is empty: no face of the mesh lies on the loaded CAD face"
                )
