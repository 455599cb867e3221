# SPDX-License-Identifier: LGPL-2.1-or-later
"""After random undo, redo, change and recompute a document equals a fresh recompute."""

import os

import pytest
from random_steps import run


@pytest.mark.parametrize("seed", range(3))
def test_random_steps(seed):
    assert run(int(os.environ.get("NMGS_RANDOM_STEPS", "60")), seed) == []
