# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be asked of the TetGen that is linked."""

from freecad.NMGSWorkbench.nmgs.tetgen.version import tetgen_version

#: Whether it is TetGen 1.6, which differs from 1.5 where the tests say so.
NEWER = tetgen_version() == "1.6"


def volume_bound(limit):
    """The largest volume of a tetrahedron under -a: TetGen 1.5 keeps it to the last digits, 1.6,
    its own program as well, exceeds it by a quarter here and there."""
    return 1.5 * limit if NEWER else limit * (1 + 1e-12)
