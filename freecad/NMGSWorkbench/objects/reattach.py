# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python classes back onto objects that a FreeCAD without the workbench has saved."""

from __future__ import annotations

import importlib
from typing import Any

#: Modules beside this one that a document may name.
_KNOWN = ("blocks", "patches", "structured_mesh", "tetgen_mesh", "imported_mesh", "plc")


def name_of(proxy: Any) -> str:
    """What a document keeps of a proxy's class: "module.Class"."""
    return f"{type(proxy).__module__.rpartition('.')[2]}.{type(proxy).__name__}"


def reattach(obj: Any) -> None:
    """Gives obj the proxy that its ProxyClass names; leaves it alone when that is not of here."""
    module, _, name = obj.ProxyClass.partition(".")
    if module not in _KNOWN:
        return
    kind = getattr(importlib.import_module(f".{module}", __package__), name, None)
    if kind is None:
        return
    # Not by its constructor: that would set properties of a new object.
    proxy = kind.__new__(kind)
    obj.Proxy = proxy
    proxy.onDocumentRestored(obj)
    obj.purgeTouched()
