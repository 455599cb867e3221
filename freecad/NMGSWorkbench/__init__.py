# SPDX-License-Identifier: LGPL-2.1-or-later
"""NMGS Workbench: structured meshes and TetGen meshes. Runs in every FreeCAD, with a window or not.

Only the file types are made known here; numpy and the kernel are imported when a file is opened.
"""

import sys

#: Meshes of other programs. FreeCAD asks which module is to open those that FEM opens as well.
_MESHES = "*.msh *.med *.unv *.inp *.vtu *.vtk *.bdf *.nas *.su2 *.gid"
#: (what the dialog shows, module that opens or writes it)
IMPORT_TYPES = (
    ("NMGS surface patches (*.n2s)", "import_blocks"),
    ("NMGS volume blocks (*.n3s)", "import_blocks"),
    ("NMGS surface mesh (*.n2r)", "import_mesh"),
    ("NMGS volume mesh (*.n3r)", "import_mesh"),
    ("TetGen points (*.node)", "import_plc"),
    ("TetGen piecewise linear complex (*.poly *.smesh)", "import_plc"),
    ("TetGen tetrahedra (*.ele)", "import_mesh"),
    (f"NMGS mesh ({_MESHES})", "import_mesh"),
)
EXPORT_TYPES = (
    ("NMGS surface patches (*.n2s)", "import_blocks"),
    ("NMGS volume blocks (*.n3s)", "import_blocks"),
    ("NMGS surface mesh (*.n2r)", "import_mesh"),
    ("NMGS volume mesh (*.n3r)", "import_mesh"),
    ("TetGen points (*.node)", "import_plc"),
    ("TetGen piecewise linear complex (*.poly *.smesh)", "import_plc"),
    ("TetGen tetrahedra (*.ele)", "import_mesh"),
    (f"NMGS mesh ({_MESHES})", "import_mesh"),
)


def _register_file_types(application: object) -> None:
    for filter_text, module in IMPORT_TYPES:
        application.addImportType(filter_text, f"{__name__}.{module}")
    for filter_text, module in EXPORT_TYPES:
        application.addExportType(filter_text, f"{__name__}.{module}")


class _Watch:
    """FreeCAD's observer of documents. One that a FreeCAD without the workbench has saved has all
    properties, but no Python classes; they are given back when it is opened."""

    def slotActivateDocument(self, document: object) -> None:
        if getattr(document, "Restoring", False):
            return
        for obj in document.Objects:
            if getattr(obj, "ProxyClass", "") and getattr(obj, "Proxy", self) is None:
                from .objects.reattach import reattach

                reattach(obj)

    # FreeCAD tells of no end of opening; a recompute is the next that it tells of.
    slotBeforeRecomputeDocument = slotActivateDocument


_watch = _Watch()

# FreeCAD imports this package while it starts. Plain Python imports it for the console API alone
# and must not start a FreeCAD for that.
if "FreeCAD" in sys.modules:
    _register_file_types(sys.modules["FreeCAD"])
    sys.modules["FreeCAD"].addDocumentObserver(_watch)
