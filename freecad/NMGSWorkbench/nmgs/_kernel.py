# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one place that imports the compiled kernels, so that the rest imports without them."""

from __future__ import annotations

import importlib
import pathlib
import sys
from types import ModuleType

from .errors import KernelMissing


def _load(name: str) -> ModuleType:
    try:
        return importlib.import_module("nmgs_kernel." + name)
    except ImportError as error:
        raise KernelMissing(
            f"NMGS: the compiled kernel nmgs_kernel.{name} cannot be loaded in Python "
            f"{sys.version_info.major}.{sys.version_info.minor} ({error}). Install it with "
            "'pip install nmgs-kernel' for FreeCAD's own Python, with the Debian package "
            "nmgs-workbench, or build it with scripts/build."
        ) from error


def core() -> ModuleType:
    """The kernel without CAD. Raises KernelMissing."""
    return _load("core")


def cad() -> ModuleType:
    """The kernel that needs OpenCASCADE. Raises KernelMissing."""
    return _load("cad")


def worker() -> pathlib.Path:
    """The nmgs-tet executable. Raises KernelMissing."""
    package = _load("core").__file__
    path = pathlib.Path(package).with_name(
        "nmgs-tet.exe" if sys.platform == "win32" else "nmgs-tet"
    )
    if not path.is_file():
        raise KernelMissing(f"NMGS: the TetGen worker {path.name} is missing beside {package}.")
    return path
