# SPDX-License-Identifier: LGPL-2.1-or-later
"""NMGS Workbench: structured meshes and TetGen meshes. Runs in every FreeCAD, with a window or not.

Only the file types are made known here; numpy and the kernel are imported when a file is opened.
"""

import sys

#: (what the dialog shows, module that opens or writes it)
IMPORT_TYPES = (
    ("NMGS surface patches (*.n2s)", "import_blocks"),
    ("NMGS volume blocks (*.n3s)", "import_blocks"),
    ("NMGS surface mesh (*.n2r)", "import_mesh"),
    ("NMGS volume mesh (*.n3r)", "import_mesh"),
    ("TetGen points (*.node)", "import_plc"),
    ("TetGen piecewise linear complex (*.poly *.smesh)", "import_plc"),
    ("TetGen tetrahedra (*.ele)", "import_mesh"),
)
EXPORT_TYPES = (
    ("NMGS surface patches (*.n2s)", "import_blocks"),
    ("NMGS volume blocks (*.n3s)", "import_blocks"),
    ("NMGS surface mesh (*.n2r)", "import_mesh"),
    ("NMGS volume mesh (*.n3r)", "import_mesh"),
    ("TetGen points (*.node)", "import_plc"),
    ("TetGen piecewise linear complex (*.poly *.smesh)", "import_plc"),
    ("TetGen tetrahedra (*.ele)", "import_mesh"),
)


def _register_file_types(application: object) -> None:
    for filter_text, module in IMPORT_TYPES:
        application.addImportType(filter_text, f"{__name__}.{module}")
    for filter_text, module in EXPORT_TYPES:
        application.addExportType(filter_text, f"{__name__}.{module}")


# FreeCAD imports this package while it starts. Plain Python imports it for the console API alone
# and must not start a FreeCAD for that.
if "FreeCAD" in sys.modules:
    _register_file_types(sys.modules["FreeCAD"])
