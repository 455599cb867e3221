# SPDX-License-Identifier: LGPL-2.1-or-later
"""How alike two pictures look: structural similarity (Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli,
Image quality assessment, IEEE Transactions on Image Processing 13, 2004), over blocks of 8 x 8."""

import numpy as np
from PySide import QtCore, QtGui

WIDTH, HEIGHT, BLOCK = 320, 256, 8
_C1, _C2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2


def grey(image):
    """float64 (HEIGHT, WIDTH) of a QImage."""
    small = image.scaled(
        WIDTH, HEIGHT, QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation
    ).convertToFormat(QtGui.QImage.Format_Grayscale8)
    rows = np.frombuffer(small.constBits(), np.uint8).reshape(HEIGHT, small.bytesPerLine())
    return rows[:, :WIDTH].astype(np.float64)


def similarity(one, other):
    """Mean structural similarity of two QImages: 1 for the same, about 0 for unlike ones."""
    a, b = (
        grey(image)
        .reshape(HEIGHT // BLOCK, BLOCK, WIDTH // BLOCK, BLOCK)
        .swapaxes(1, 2)
        .reshape(-1, BLOCK * BLOCK)
        for image in (one, other)
    )
    mean_a, mean_b = a.mean(axis=1), b.mean(axis=1)
    spread = ((a - mean_a[:, None]) * (b - mean_b[:, None])).mean(axis=1)
    top = (2 * mean_a * mean_b + _C1) * (2 * spread + _C2)
    bottom = (mean_a**2 + mean_b**2 + _C1) * (a.var(axis=1) + b.var(axis=1) + _C2)
    return float((top / bottom).mean())
