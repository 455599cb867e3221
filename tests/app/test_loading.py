# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon in a FreeCAD of its own: with and without the kernel, with nothing but a Mod folder."""

import os
import pathlib
import shutil
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def freecad(home, code):
    """What a fresh freecadcmd prints for the code."""
    done = subprocess.run(
        [shutil.which("freecadcmd"), "-c", code],
        env={**os.environ, "FREECAD_USER_HOME": str(home), "PYTHONPATH": ""},
        capture_output=True,
        text=True,
        timeout=120,
    )
    return done.stdout + done.stderr


@pytest.fixture
def without_kernel(tmp_path):
    addon = tmp_path / "Mod" / "NMGSWorkbench"
    addon.mkdir(parents=True)
    for name in ("freecad", "icons", "package.xml"):
        (addon / name).symlink_to(ROOT / name)
    return tmp_path


def test_without_the_kernel_the_types_are_known_and_its_use_says_what_is_missing(
    without_kernel, tmp_path
):
    path = tmp_path / "some.n2s"
    path.write_text("NMGS-SSMG Problem Setup File\n")
    said = freecad(
        without_kernel,
        "import sys, FreeCAD\n"
        "print('TYPES', FreeCAD.getImportType('n2s'))\n"
        "print('HEAVY', [m for m in ('numpy', 'Part', 'Fem') if m in sys.modules])\n"
        "from freecad.NMGSWorkbench import import_blocks, nmgs\n"
        f"try: import_blocks.open({str(path)!r})\n"
        "except nmgs.KernelMissing as error: print('MISSING', error)\n",
    )
    assert "TYPES ['freecad.NMGSWorkbench.import_blocks']" in said
    # Starting FreeCAD costs nothing more for having the addon.
    assert "HEAVY []" in said
    assert "MISSING NMGS: the compiled kernel nmgs_kernel.core cannot be loaded" in said
    assert "scripts/build" in said


def test_plain_python_gets_the_console_api_without_freecad():
    code = (
        "import sys\n"
        # FreeCAD 1.0's own package "freecad", where ours is found, imports FreeCAD by itself.
        "import freecad\n"
        "before = set(sys.modules)\n"
        "import freecad.NMGSWorkbench\n"
        "assert 'numpy' not in sys.modules\n"
        "from freecad.NMGSWorkbench import nmgs\n"
        "new = set(sys.modules) - before\n"
        "assert not new & {'FreeCAD', 'FreeCADGui', 'Part', 'nmgs_kernel'}, new\n"
    )
    done = subprocess.run(
        [ROOT / "scripts" / "python", "-c", code], capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
