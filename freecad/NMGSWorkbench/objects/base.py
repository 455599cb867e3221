# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all document objects share: properties from a table, errors kept, nothing pickled."""

from __future__ import annotations

import importlib
from typing import Any, List, Optional, Sequence, Tuple

import FreeCAD

from . import reattach, stale

stale.watch()
#: Version of the properties written into documents; raised when their meaning changes.
SCHEMA_VERSION = 1

#: type, name, group, tooltip, default (None: the type's own), editor mode (1 read-only, 2 hidden)
Property = Tuple[str, str, str, str, Any, int]

_SCHEMA: Property = (
    "App::PropertyInteger",
    "SchemaVersion",
    "NMGS",
    "Version of these properties",
    SCHEMA_VERSION,
    2,
)


_CLASS: Property = (
    "App::PropertyString",
    "ProxyClass",
    "NMGS",
    "Python class, for a FreeCAD that has found the workbench again",
    None,
    2,
)


def add_properties(obj: Any, table: Sequence[Property]) -> None:
    """Adds those of the table that obj lacks. Documents of an older version so gain new ones."""
    for kind, name, group, tooltip, default, mode in table:
        if name in obj.PropertiesList:
            continue
        obj.addProperty(kind, name, group, tooltip)
        if default is not None:
            setattr(obj, name, default)
        obj.setEditorMode(name, mode)


class DocumentObject:
    """Base of the proxies. State lives in properties only; attributes of a proxy are caches.

    A subclass sets `properties`, `view` (module, class in viewproviders) and writes compute(obj).
    """

    properties: Sequence[Property] = ()
    view: Tuple[str, str] = ("", "")
    #: What the last recompute raised, for the command that asked for it; None when it went well.
    failure: Optional[BaseException] = None

    def __init__(self, obj: Any):
        self._add_properties(obj)
        obj.Proxy = self
        self._attach_view(obj)

    def _attach_view(self, obj: Any) -> None:
        if not FreeCAD.GuiUp or obj.ViewObject is None:
            return
        package = __package__.rpartition(".")[0]
        module = importlib.import_module(f"{package}.viewproviders.{self.view[0]}")
        getattr(module, self.view[1])(obj.ViewObject)

    def _add_properties(self, obj: Any) -> None:
        add_properties(obj, (_SCHEMA, *self.properties))
        add_properties(obj, (_CLASS,))
        if not obj.ProxyClass:
            obj.ProxyClass = reattach.name_of(self)
        stale.add_property(obj)
        # Everything lies where its nodes are; a recompute takes any other placement back.
        obj.setEditorMode("Placement", 2)

    def onDocumentRestored(self, obj: Any) -> None:
        self._add_properties(obj)
        # A document saved without a window has no view provider and all of its objects hidden.
        if FreeCAD.GuiUp and obj.ViewObject is not None and obj.ViewObject.Proxy is None:
            self._attach_view(obj)
            obj.ViewObject.Visibility = True

    def execute(self, obj: Any) -> None:
        # What has no result yet has nothing to be stale.
        if getattr(obj, "ElementCount", 0) and not stale.at_once():
            stale.mark(obj, True)
            return
        self.failure = None
        try:
            self.compute(obj)
            stale.mark(obj, False)
        except Exception as error:
            self.failure = error
            # FreeCAD writes a traceback of all callers into the report view; this one is enough.
            raise error.with_traceback(None)

    def culprits(self, names: Sequence[str]) -> List[Tuple[Any, str]]:
        """The document's elements that an error of this object names."""
        return []

    def compute(self, obj: Any) -> None:
        """Properties in, result out; raises before anything of obj is changed."""
        raise NotImplementedError

    # FreeCAD asks for these up to 0.21 and for dumps and loads from 0.21 on.
    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None
