# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh as a file inside the document: arrays of NumPy, nothing pickled."""

from __future__ import annotations

import os
import tempfile
from typing import Any, Dict

import numpy as np

from .. import nmgs


def put(obj: Any, prop: str, mesh: nmgs.Mesh) -> None:
    """Writes the mesh into an App::PropertyFileIncluded."""
    arrays: Dict[str, np.ndarray] = {"points": mesh.points}
    for name, nodes in mesh.cells.items():
        arrays[f"cells/{name}"] = nodes
    # Names of groups are the user's; as numbers they cannot clash with what a zip file allows.
    names = [[name, kind] for name, (kind, _) in mesh.groups.items()]
    arrays["groups"] = np.array(names, dtype=np.str_).reshape(-1, 2)
    for number, (_, indices) in enumerate(mesh.groups.values()):
        arrays[f"group/{number}"] = indices
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.npz")
        np.savez(path, **arrays)
        setattr(obj, prop, path)


def get(path: str) -> nmgs.Mesh:
    """The mesh of a file that put() wrote. Raises nmgs.FormatError."""
    try:
        with np.load(path, allow_pickle=False) as arrays:
            cells = {
                key.partition("/")[2]: arrays[key] for key in arrays if key.startswith("cells/")
            }
            groups = {
                str(name): (str(kind), arrays[f"group/{number}"])
                for number, (name, kind) in enumerate(arrays["groups"])
            }
            return nmgs.Mesh(arrays["points"], cells, groups)
    except (KeyError, ValueError, OSError) as error:
        raise nmgs.FormatError(f"{path}: not a mesh of NMGS: {error}", path) from error
