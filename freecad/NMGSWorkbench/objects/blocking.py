# SPDX-License-Identifier: LGPL-2.1-or-later
"""What Patches and Blocks share: a BlockModel in properties, fitted to CAD or given."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Optional, Sequence, Tuple

import FreeCAD
import numpy as np

from .. import nmgs
from ..nmgs.cad import divide
from ..nmgs.refit import follows
from . import gradings, shape_library, sources
from .base import DocumentObject
from .block_edges import edges_shape
from .run import run

PROPERTIES = (
    (
        "App::PropertyLinkSubList",
        "Source",
        "Geometry",
        "Faces or solids that the elements are fitted to; empty for elements given by their nodes",
        None,
        0,
    ),
    ("App::PropertyString", "File", "Geometry", "File that the elements were read from", None, 1),
    (
        "App::PropertyString",
        "Library",
        "Geometry",
        "Shape of the library that the elements are; empty for others",
        None,
        1,
    ),
    (
        "App::PropertyString",
        "Arguments",
        "Geometry",
        "Sizes and divisions of the library's shape, as JSON",
        None,
        0,
    ),
    (
        "App::PropertyLength",
        "Size",
        "Fit",
        "Length of the mesh's elements that the divisions follow; 0 chooses one",
        None,
        0,
    ),
    (
        "App::PropertyLength",
        "Tolerance",
        "Fit",
        "Largest distance from the CAD surface that the fit accepts; 0 chooses one",
        None,
        0,
    ),
    ("App::PropertyString", "Method", "Fit", "How solids are cut into blocks", "auto", 0),
    (
        "App::PropertyStringList",
        "EdgeCounts",
        "Fit",
        "Elements along edges of the part, a line each, as Edge3: 12 or Box.Edge3: 12",
        None,
        0,
    ),
    (
        "App::PropertyBool",
        "KeepLayout",
        "Fit",
        "Lay the last fit's blocks over the part again while only its dimensions change",
        False,
        0,
    ),
    (
        "App::PropertyBool",
        "AutoDivisions",
        "Fit",
        "Divisions follow Size; switch off to set Divisions by hand",
        True,
        0,
    ),
    (
        "App::PropertyVectorList",
        "Nodes",
        "Elements",
        "Nodes of all elements, one element after the other, corners first",
        None,
        1,
    ),
    (
        "App::PropertyIntegerList",
        "Divisions",
        "Elements",
        "Number of elements along xi, eta (, zeta), one element after the other",
        None,
        0,
    ),
    (
        "App::PropertyStringList",
        "Grading",
        "Elements",
        "Spacing of each element's directions; empty where all are uniform",
        None,
        1,
    ),
    ("App::PropertyString", "Reference", "Elements", "The user's reference text", None, 0),
    ("App::PropertyInteger", "ElementCount", "Elements", "Number of elements", None, 1),
    (
        "App::PropertyStringList",
        "Report",
        "Fit",
        "What the fit found out about each face or solid",
        None,
        1,
    ),
    (
        "App::PropertyStringList",
        "ReportData",
        "Fit",
        "The fit's report as JSON, one line a face or solid",
        None,
        2,
    ),
)


class Blocking(DocumentObject):
    """Base of Patches and Blocks; a subclass sets nodes_per_element, 8 or 20."""

    properties = PROPERTIES
    nodes_per_element = 0
    text = "Fitting"
    _model: Optional[nmgs.BlockModel] = None
    #: What the last fit started from, to find the document's names of what it says.
    _picked: Optional[sources.Picked] = None
    #: What was asked of the last fit of this session, and what it gave. With KeepLayout its layout
    #: follows the part, always from there: a change that is undone leaves no trace.
    _last: Optional[Tuple[Any, nmgs.BlockModel]] = None
    #: nmgs.fit's report of this session's last fit.
    report: Sequence[Dict[str, Any]] = ()

    def compute(self, obj: Any) -> None:
        model = self._made(obj)
        obj.Shape = edges_shape(model.nodes)
        if obj.Source or obj.Library:
            obj.Nodes = [FreeCAD.Vector(*node) for node in model.nodes.reshape(-1, 3)]
            obj.Divisions = [int(n) for n in model.divisions.ravel()]
        if obj.Source:
            obj.Report = [self._line(entry) for entry in model.report]
            obj.ReportData = [json.dumps(entry, default=_plain) for entry in model.report]
        obj.ElementCount = len(model)
        self.report = model.report
        self._model = model

    def _made(self, obj: Any) -> nmgs.BlockModel:
        if obj.Source:
            return self._fitted(obj)
        return self._from_library(obj) if obj.Library else self._given(obj)

    def _from_library(self, obj: Any) -> nmgs.BlockModel:
        model = shape_library.make_model(obj.Library, obj.Arguments)
        if model.nodes.shape[1] != self.nodes_per_element:
            raise ValueError(
                f"{obj.Label}: {obj.Library} has no {self.nodes_per_element}-node form"
            )
        if not obj.AutoDivisions:
            model.divisions = model._checked_divisions(self._divisions(obj, len(model)))
            gradings.put(model, obj.Grading)
        model.reference = model._checked_reference(obj.Reference or model.reference)
        return model

    def _given(self, obj: Any) -> nmgs.BlockModel:
        count, left = divmod(len(obj.Nodes), self.nodes_per_element)
        if left or not count:
            raise ValueError(
                f"Nodes: expected a multiple of {self.nodes_per_element}, got {len(obj.Nodes)}"
            )
        nodes = np.array([tuple(node) for node in obj.Nodes], dtype=np.float64)
        nodes = nodes.reshape(count, self.nodes_per_element, 3)
        model = nmgs.BlockModel(nodes, self._divisions(obj, count), obj.Reference)
        gradings.put(model, obj.Grading)
        return model

    def _divisions(self, obj: Any, count: int) -> np.ndarray:
        directions = 2 if self.nodes_per_element == 8 else 3
        if len(obj.Divisions) != count * directions:
            raise ValueError(
                f"Divisions: expected {directions} numbers for each of {count} elements, "
                f"got {len(obj.Divisions)}"
            )
        return np.array(obj.Divisions, dtype=np.int64).reshape(count, directions)

    def _fitted(self, obj: Any) -> nmgs.BlockModel:
        picked = sources.gather(obj.Source)
        self._picked = picked
        asked = {
            "tolerance": obj.Tolerance.Value or None,
            "method": obj.Method or "auto",
            "entities": picked.names,
            "counts": edge_counts(obj.EdgeCounts, picked),
        }
        size = obj.Size.Value or None
        model = self._kept(picked.shape, size, asked) if obj.KeepLayout else None
        if model is None:
            model = run(
                lambda progress: nmgs.fit(picked.shape, size=size, progress=progress, **asked),
                self.text,
            )
            self._last = (asked, model.copy())
        if model.nodes.shape[1] != self.nodes_per_element:
            raise nmgs.GeometryError(
                f"{obj.Label}: expected elements of {self.nodes_per_element} nodes, "
                f"the picked geometry gives elements of {model.nodes.shape[1]}"
            )
        if not obj.AutoDivisions:
            wanted = self._divisions(obj, len(model))
            if (wanted != model.divisions).any():
                model.divisions = model._checked_divisions(wanted)
        if not obj.AutoDivisions:
            gradings.put(model, obj.Grading)
        model.reference = model._checked_reference(obj.Reference)
        return model

    def _kept(
        self, shape: Any, size: Optional[float], asked: Dict[str, Any]
    ) -> Optional[nmgs.BlockModel]:
        """The last fit's layout on the shape as it is now; None where that is another one, or does
        not follow it as closely as is asked for."""
        if self._last is None or self._last[0] != asked:
            return None
        last = self._last[1]
        try:
            model = run(lambda progress: nmgs.refit(last, shape, progress), self.text)
            if not follows(model, last, asked["tolerance"]):
                return None
            divide(model, size, asked["counts"])
        except (nmgs.GeometryError, nmgs.BlockingError):
            return None
        return model

    def model(self, obj: Any) -> nmgs.BlockModel:
        """The elements as they are now; fits again when only the document's properties are left."""
        if self._model is None:
            self._model = self._made(obj)
        return self._model

    def shown(self, obj: Any) -> Optional[nmgs.BlockModel]:
        """Nodes, divisions and gradings as the properties have them; nothing is fitted for it."""
        if self._model is not None:
            return self._model
        return self._given(obj) if obj.Nodes else None

    def entries(self, obj: Any) -> List[Dict[str, Any]]:
        """The fit's report, as nmgs.fit gives it, also in a document that was opened."""
        return [json.loads(line) for line in obj.ReportData]

    def culprits(self, names: Sequence[str]) -> List[sources.Entity]:
        """The document's elements that the fit names, e.g. in an error."""
        owners = [self._picked.owner(name) for name in names] if self._picked else []
        return [owner for owner in owners if owner is not None]

    def owner(self, obj: Any, name: str) -> Optional[sources.Entity]:
        """The document's element of a name in the report; None for one that is gone."""
        if self._picked is None and obj.Source:
            try:
                self._picked = sources.gather(obj.Source)
            except nmgs.Error:
                return None
        return self._picked.owner(name) if self._picked else None

    def _line(self, entry: Dict[str, Any]) -> str:
        owner = self.culprits([entry["entity"]])
        who = f"{owner[0][0].Label}.{owner[0][1]}" if owner else entry["entity"]
        if entry["method"]:
            return f"{who}: {entry['method']}, at most {entry['error']:.3g} off the CAD"
        return f"{who}: left out, {entry['reason']}"

    def onChanged(self, obj: Any, prop: str) -> None:
        if prop in (
            "Source",
            "Nodes",
            "Divisions",
            "Grading",
            "Reference",
            "Size",
            "Tolerance",
            "Method",
            "EdgeCounts",
            "KeepLayout",
            "Library",
            "Arguments",
            "AutoDivisions",
        ):
            self._model = None


def edge_counts(lines: Sequence[str], picked: sources.Picked) -> Dict[str, int]:
    """{"Edge3": 12, ...} in the shape of all that is picked, of "Edge3: 12" or "Box.Edge3: 12".
    Raises ValueError that names the line."""
    counts = {}
    for line in lines:
        where, _, count = line.partition(":")
        owner, _, name = where.strip().rpartition(".")
        parts = [p for p in picked.parts if not owner or owner in (p.obj.Name, p.obj.Label)]
        kind, number = name.rstrip("0123456789"), name[4:]
        if kind != "Edge" or not number or not count.strip().isdigit() or not parts:
            raise ValueError(f"EdgeCounts: expected lines like Edge3: 12, got {line!r}")
        counts[f"Edge{parts[0].before['Edge'] + int(number)}"] = int(count)
    return counts


def _plain(value: Any) -> Any:
    """NumPy's numbers and arrays as JSON has them."""
    return value.tolist() if hasattr(value, "tolist") else str(value)


def fill(obj: Any, model: nmgs.BlockModel, path: str = "") -> None:
    """Puts a model that was read or typed into obj's properties."""
    obj.Nodes = [FreeCAD.Vector(*node) for node in model.nodes.reshape(-1, 3)]
    obj.Divisions = [int(n) for n in model.divisions.ravel()]
    obj.Grading = gradings.lines(model)
    obj.Reference = model.reference
    obj.File = path
    obj.AutoDivisions = False
