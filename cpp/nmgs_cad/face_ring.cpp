// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_ring.h"

#include "nmgs_cad/quad_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmgs::cad {

std::optional<FaceMesh> ring_quads(const FaceSurface &surface,
                                   const std::vector<BoundaryLoop> &boundary, Refusal &refusal) {
    if (boundary.size() != 2 || boundary[0].size() != boundary[1].size()) {
        refusal = {"not two loops with equal numbers of segments bound it", {}};
        return std::nullopt;
    }
    std::vector<std::vector<std::int32_t>> numbers;
    FaceMesh mesh = face_mesh_of(surface, boundary, numbers);
    const std::size_t n = numbers[0].size();
    const auto point = [&](std::int32_t k) { return mesh.points[static_cast<std::size_t>(k)]; };
    const auto uv = [&](std::int32_t k) { return mesh.uv[static_cast<std::size_t>(k)]; };
    const auto partner = [&](std::size_t i, std::size_t turn) {
        return numbers[1][(turn + 2 * n - i) % n];
    };
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    double way = 0;
    for (std::size_t turn = 0; turn < n; ++turn) {
        double sum = 0;
        double length = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double d = distance(point(numbers[0][i]), point(partner(i, turn)));
            sum += d * d;
            length += d / static_cast<double>(n);
        }
        if (sum < least) {
            least = sum;
            best = turn;
            way = length;
        }
    }
    double segment = 0;
    for (std::size_t i = 0; i < n; ++i) {
        segment += distance(point(numbers[0][i]), point(numbers[0][(i + 1) % n]));
        segment += distance(point(numbers[1][i]), point(numbers[1][(i + 1) % n]));
    }
    segment /= 2 * static_cast<double>(n);
    constexpr double longest = 2;
    const int layers = std::clamp(static_cast<int>(std::lround(way / (longest * segment))), 1, 12);
    std::vector<std::int32_t> outer = numbers[0];
    std::vector<std::vector<std::int32_t>> between;
    for (int k = 1; k <= layers; ++k) {
        std::vector<std::int32_t> inner;
        for (std::size_t i = 0; i < n; ++i) {
            const double t = static_cast<double>(k) / layers;
            inner.push_back(k == layers ? partner(i, best)
                                        : mesh.add(surface, (1 - t) * uv(numbers[0][i]) +
                                                                t * uv(partner(i, best))));
        }
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (i + 1) % n;
            mesh.quads.push_back({outer[i], outer[j], inner[j], inner[i]});
        }
        outer = inner;
        if (k < layers) {
            between.push_back(inner);
        }
    }
    constexpr double good = 0.7;
    if (layers > 1 && worst_quality(mesh) < good) {
        smooth_quads(mesh, surface, 5, 20);
    }
    for (std::size_t k = 0; k < between.size(); ++k) {
        const double t = static_cast<double>(k + 1) / layers;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (i + 1) % n;
            mesh.set_middle(surface, between[k][i], between[k][j],
                            (1 - t) * mesh.bend(numbers[0][i], numbers[0][j]) +
                                t * mesh.bend(partner(i, best), partner(j, best)));
        }
    }
    return mesh;
}

} // namespace nmgs::cad
