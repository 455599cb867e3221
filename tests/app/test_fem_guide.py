# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ten lines of docs/fem.md, as they stand there."""

import contextlib
import io
import pathlib
import re
import shutil

import pytest

GUIDE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "fem.md"


@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
def test_ten_lines(document):
    code = re.search(r"```python\n(.*?)```", GUIDE.read_text(encoding="utf-8"), re.S).group(1)
    statements = [line for line in code.splitlines() if line and "import" not in line]
    assert len(statements) <= 10
    told = io.StringIO()
    with contextlib.redirect_stdout(told):
        exec(compile(code, str(GUIDE), "exec"), {})  # what a user types
    moved = float(told.getvalue().split()[-2])
    # F L / (E A) of a bar; the held end cannot bulge, which makes it a little stiffer.
    assert moved == pytest.approx(1000 * 100 / (210000 * 100), rel=0.03)
