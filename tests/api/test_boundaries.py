# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rooms of the house keep to themselves: who may import or include what."""

import ast
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "freecad" / "NMGSWorkbench"
KERNEL = ROOT / "cpp" / "nmgs"

GUI_ROOMS = {"init_gui.py", "viewproviders", "taskpanels", "commands"}
GUI_MODULES = {"FreeCADGui", "PySide", "PySide2", "PySide6", "PyQt5", "PyQt6", "pivy", "FemGui"}
#: Rooms of cpp/nmgs from left to right; one may use those to its left, and support.
#: quality stands before convert: joining triangles to quads chooses by quality.
CPP_ROOMS = ["support", "mesh", "element", "blocking", "quality", "convert", "plc", "formats"]
#: OpenCASCADE's headers are in no folder; these are their packages' names.
OCCT = re.compile(
    r"[<\"](?:opencascade/)?(?:Adaptor|Approx|BRep|Bnd|BndLib|CPnts|ElCLib|ElSLib|Extrema|GCPnts|"
    r"GProp|Geom|IFSelect|IntCurve|NCollection|Poly|Precision|STEP|Shape|Standard|TCol|TopAbs|"
    r"TopExp|TopLoc|TopTools|TopoDS|gp)\w*\.hxx[>\"]"
)


def python_files():
    return sorted(PACKAGE.rglob("*.py"))


def cpp_files():
    return sorted(p for p in (ROOT / "cpp").rglob("*") if p.suffix in (".h", ".cpp", ".in"))


def room(path):
    """The first folder or file below the package."""
    return path.relative_to(PACKAGE).parts[0]


def imports(path):
    """(names of imported modules, those imported while the module itself is imported).

    Relative names are written in full.
    """
    everything, at_once = set(), set()

    def walk(node, inside):
        for child in ast.iter_child_nodes(node):
            names = _imported(child, path)
            everything.update(names)
            if not inside:
                at_once.update(names)
            is_function = isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda))
            walk(child, inside or is_function)

    walk(ast.parse(path.read_text(encoding="utf-8")), False)
    return everything, at_once


def _imported(node, path):
    if isinstance(node, ast.Import):
        return {alias.name for alias in node.names}
    if isinstance(node, ast.ImportFrom):
        parts = list(path.relative_to(ROOT).with_suffix("").parts)
        base = parts[: len(parts) - node.level] if node.level else []
        module = ".".join(base + ([node.module] if node.module else []))
        return {module} | {f"{module}.{alias.name}" for alias in node.names}
    return set()


def test_there_is_something_to_look_at():
    assert len(python_files()) > 10 and len(cpp_files()) > 10
    # The means work: these are known to be there.
    assert "FreeCADGui" in imports(PACKAGE / "init_gui.py")[1]
    assert OCCT.search("#include <TopoDS_Face.hxx>") and OCCT.search("#include <gp_Pnt.hxx>")


@pytest.mark.parametrize("path", python_files(), ids=lambda p: str(p.relative_to(PACKAGE)))
def test_gui_imports_stay_in_their_rooms(path):
    if room(path) in GUI_ROOMS:
        return
    used = {name.split(".")[0] for name in imports(path)[0]}
    assert not used & GUI_MODULES


@pytest.mark.parametrize("path", python_files(), ids=lambda p: str(p.relative_to(PACKAGE)))
def test_qt_comes_through_freecads_shim(path):
    used = {name.split(".")[0] for name in imports(path)[0]}
    assert not used & {"PySide2", "PySide6", "PyQt5", "PyQt6"}


@pytest.mark.parametrize("path", python_files(), ids=lambda p: str(p.relative_to(PACKAGE)))
def test_rooms_of_python_use_those_to_their_left(path):
    """nmgs < fem < objects < the window's rooms; the package itself imports nothing of them."""
    order = ["nmgs", "fem", "resources", "objects"]
    here = room(path)
    package = "freecad.NMGSWorkbench."
    used = {n[len(package) :].split(".")[0] for n in imports(path)[1] if n.startswith(package)}
    used.discard("")
    if here == "__init__.py":
        assert not imports(path)[1] - {"sys", "__future__"}
    elif here == "nmgs":
        # nmgs.to_fem is part of the console API and lives with the rest of FEM.
        assert used <= {"nmgs", "fem"}
        assert path.name == "fem.py" or used <= {"nmgs"}
    elif here in order:
        assert used <= set(order[: order.index(here) + 1])
    elif here not in GUI_ROOMS:
        assert not used & GUI_ROOMS


@pytest.mark.parametrize("path", sorted((PACKAGE / "nmgs").rglob("*.py")), ids=lambda p: p.name)
def test_the_console_api_imports_without_freecad_and_without_the_kernel(path):
    used = {name.split(".")[0] for name in imports(path)[1]}
    assert not used & {"FreeCAD", "Part", "Fem", "Mesh", "nmgs_kernel"}


@pytest.mark.parametrize("path", cpp_files(), ids=lambda p: str(p.relative_to(ROOT)))
def test_rooms_of_cpp_use_those_to_their_left(path):
    text = path.read_text(encoding="utf-8")
    parts = path.relative_to(ROOT / "cpp").parts
    included = re.findall(r'#include\s*[<"]([^>"]+)[>"]', text)
    if parts[0] == "nmgs" and len(parts) > 2:
        assert parts[1] in CPP_ROOMS, f"a new room; where does it stand? {CPP_ROOMS}"
        allowed = CPP_ROOMS[: CPP_ROOMS.index(parts[1]) + 1]
        for name in included:
            if name.startswith("nmgs/"):
                assert name.split("/")[1] in allowed, name
    if parts[0] == "nmgs":
        assert not any(
            name.startswith(("nmgs_cad/", "nmgs_tet/", "pybind11/")) for name in included
        )
        assert not any(name == "Python.h" for name in included)
    if parts[0] != "nmgs_tet":
        assert "tetgen.h" not in included
    if parts[0] not in ("nmgs_cad", "bench"):  # benchmarks make shapes of their own
        assert not OCCT.search(text)
    if parts[0] != "bindings":
        assert not any(name.startswith("pybind11/") for name in included)
    assert not any(name.startswith(("App/", "Base/", "Mod/")) for name in included)


def test_targets_link_those_to_their_left():
    """The library links nothing of the others."""
    text = (KERNEL / "CMakeLists.txt").read_text(encoding="utf-8")
    assert not re.search(r"TK\w+|OpenCASCADE|OCCT|tetgen|TetGen|pybind11", text)


def test_choosing_the_workbench_imports_nothing_heavy():
    """Commands import the console API, NumPy and Part when they are used, not before."""
    light = {"resources", "texts", "commands", "objects", "taskpanels"}
    light |= {"objects.stale", "objects.preferences", "objects.run"}
    light |= {"taskpanels.messages", "taskpanels.progress", "taskpanels.cutting_picks"}
    package = "freecad.NMGSWorkbench."
    start = [*(PACKAGE / "commands").glob("*.py"), PACKAGE / "init_gui.py"]
    start += [PACKAGE / (name.replace(".", "/") + ".py") for name in light if "." in name]
    assert len(start) > 15
    for path in start:
        at_once = imports(path)[1]
        assert not at_once & {"numpy", "Part", "Fem", "pivy", "pivy.coin"}, path
        modules = {n[len(package) :] for n in at_once if n.startswith(package)}
        # What "from .. import name" names is a module where there is one of that name.
        modules = {m for m in modules if (PACKAGE / (m.replace(".", "/") + ".py")).is_file()}
        rooms = {m for m in modules if not m.startswith("commands.")}
        assert rooms <= light | {"texts"}, (path, rooms - light)
