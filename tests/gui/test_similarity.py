# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measure by which pictures are compared tells like from unlike."""

import numpy as np
import pytest
from PySide import QtGui
from similarity import HEIGHT, WIDTH, similarity


def image(values):
    """A grey QImage of values (HEIGHT, WIDTH)."""
    data = np.ascontiguousarray(values, dtype=np.uint8)
    made = QtGui.QImage(data.tobytes(), WIDTH, HEIGHT, WIDTH, QtGui.QImage.Format_Grayscale8)
    return made.copy()


@pytest.fixture
def noise():
    return np.random.default_rng(3).integers(0, 256, (HEIGHT, WIDTH))


def test_the_same_is_one(noise):
    assert similarity(image(noise), image(noise)) == pytest.approx(1.0)


def test_another_is_near_zero(noise):
    other = np.random.default_rng(4).integers(0, 256, (HEIGHT, WIDTH))
    assert abs(similarity(image(noise), image(other))) < 0.1


def test_a_negative_is_below_zero(noise):
    assert similarity(image(noise), image(255 - noise)) < -0.5


def test_a_part_that_is_gone_is_seen(noise):
    half = noise.copy()
    half[:, : WIDTH // 2] = 128
    assert 0.4 < similarity(image(noise), image(half)) < 0.6
