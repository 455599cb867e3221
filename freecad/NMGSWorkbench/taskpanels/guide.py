# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user guide in a window of its own."""

from __future__ import annotations

import os
from typing import Any, List

from PySide import QtCore, QtGui

from .. import resources
from ..texts import tr

_windows: List[Any] = []


def show(parent: Any) -> Any:
    """Opens the guide, or brings it to the front. Returns its QTextBrowser."""
    for window in _windows:
        if window.isVisible():
            window.raise_()
            return window.findChild(QtGui.QTextBrowser)
    _windows.clear()
    window = QtGui.QDialog(parent)
    window.setObjectName("NMGS_Guide")
    window.setWindowTitle(tr("NMGS user guide"))
    window.resize(860, 720)
    layout = QtGui.QVBoxLayout(window)
    layout.setContentsMargins(0, 0, 0, 0)
    browser = QtGui.QTextBrowser(window)
    browser.setOpenExternalLinks(True)
    layout.addWidget(browser)
    path = resources.guide()
    browser.setSearchPaths([os.path.dirname(path)])
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    except OSError as error:
        text = str(error)
    document = browser.document()
    # Pictures are named relative to the guide.
    document.setBaseUrl(QtCore.QUrl.fromLocalFile(path))
    document.setMarkdown(text)
    browser.moveCursor(QtGui.QTextCursor.Start)
    window.show()
    _windows.append(window)
    return browser
