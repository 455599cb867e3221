# SPDX-License-Identifier: LGPL-2.1-or-later
"""Update what is stale."""

from __future__ import annotations

from typing import Any

import FreeCAD

from ..objects import stale
from .base import Command


class Update(Command):
    accel = "N, U"
    icon_name = "nmgs_update"
    menu_text = "Update"
    tooltip = "Compute again the blocks and meshes whose geometry or divisions have changed"

    def ready(self) -> bool:
        return any(getattr(obj, "Stale", False) for obj in FreeCAD.ActiveDocument.Objects)

    def act(self, document: Any) -> Any:
        for obj in stale.update(document):
            if obj.Proxy.failure is not None:
                raise obj.Proxy.failure
        return None
