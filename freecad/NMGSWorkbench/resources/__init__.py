# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the panels' .ui files and the icons are."""

import pathlib

_HERE = pathlib.Path(__file__).parent


def ui(name: str) -> str:
    """Path of a panel's .ui file."""
    return str(_HERE / f"{name}.ui")


def icon(name: str) -> str:
    """Path of an icon; icons are beside the freecad folder of the addon."""
    return str(_HERE.absolute().parents[2] / "icons" / f"{name}.svg")
