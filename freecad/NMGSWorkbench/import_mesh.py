# SPDX-License-Identifier: LGPL-2.1-or-later
"""File > Open, Import and Export of meshes: .n2r, .n3r, .ele and what nmgs.write knows."""

from __future__ import annotations

from typing import Any, Sequence

from . import export_object, import_into
from .objects.make import mesh_from_file


def open(filename: str) -> Any:  # FreeCAD asks for this name
    """A new document with what is in the file; returns the document."""
    return import_into.new_document(filename, mesh_from_file)


def insert(filename: str, document_name: str) -> Any:
    """Adds what is in the file to a document, as one undo step; returns the object."""
    return import_into.document(filename, document_name, mesh_from_file)


def export(objects: Sequence[Any], filename: str) -> None:
    """Writes the one picked mesh."""
    export_object.write_only(objects, filename)
