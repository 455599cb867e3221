# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis's hemisphere, out of the shape library."""

from __future__ import annotations

import json
from typing import Any

from ..objects import patches, structured_mesh


def make(document: Any) -> None:
    """Patches and their quads."""
    laid = patches.make(document, "Hemisphere")
    laid.Library = "hemisphere"
    laid.Arguments = json.dumps({"radius": 10.0, "divisions": 6, "pieces": 2})
    mesh = structured_mesh.make(document, "Quads")
    mesh.Blocks = laid
