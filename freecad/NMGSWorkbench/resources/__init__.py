# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the panels' .ui files, the translations, the icons and the guide are."""

import pathlib

_HERE = pathlib.Path(__file__).parent
#: The addon's own folder: icons, docs and examples are beside its freecad folder.
_ADDON = _HERE.absolute().parents[2]
#: Folder of the .qm files.
TRANSLATIONS = str(_HERE / "translations")


def ui(name: str) -> str:
    """Path of a panel's .ui file."""
    return str(_HERE / f"{name}.ui")


def icons() -> str:
    """The folder of the icons."""
    return str(_ADDON / "icons")


def icon(name: str) -> str:
    """Path of an icon."""
    return str(_ADDON / "icons" / f"{name}.svg")


def guide() -> str:
    """Path of the user guide."""
    return str(_ADDON / "docs" / "guide.md")
