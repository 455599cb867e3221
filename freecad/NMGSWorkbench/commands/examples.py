# SPDX-License-Identifier: LGPL-2.1-or-later
"""Examples."""

from __future__ import annotations

from .panel import NewCommand


class Examples(NewCommand):
    icon_name = "nmgs_examples"
    menu_text = "Examples"
    tooltip = "Ready documents to start from: each shows one way from geometry to a mesh"
    panel_name = ("examples", "ExamplesPanel")

    def argument(self) -> None:
        """An example is a document of its own."""
        return None
