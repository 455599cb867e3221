# SPDX-License-Identifier: LGPL-2.1-or-later
"""About: versions of the workbench and of everything linked with it."""

from __future__ import annotations

import platform
from typing import Any, List, Tuple

import FreeCAD
import FreeCADGui
import numpy
from PySide import QtCore, QtGui

from .. import resources
from ..nmgs import TetOptions, errors
from ..texts import tr


def versions() -> List[Tuple[str, str]]:
    """(name, version) of what takes part; a part that is missing says so."""
    from pivy import coin  # only here: Coin takes a while to import

    version = FreeCAD.Version()
    rows = [
        ("NMGS Workbench", _addon_version()),
        ("FreeCAD", ".".join(version[:3])),
        ("Python", platform.python_version()),
        ("Qt", QtCore.qVersion()),
        ("Coin", coin.SoDB.getVersion()),
        ("NumPy", numpy.__version__),
    ]
    try:
        import Part

        rows.append(("OpenCASCADE", Part.OCC_VERSION))
    except (ImportError, AttributeError):
        rows.append(("OpenCASCADE", "-"))
    try:
        rows.append(("TetGen", ".".join(str(n) for n in _tuple(TetOptions().version))))
    except errors.Error as error:
        rows.append(("TetGen", str(error)))
    return rows


def _tuple(version: Any) -> Tuple[Any, ...]:
    return tuple(version) if isinstance(version, (tuple, list)) else (version,)


def _addon_version() -> str:
    import xml.etree.ElementTree as tree

    path = resources.icons().rpartition("icons")[0] + "package.xml"
    try:
        root = tree.parse(path).getroot()
    except (OSError, tree.ParseError):
        return "?"
    for child in root:
        if child.tag.endswith("version"):
            return child.text or "?"
    return "?"


def show() -> Any:
    """A box that does not block. Returns it."""
    box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName("NMGS_About")
    box.setWindowTitle(tr("About NMGS"))
    box.setIconPixmap(QtGui.QIcon(resources.icon("nmgs_workbench")).pixmap(64, 64))
    rows = "".join(
        f"<tr><td>{name}&nbsp;&nbsp;</td><td>{text}</td></tr>" for name, text in versions()
    )
    words = tr(
        "Structured hexahedral meshes from blocks, TetGen meshes, and their way into FEM. "
        "LGPL-2.1-or-later; the program nmgs-tet alone, which links TetGen, is AGPL-3.0-or-later."
    )
    box.setText(f"<p>{words}</p><table>{rows}</table>")
    box.finished.connect(box.deleteLater)
    box.open()
    return box
