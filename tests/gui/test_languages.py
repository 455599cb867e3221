# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in German and Turkish: menus, panels and texts follow FreeCAD's language."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import press, process_events, run, screenshot, widget
from PySide import QtGui

from freecad.NMGSWorkbench.texts import tr


@pytest.fixture(
    params=[
        ("German", "Netzbericht", "Netz erzeugen", "Formenbibliothek", "Radius"),
        ("Turkish", "Ağ raporu", "Ağ oluştur", "Şekil kitaplığı", "Yarıçap"),
    ],
    ids=["de", "tr"],
)
def language(request):
    FreeCADGui.setLocale(request.param[0])
    process_events(50)
    yield request.param
    FreeCADGui.setLocale("English")
    process_events(50)


def actions():
    menus = FreeCADGui.getMainWindow().menuBar().findChildren(QtGui.QMenu)
    (menu,) = [menu for menu in menus if menu.title().replace("&", "") == "NMGS"]
    return [action.text().replace("&", "") for action in menu.actions()]


def test_menu_and_panel(document, language):
    _, report, generate, library, radius = language
    assert report in actions() and generate in actions()
    assert tr("Mesh report") != "Mesh report" or tr("Shape library") == library
    run("NMGS_ShapeLibrary")
    label = widget(QtGui.QLabel, "argument_radius_label")
    assert label.text() == radius
    shapes = widget(QtGui.QListWidget, "shapes")
    assert shapes.item(0).text() == tr("Square") != "Square"
    screenshot(f"panel_shape_library_{language[0]}")
    press("Cancel" if FreeCAD.ActiveDocument is None else _cancel())


def _cancel():
    """The button's own text, which Qt translates."""
    for box in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        if box.isVisible() and box.button(QtGui.QDialogButtonBox.Cancel):
            return box.button(QtGui.QDialogButtonBox.Cancel).text().replace("&", "")
    raise AssertionError("no Cancel")
