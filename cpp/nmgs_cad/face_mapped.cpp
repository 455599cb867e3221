// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_mapped.h"

#include "nmgs_cad/quad_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nmgs::cad {
namespace {

constexpr double pi = std::numbers::pi;

} // namespace

std::optional<LogicalSides> logical_sides(const FaceLoops &loops, Refusal &refusal) {
    if (loops.loops.size() != 1 || !loops.inner.empty() || !loops.points.empty()) {
        refusal = {"more than one loop bounds the face", {}};
        return std::nullopt;
    }
    const FaceLoop &loop = loops.loops.front();
    for (const EdgeUse &use : loop) {
        if (use.degenerated) {
            refusal = {"it has a pole at " + entity_name(0, use.vertex),
                       {entity_name(0, use.vertex)}};
            return std::nullopt;
        }
    }
    if (loop.size() < 4) {
        refusal = {"it has fewer than four edges", {}};
        return std::nullopt;
    }
    // The corners are the four least angles.
    std::vector<std::size_t> order(loop.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return loop[a].angle < loop[b].angle; });
    constexpr double widest_corner = 0.88 * pi;
    constexpr double least_straight = 0.72 * pi;
    constexpr double most_straight = 1.3 * pi;
    if (loop[order[3]].angle > widest_corner ||
        (loop.size() > 4 && (loop[order[4]].angle < least_straight ||
                             loop[order[4]].angle - loop[order[3]].angle < 0.05 * pi)) ||
        loop[order.back()].angle > most_straight) {
        refusal = {"its corners do not divide it into four sides", {}};
        return std::nullopt;
    }
    LogicalSides sides{};
    std::copy(order.begin(), order.begin() + 4, sides.corner.begin());
    std::sort(sides.corner.begin(), sides.corner.end());
    return sides;
}

std::optional<FaceMesh> mapped_quads(const FaceSurface &surface, const LogicalSides &sides,
                                     const std::vector<BoundaryLoop> &boundary, Refusal &refusal) {
    std::vector<std::vector<std::int32_t>> numbers;
    FaceMesh mesh = face_mesh_of(surface, boundary, numbers);
    const BoundaryLoop &loop = boundary.front();
    const auto count = loop.size();
    // Nodes of each side, both ends included.
    std::array<std::vector<std::int32_t>, 4> side;
    for (std::size_t s = 0; s < 4; ++s) {
        std::size_t i = 0;
        while (i < count && !(loop[i].vertex && loop[i].use == sides.corner[s])) {
            ++i;
        }
        const std::size_t end = sides.corner[(s + 1) % 4];
        for (std::size_t k = 0; k <= count; ++k) {
            const BoundaryNode &node = loop[(i + k) % count];
            side[s].push_back(numbers[0][(i + k) % count]);
            if (k > 0 && node.vertex && node.use == end) {
                break;
            }
        }
    }
    const std::size_t m = side[0].size() - 1;
    const std::size_t n = side[1].size() - 1;
    if (m != side[2].size() - 1 || n != side[3].size() - 1) {
        refusal = {"opposite sides have different numbers of segments", {}};
        return std::nullopt;
    }
    // Shares of the lengths of opposite sides, which the parameters inside are interpolated by.
    const auto shares = [&](const std::vector<std::int32_t> &nodes, bool backwards) {
        std::vector<double> t{0};
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            const std::size_t a = backwards ? nodes.size() - 1 - i : i;
            const std::size_t b = backwards ? a - 1 : a + 1;
            t.push_back(t.back() + distance(mesh.points[static_cast<std::size_t>(nodes[a])],
                                            mesh.points[static_cast<std::size_t>(nodes[b])]));
        }
        for (double &x : t) {
            x /= t.back() > 0 ? t.back() : 1;
        }
        return t;
    };
    const auto bottom = shares(side[0], false);
    const auto top = shares(side[2], true);
    const auto right = shares(side[1], false);
    const auto left = shares(side[3], true);
    std::vector<std::int32_t> grid((m + 1) * (n + 1), -1);
    const auto node = [&](std::size_t i, std::size_t j) -> std::int32_t & {
        return grid[j * (m + 1) + i];
    };
    for (std::size_t i = 0; i <= m; ++i) {
        node(i, 0) = side[0][i];
        node(i, n) = side[2][m - i];
    }
    for (std::size_t j = 0; j <= n; ++j) {
        node(m, j) = side[1][j];
        node(0, j) = side[3][n - j];
    }
    const auto uv = [&](std::size_t i, std::size_t j) {
        return mesh.uv[static_cast<std::size_t>(node(i, j))];
    };
    for (std::size_t j = 1; j < n; ++j) {
        for (std::size_t i = 1; i < m; ++i) {
            // Where the lines between the shares cross.
            const double a = bottom[i];
            const double b = top[i];
            const double c = left[j];
            const double d = right[j];
            const double det = 1 - (b - a) * (d - c);
            const double s = std::abs(det) > 1e-6 ? (a + c * (b - a)) / det : a;
            const double t = std::abs(det) > 1e-6 ? (c + a * (d - c)) / det : c;
            const Uv along = (1 - t) * uv(i, 0) + t * uv(i, n);
            const Uv across = (1 - s) * uv(0, j) + s * uv(m, j);
            const Uv corners = (1 - s) * ((1 - t) * uv(0, 0) + t * uv(0, n)) +
                               s * ((1 - t) * uv(m, 0) + t * uv(m, n));
            node(i, j) = mesh.add(surface, along + across - corners);
        }
    }
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < m; ++i) {
            mesh.quads.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
        }
    }
    constexpr double good = 0.7;
    if (worst_quality(mesh) < good) {
        smooth_quads(mesh, surface, 10, 20);
    }
    // Sides inside bend as the boundary's on both ends of their row do.
    for (std::size_t i = 0; i < m; ++i) {
        const Uv low = mesh.bend(node(i, 0), node(i + 1, 0));
        const Uv high = mesh.bend(node(i, n), node(i + 1, n));
        for (std::size_t j = 1; j < n; ++j) {
            const double t = 0.5 * (left[j] + right[j]);
            mesh.set_middle(surface, node(i, j), node(i + 1, j), (1 - t) * low + t * high);
        }
    }
    for (std::size_t j = 0; j < n; ++j) {
        const Uv low = mesh.bend(node(0, j), node(0, j + 1));
        const Uv high = mesh.bend(node(m, j), node(m, j + 1));
        for (std::size_t i = 1; i < m; ++i) {
            const double t = 0.5 * (bottom[i] + top[i]);
            mesh.set_middle(surface, node(i, j), node(i, j + 1), (1 - t) * low + t * high);
        }
    }
    return mesh;
}

} // namespace nmgs::cad
