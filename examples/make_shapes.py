# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes hemisphere.n2s, the thesis's five patches (Fig. 2.4), and ball.n3s beside this file.

Run with scripts/python examples/make_shapes.py.
"""

import pathlib

from freecad.NMGSWorkbench import nmgs

HERE = pathlib.Path(__file__).parent


def main() -> None:
    hemisphere = nmgs.shapes.hemisphere(divisions=8)
    hemisphere.reference = "Hemisphere of radius 1 from five patches"
    nmgs.write(HERE / "hemisphere.n2s", hemisphere)
    ball = nmgs.shapes.ball(divisions=4)
    ball.reference = "Ball of radius 1"
    nmgs.write(HERE / "ball.n3s", ball)


main()
