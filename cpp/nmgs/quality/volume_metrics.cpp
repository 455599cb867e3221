// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/volume_metrics.h"

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/quality/surface_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

namespace nmgs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double ratio(double numerator, double denominator, double otherwise) {
    return denominator > 0 ? numerator / denominator : otherwise;
}

// J of three edges by the product of their lengths.
double scaled(Vec3 a, Vec3 b, Vec3 c) {
    return ratio(determinant(a, b, c), std::sqrt(norm2(a) * norm2(b) * norm2(c)), 0);
}

// Knupp's shape of a corner: 3 J^(2/3) by the sum of the squared edges.
double corner_shape(Vec3 a, Vec3 b, Vec3 c) {
    const double j = determinant(a, b, c);
    return j > 0 ? ratio(3 * std::cbrt(j * j), norm2(a) + norm2(b) + norm2(c), 0) : 0;
}

struct TetraEdges {
    Vec3 a, b, c; // from node 0 to nodes 1, 2, 3
    double jacobian;
    explicit TetraEdges(const Vec3 *p)
        : a(p[1] - p[0]), b(p[2] - p[0]), c(p[3] - p[0]), jacobian(determinant(a, b, c)) {}
};

// The three neighbours of each corner of a hexahedron, right-handed.
constexpr int hexa_corners[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                    {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
constexpr int wedge_corners[6][3] = {{1, 2, 3}, {2, 0, 4}, {0, 1, 5},
                                     {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};

struct Axes {
    Vec3 x, y, z;
    explicit Axes(const Vec3 *p)
        : x(p[1] + p[2] + p[5] + p[6] - p[0] - p[3] - p[4] - p[7]),
          y(p[2] + p[3] + p[6] + p[7] - p[0] - p[1] - p[4] - p[5]),
          z(p[4] + p[5] + p[6] + p[7] - p[0] - p[1] - p[2] - p[3]) {}
};

// An edge a-b seen from a, with the neighbours of a in the two faces that share the edge, ordered
// so that (b - a, c - a, d - a) is right-handed in a good cell.
struct Hinge {
    int a, b, c, d;
};

std::vector<Hinge> make_hinges(CellType type) {
    // In an outward face (..., a, b, ...) the cell lies to the left of a-b; d is the corner before
    // a. The other face has (b, a): c is the corner behind a.
    std::map<std::array<int, 2>, int> before;
    std::map<std::array<int, 2>, int> behind;
    for (const LocalFace &face : faces(type)) {
        const int n = corner_count(face.type);
        const auto at = [&](int i) { return face.nodes[static_cast<std::size_t>((i + n) % n)]; };
        for (int i = 0; i < n; ++i) {
            before[{at(i), at(i + 1)}] = at(i - 1);
            behind[{at(i + 1), at(i)}] = at(i + 2);
        }
    }
    std::vector<Hinge> hinges;
    for (const auto &[edge, d] : before) {
        // A tetrahedron's two ends of an edge give the same angle.
        if (type != CellType::tetra || edge[0] < edge[1]) {
            hinges.push_back({edge[0], edge[1], behind[edge], d});
        }
    }
    return hinges;
}

const std::vector<Hinge> &hinges(CellType type) {
    static const auto tetra = make_hinges(CellType::tetra);
    static const auto pyramid = make_hinges(CellType::pyramid);
    static const auto wedge = make_hinges(CellType::wedge);
    static const auto hexahedron = make_hinges(CellType::hexahedron);
    switch (type) {
    case CellType::tetra:
        return tetra;
    case CellType::pyramid:
        return pyramid;
    case CellType::wedge:
        return wedge;
    default:
        return hexahedron;
    }
}

// Angle of the cell between the two faces, in degrees, 0 to 360.
double dihedral(const Hinge &hinge, const Vec3 *p) {
    const Vec3 e = p[hinge.b] - p[hinge.a];
    const Vec3 c = p[hinge.c] - p[hinge.a];
    const Vec3 d = p[hinge.d] - p[hinge.a];
    const Vec3 m = cross(e, c);
    const Vec3 n = cross(e, d);
    // |m x n| = |e| |det|: sine and cosine up to the same factor.
    const double angle = std::atan2(norm(e) * determinant(e, c, d), dot(m, n));
    return (angle < 0 ? angle + 2 * std::numbers::pi : angle) * 180 / std::numbers::pi;
}

} // namespace

namespace tetra {

double volume(const Vec3 *p) {
    return TetraEdges(p).jacobian / 6;
}

double scaled_jacobian(const Vec3 *p) {
    const TetraEdges e(p);
    const double a = norm2(e.a);
    const double b = norm2(e.b);
    const double c = norm2(e.c);
    const double ab = norm2(e.b - e.a);
    const double bc = norm2(e.c - e.b);
    const double ca = norm2(e.a - e.c);
    const double most = std::sqrt(std::max({a * b * c, a * ab * ca, b * ab * bc, c * bc * ca}));
    return std::numbers::sqrt2 * ratio(e.jacobian, most, 0);
}

double shape(const Vec3 *p) {
    const TetraEdges e(p);
    if (!(e.jacobian > 0)) {
        return 0;
    }
    const double squares = 1.5 * (norm2(e.a) + norm2(e.b) + norm2(e.c)) -
                           (dot(e.a, e.b) + dot(e.b, e.c) + dot(e.c, e.a));
    return ratio(3 * std::cbrt(2 * e.jacobian * e.jacobian), squares, 0);
}

double aspect_ratio(const Vec3 *p) {
    const TetraEdges e(p);
    const double surface = norm(cross(e.a, e.b)) + norm(cross(e.b, e.c)) + norm(cross(e.c, e.a)) +
                           norm(cross(e.b - e.a, e.c - e.a));
    const double longest = std::sqrt(std::max({norm2(e.a), norm2(e.b), norm2(e.c), norm2(e.b - e.a),
                                               norm2(e.c - e.b), norm2(e.a - e.c)}));
    return ratio(longest * surface, 2 * std::sqrt(6.0) * e.jacobian, infinity);
}

double radius_edge_ratio(const Vec3 *p) {
    const TetraEdges e(p);
    const Vec3 v =
        norm2(e.a) * cross(e.b, e.c) + norm2(e.b) * cross(e.c, e.a) + norm2(e.c) * cross(e.a, e.b);
    const double shortest =
        std::sqrt(std::min({norm2(e.a), norm2(e.b), norm2(e.c), norm2(e.b - e.a), norm2(e.c - e.b),
                            norm2(e.a - e.c)}));
    return ratio(norm(v), 2 * std::abs(e.jacobian) * shortest, infinity);
}

} // namespace tetra

namespace hexahedron {

double scaled_jacobian(const Vec3 *p) {
    const Axes axes(p);
    double least = scaled(axes.x, axes.y, axes.z);
    for (int i = 0; i < 8; ++i) {
        const auto &n = hexa_corners[i];
        least = std::min(least, scaled(p[n[0]] - p[i], p[n[1]] - p[i], p[n[2]] - p[i]));
    }
    return least;
}

double shape(const Vec3 *p) {
    const Axes axes(p);
    double least = corner_shape(axes.x, axes.y, axes.z);
    for (int i = 0; i < 8; ++i) {
        const auto &n = hexa_corners[i];
        least = std::min(least, corner_shape(p[n[0]] - p[i], p[n[1]] - p[i], p[n[2]] - p[i]));
    }
    return least;
}

double aspect_ratio(const Vec3 *p) {
    const Axes axes(p);
    const auto [least, most] = std::minmax({norm(axes.x), norm(axes.y), norm(axes.z)});
    return ratio(most, least, infinity);
}

double skew(const Vec3 *p) {
    const Axes axes(p);
    const double x = norm(axes.x);
    const double y = norm(axes.y);
    const double z = norm(axes.z);
    return std::max({std::abs(ratio(dot(axes.x, axes.y), x * y, 0)),
                     std::abs(ratio(dot(axes.y, axes.z), y * z, 0)),
                     std::abs(ratio(dot(axes.z, axes.x), z * x, 0))});
}

} // namespace hexahedron

namespace wedge {

double scaled_jacobian(const Vec3 *p) {
    double least = infinity;
    for (int i = 0; i < 6; ++i) {
        const auto &n = wedge_corners[i];
        least = std::min(least, scaled(p[n[0]] - p[i], p[n[1]] - p[i], p[n[2]] - p[i]));
    }
    return 2 / std::numbers::sqrt3 * least;
}

} // namespace wedge

namespace pyramid {

double scaled_jacobian(const Vec3 *p) {
    double least = infinity;
    for (int i = 0; i < 4; ++i) {
        least = std::min(least, scaled(p[(i + 1) % 4] - p[i], p[(i + 3) % 4] - p[i], p[4] - p[i]));
    }
    return std::min(1.0, std::numbers::sqrt2 * least);
}

} // namespace pyramid

namespace solid {

double volume(CellType type, const Vec3 *p) {
    // Divergence theorem over the faces; a bilinear face gives the mean of its two triangulations.
    // Taken from the first node, so that cells far from the origin lose no digits.
    double total = 0;
    for (const LocalFace &face : faces(type)) {
        const auto q = [&](std::size_t i) { return p[face.nodes[i]] - p[0]; };
        if (face.type == CellType::triangle) {
            total += 2 * determinant(q(0), q(1), q(2));
        } else {
            total += determinant(q(0), q(1), q(2)) + determinant(q(1), q(2), q(3)) +
                     determinant(q(2), q(3), q(0)) + determinant(q(3), q(0), q(1));
        }
    }
    return total / 12;
}

double min_angle(CellType type, const Vec3 *p) {
    double least = infinity;
    for (const Hinge &hinge : hinges(type)) {
        least = std::min(least, dihedral(hinge, p));
    }
    return least;
}

double max_angle(CellType type, const Vec3 *p) {
    double most = 0;
    for (const Hinge &hinge : hinges(type)) {
        most = std::max(most, dihedral(hinge, p));
    }
    return most;
}

double warpage(CellType type, const Vec3 *p) {
    double most = 0;
    for (const LocalFace &face : faces(type)) {
        if (face.type == CellType::quad) {
            const std::array<Vec3, 4> q{p[face.nodes[0]], p[face.nodes[1]], p[face.nodes[2]],
                                        p[face.nodes[3]]};
            most = std::max(most, quad::warpage(q.data()));
        }
    }
    return most;
}

} // namespace solid
} // namespace nmgs
