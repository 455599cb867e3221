# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks and measures that the tests of blocking share; nothing of it uses the code under test."""

import itertools

import numpy as np

QUAD8 = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, -1], [1, 0], [0, 1], [-1, 0]], float)
HEXA20 = np.array(
    [(x, y, -1) for x, y in QUAD8[:4]]
    + [(x, y, 1) for x, y in QUAD8[:4]]
    + [(x, y, -1) for x, y in QUAD8[4:]]
    + [(x, y, 1) for x, y in QUAD8[4:]]
    + [(x, y, 0) for x, y in QUAD8[:4]],
    float,
)


def unit_cube(origin=(0, 0, 0), size=(1, 1, 1)):
    """(20, 3) nodes of an axis-parallel block."""
    return np.asarray(origin, float) + 0.5 * (HEXA20 + 1) * np.asarray(size, float)


def unit_square(origin=(0, 0, 0), size=(1, 1)):
    """(8, 3) nodes of an axis-parallel patch in a plane z = const."""
    nodes = np.zeros((8, 3))
    nodes[:, :2] = 0.5 * (QUAD8 + 1) * np.asarray(size, float)
    return nodes + np.asarray(origin, float)


def rotations():
    """The 24 rotations of a block's numbering, each a permutation of its 20 nodes."""
    result = []
    for axes in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            matrix = np.zeros((3, 3))
            for row, (axis, sign) in enumerate(zip(axes, signs)):
                matrix[row, axis] = sign
            if np.linalg.det(matrix) > 0:
                turned = HEXA20 @ matrix.T
                order = [int(np.argmin(np.abs(HEXA20 - p).sum(axis=1))) for p in turned]
                result.append((order, axes))
    return result


def hexahedron_volumes(points, cells):
    """Exact volumes of trilinear hexahedra by 2 x 2 x 2 Gauss points."""
    corners = points[cells]
    volume = np.zeros(len(cells))
    a = 1 / np.sqrt(3)
    signs = HEXA20[:8]
    for g in itertools.product((-a, a), repeat=3):
        shape = 1 + signs * g
        grads = [signs[:, d] * shape[:, (d + 1) % 3] * shape[:, (d + 2) % 3] / 8 for d in range(3)]
        jacobian = np.stack([np.einsum("i,cij->cj", grad, corners) for grad in grads], axis=1)
        volume += np.linalg.det(jacobian)
    return volume


def quad_areas(points, cells):
    """Half the length of the cross product of the diagonals: exact for flat quads."""
    q = points[cells]
    return 0.5 * np.linalg.norm(np.cross(q[:, 2] - q[:, 0], q[:, 3] - q[:, 1]), axis=1)


def quad_normals(points, cells):
    q = points[cells]
    return np.cross(q[:, 2] - q[:, 0], q[:, 3] - q[:, 1])


HEXA_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def face_counts(cells):
    """How many hexahedra have each face (as a sorted tuple of nodes)."""
    faces = np.sort(np.concatenate([cells[:, list(face)] for face in HEXA_FACES]), axis=1)
    unique, counts = np.unique(faces, axis=0, return_counts=True)
    return unique, counts


def euler_of_solid(cells):
    """V - E + F - C of a mesh of hexahedra: 1 for a ball, 0 for a solid torus."""
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)]
    pairs += [(0, 4), (1, 5), (2, 6), (3, 7)]
    edges = np.unique(np.sort(np.concatenate([cells[:, list(p)] for p in pairs]), axis=1), axis=0)
    return len(np.unique(cells)) - len(edges) + len(face_counts(cells)[0]) - len(cells)


def edge_counts(cells):
    edges = np.concatenate([cells[:, [i, (i + 1) % 4]] for i in range(4)])
    return np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)


def euler_of_surface(cells):
    """V - E + F of a mesh of quads: 2 for a sphere, 1 for a disc, 0 for a torus or tube."""
    return len(np.unique(cells)) - len(edge_counts(cells)[0]) + len(cells)
