# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import os
import tempfile
from typing import Iterator, TextIO


@contextlib.contextmanager
def temporary_beside(path: str) -> Iterator[str]:
    """The name of an empty file in path's folder; it becomes path when the block ends well, and is
    removed when it raises. Raises OSError."""
    folder, base = os.path.split(os.path.abspath(path))
    handle, temporary = tempfile.mkstemp(prefix=base + ".", suffix=".part", dir=folder)
    os.close(handle)
    try:
        yield temporary
        # mkstemp's file is for the owner alone; the result gets what a plain open() would give.
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(temporary, 0o666 & ~mask)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


@contextlib.contextmanager
def replaced_file(path: str) -> Iterator[TextIO]:
    """A text file (UTF-8, line feeds) to write, with the promise of temporary_beside."""
    with temporary_beside(path) as temporary:
        with open(temporary, "w", encoding="utf-8", newline="\n") as file:
            yield file
