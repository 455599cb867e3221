# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of the window in the user's language. scripts/translate finds every tr("...")."""

from __future__ import annotations


def tr(text: str) -> str:
    """The text in FreeCAD's language; the text itself where there is no translation."""
    import FreeCAD  # only here: plain Python has none

    return FreeCAD.Qt.translate("NMGS", text)
