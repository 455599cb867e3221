# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a mesh to an answer: material, held and loaded faces, CalculiX, results on the mesh."""

from __future__ import annotations

from typing import Any, List, Optional

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..fem import analysis as fem_analysis
from ..nmgs.errors import Cancelled
from ..objects.run import run
from ..objects.sources import Entity
from ..resources import icon, ui
from ..texts import tr
from . import messages
from .base import ok_cancel, tell
from .model_panel import close

#: Name, Young's modulus in MPa, Poisson's ratio: rounded figures of handbooks.
MATERIALS = (
    (tr("Steel"), 210000.0, 0.30),
    (tr("Stainless steel"), 195000.0, 0.29),
    (tr("Aluminium"), 70000.0, 0.33),
    (tr("Titanium"), 110000.0, 0.34),
    (tr("Copper"), 120000.0, 0.34),
    (tr("Cast iron"), 110000.0, 0.26),
    (tr("Concrete"), 30000.0, 0.20),
    (tr("ABS"), 2300.0, 0.37),
)


#: FreeCAD's own units of force and stress are a thousandth of these.
_NEWTON = _MEGAPASCAL = 1000.0


class AnalysisPanel:
    """OK makes a Fem::FemAnalysis of the mesh, one undo step; Cancel leaves no trace."""

    def __init__(self, mesh: Any):
        self.mesh, self.document = mesh, mesh.Document
        self.parts = parts_of(mesh)
        self.held: List[Entity] = []
        self.loaded: List[Entity] = []
        self.direction: Optional[Entity] = None
        self.form = form = FreeCADGui.PySideUic.loadUi(ui("analysis"))
        form.setWindowIcon(QtGui.QIcon(icon("nmgs_analysis")))
        form.summary.setText(
            tr("{mesh} on {parts}").format(
                mesh=mesh.Label, parts=", ".join(part.Label for part in self.parts)
            )
        )
        form.material.addItems([name for name, _, _ in MATERIALS])
        form.material.currentIndexChanged[int].connect(self._take_material)
        self._take_material(0)
        form.force.setProperty("rawValue", 100.0 * _NEWTON)
        form.pressure.setProperty("rawValue", 1.0 * _MEGAPASCAL)
        form.kind.currentIndexChanged[int].connect(self._take_kind)
        self._take_kind(0)
        form.hold.clicked.connect(lambda: self._add(self.held, form.held))
        form.load.clicked.connect(lambda: self._add(self.loaded, form.loaded))
        form.held.itemDoubleClicked.connect(lambda item: self._drop(self.held, form.held))
        form.loaded.itemDoubleClicked.connect(lambda item: self._drop(self.loaded, form.loaded))
        form.along.clicked.connect(self._take_direction)
        self._tell_direction()
        self._tell("")
        # Faces are picked on the part.
        self._shown = [(obj, obj.Visibility) for obj in (mesh, *self.parts)]
        mesh.Visibility = False
        for part in self.parts:
            part.Visibility = True

    def _take_material(self, index: int) -> None:
        _, young, poisson = MATERIALS[index]
        self.form.young.setProperty("rawValue", young * _MEGAPASCAL)
        self.form.poisson.setValue(poisson)

    def _take_kind(self, index: int) -> None:
        self.form.force.setVisible(index == 0)
        self.form.pressure.setVisible(index == 1)
        self.form.along.setVisible(index == 0)

    def _add(self, faces: List[Entity], shown: Any) -> None:
        found = [entity for entity in self._picked() if entity[1].startswith("Face")]
        self._tell("" if found else tr("Pick faces of the part in the view first."))
        faces += [entity for entity in found if entity not in faces]
        self._list(faces, shown)
        FreeCADGui.Selection.clearSelection()

    def _drop(self, faces: List[Entity], shown: Any) -> None:
        if 0 <= shown.currentRow() < len(faces):
            faces.pop(shown.currentRow())
            self._list(faces, shown)

    def _list(self, faces: List[Entity], shown: Any) -> None:
        shown.clear()
        shown.addItems([f"{part.Label}.{name}" for part, name in faces])

    def _take_direction(self) -> None:
        found = [entity for entity in self._picked() if _has_direction(*entity)]
        # Pressed without anything picked, it goes back to the face's normal.
        self.direction = found[0] if found else None
        self._tell_direction()

    def _tell_direction(self) -> None:
        text = tr("Along picked edge or face")
        if self.direction is not None:
            part, name = self.direction
            text = tr("Along {name}").format(name=f"{part.Label}.{name}")
        self.form.along.setText(text)

    def _picked(self) -> List[Entity]:
        return [
            (pick.Object, name)
            for pick in FreeCADGui.Selection.getSelectionEx()
            if pick.Object in self.parts
            for name in pick.SubElementNames
        ]

    def _tell(self, problem: str) -> None:
        tell(self.form, problem)

    def getStandardButtons(self) -> int:
        return ok_cancel()

    def accept(self) -> bool:
        if not self.held or not self.loaded:
            self._tell(tr("A face must be held and one be loaded."))
            return False
        form = self.form
        title = form.windowTitle()
        self.document.openTransaction(title)
        try:
            analysis = self._analysis()
            result = fem_analysis.solve(analysis, run=run) if form.solve.isChecked() else None
        except Exception as error:
            self.document.abortTransaction()
            if not isinstance(error, Cancelled):
                messages.show_error(title, error)
            return False
        self._restore_visibility()
        self.document.commitTransaction()
        self._close()
        if result is not None:
            show(self.mesh, result)
            FreeCAD.Console.PrintMessage(told(result) + "\n")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(result or analysis)
        return True

    def _analysis(self) -> Any:
        form = self.form
        is_force = form.kind.currentIndex() == 0
        if is_force:
            load = {"force": form.force.property("rawValue") / _NEWTON}
        else:
            load = {"pressure": form.pressure.property("rawValue") / _MEGAPASCAL}
        direction = None
        if self.direction is not None and is_force:
            direction = (self.direction[0], [self.direction[1]])
        return fem_analysis.static_analysis(
            self.parts[0],
            self.mesh,
            self.held,
            self.loaded,
            direction=direction,
            material={
                "Name": form.material.currentText(),
                "YoungsModulus": f"{form.young.property('rawValue') / _MEGAPASCAL} MPa",
                "PoissonRatio": str(form.poisson.value()),
            },
            reverse=form.reverse.isChecked(),
            **load,
        )

    def reject(self) -> bool:
        self._restore_visibility()
        self._close()
        return True

    def _restore_visibility(self) -> None:
        for obj, shown in self._shown:
            obj.Visibility = shown

    def _close(self) -> None:
        close(self.document)


def parts_of(mesh: Any) -> List[Any]:
    """The objects whose faces a mesh has. Raises ValueError for one that is on no CAD."""
    laid = getattr(mesh, "Blocks", None) or mesh
    parts = list(dict.fromkeys(part for part, _ in getattr(laid, "Source", None) or ()))
    parts = [part for part in parts if getattr(part, "Shape", None) is not None]
    if not parts:
        raise ValueError(
            tr("{mesh} is not on a part: there are no faces to hold or load.").format(
                mesh=mesh.Label
            )
        )
    return parts


def _has_direction(part: Any, name: str) -> bool:
    element = part.Shape.getElement(name)
    if name.startswith("Edge"):
        return element.Curve.TypeId == "Part::GeomLine"
    return name.startswith("Face") and element.Surface.TypeId == "Part::GeomPlane"


def show(mesh: Any, result: Any) -> None:
    """Stress by colour on the deformed mesh, the rest out of the way."""
    shown = result.Mesh
    mesh.Visibility = False
    for part in parts_of(mesh):
        part.Visibility = False
    shown.Visibility = True
    view = shown.ViewObject
    view.DisplayMode = "Faces"
    view.setNodeColorByScalars(result.NodeNumbers, result.vonMises)
    view.setNodeDisplacementByVectors(result.NodeNumbers, result.DisplacementVectors)
    size = shown.FemMesh.BoundBox.DiagonalLength
    largest = max(result.DisplacementLengths)
    if largest > 0:
        # Seen well, and said in the report view.
        view.applyDisplacement(0.05 * size / largest)
    QtCore.QTimer.singleShot(0, lambda: FreeCADGui.SendMsgToActiveView("ViewFit"))


def told(result: Any) -> str:
    """What an engineer asks for first."""
    return tr(
        "Largest displacement {moved:.4g} mm, largest von Mises stress {stress:.4g} MPa"
    ).format(moved=max(result.DisplacementLengths), stress=max(result.vonMises))
