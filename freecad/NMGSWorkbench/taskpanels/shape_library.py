# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ready-made blocks to choose by picture (thesis 4.3.2 i)."""

from __future__ import annotations

import json
from typing import Any, Dict

from PySide import QtCore, QtGui

from .. import nmgs
from ..nmgs.block_model import BlockModel
from ..nmgs.plot import PlotOptions
from ..objects import shape_library
from ..texts import tr
from . import drawing
from .model_panel import ModelPanel

#: Sizes of a new shape, as multiples of the console API's: it has units of length, FreeCAD mm.
_MM = 10.0
_ARGUMENTS = (
    "size",
    "length",
    "width",
    "height",
    "radius",
    "inner_radius",
    "top_radius",
    "tube_radius",
) + ("divisions", "pieces", "caps")
_PICTURE = QtCore.QSize(96, 76)


def title_of(name: str) -> str:
    """The shape's name in the user's language."""
    return {
        "square": tr("Square"),
        "disc": tr("Disc"),
        "cylinder_surface": tr("Cylinder surface"),
        "cone_surface": tr("Cone surface"),
        "hemisphere": tr("Hemisphere"),
        "sphere_surface": tr("Sphere surface"),
        "torus_surface": tr("Torus surface"),
        "cube": tr("Cube"),
        "box": tr("Box"),
        "cylinder": tr("Cylinder"),
        "cone": tr("Cone"),
        "tube": tr("Tube"),
        "ball": tr("Ball"),
        "half_ball": tr("Half ball"),
        "torus": tr("Torus"),
        "wedge": tr("Wedge"),
    }.get(name, name.replace("_", " "))


def _picture(name: str, model: BlockModel) -> Any:
    if name == "box":
        model = nmgs.shapes.box(1.6, 1.0, 0.7)
    # Cut open, so that a solid is told from its surface.
    open_at = ((0.0, 0.0, 0.0), (0.0, -1.0, 0.0)) if name in ("ball", "torus") else None
    return drawing.picture(model, PlotOptions(cut=open_at))


class ShapeLibraryPanel(ModelPanel):
    ui_name = "shape_library"
    icon_name = "nmgs_shape_library"

    def fill(self) -> None:
        self.title = tr("Shape library")
        #: Of the chosen shape's arguments, those that the form has a widget for.
        self._widgets: Dict[str, Any] = {}
        self._connect()
        shapes = self.form.shapes
        shapes.setViewMode(QtGui.QListView.IconMode)
        shapes.setResizeMode(QtGui.QListView.Adjust)
        shapes.setMovement(QtGui.QListView.Static)
        shapes.setIconSize(_PICTURE)
        shapes.setGridSize(QtCore.QSize(116, 106))
        dimension = 0
        if self.obj is not None:
            dimension = 2 if self.obj.Proxy.nodes_per_element == 8 else 3
        for name in shape_library.names():
            model = getattr(nmgs.shapes, name)()
            # An object that is there stays patches, or blocks.
            if dimension and model.dimension != dimension:
                continue
            item = QtGui.QListWidgetItem(QtGui.QIcon(_picture(name, model)), title_of(name))
            item.setData(QtCore.Qt.UserRole, name)
            shapes.addItem(item)
        shapes.currentItemChanged.connect(self._take_shape)
        wanted = self.obj.Library if self.obj is not None else "hemisphere"
        for row in range(shapes.count()):
            if shapes.item(row).data(QtCore.Qt.UserRole) == wanted:
                shapes.setCurrentRow(row)
        if self.obj is not None:
            self._show(json.loads(self.obj.Arguments or "{}"))

    @property
    def _name(self) -> str:
        return self.form.shapes.currentItem().data(QtCore.Qt.UserRole)

    def _connect(self) -> None:
        for name in _ARGUMENTS:
            widget = getattr(self.form, f"argument_{name}")
            if isinstance(widget, QtGui.QCheckBox):
                widget.toggled.connect(self.changed)
            else:
                widget.valueChanged.connect(self.changed)

    def _take_shape(self, *_: Any) -> None:
        taken = {
            argument.name: argument.default for argument in shape_library.arguments(self._name)
        }
        self._widgets = {}
        for name in _ARGUMENTS:
            widget = getattr(self.form, f"argument_{name}")
            widget.setVisible(name in taken)
            label = getattr(self.form, f"argument_{name}_label", None)
            if label is not None:
                label.setVisible(name in taken)
            if name in taken:
                self._widgets[name] = widget
        self._show(
            {
                name: _MM * value if isinstance(value, float) else value
                for name, value in taken.items()
            }
        )
        document = getattr(nmgs.shapes, self._name).__doc__ or ""
        self.form.about.setText(" ".join(document.split()))
        self.changed()

    def _show(self, values: Dict[str, Any]) -> None:
        for name, value in values.items():
            widget = self._widgets.get(name)
            if isinstance(widget, QtGui.QCheckBox):
                widget.setChecked(value)
            elif isinstance(widget, QtGui.QSpinBox):
                widget.setValue(value if isinstance(value, int) else max(value))
            elif widget is not None:
                widget.setProperty("rawValue", float(value))

    def _arguments(self) -> Dict[str, Any]:
        result: Dict[str, Any] = {}
        for name, widget in self._widgets.items():
            if isinstance(widget, QtGui.QCheckBox):
                result[name] = widget.isChecked()
            elif isinstance(widget, QtGui.QSpinBox):
                result[name] = widget.value()
            else:
                result[name] = widget.property("rawValue")
        return result

    def model(self) -> BlockModel:
        if self.form.shapes.currentItem() is None:
            raise ValueError(tr("Choose a shape."))
        return shape_library.make_model(self._name, json.dumps(self._arguments()))

    def store(self, obj: Any, model: BlockModel) -> None:
        if self.obj is None:
            obj.Label = title_of(self._name)
        obj.Library = self._name
        obj.Arguments = json.dumps(self._arguments())
        obj.AutoDivisions = True
