// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/hexa_to_tetra.h"

#include "nmgs/convert/diagonal.h"
#include "nmgs/convert/inner_point.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <optional>

namespace nmgs {
namespace {

// Seen from inside, so that a tetrahedron of a face's triangle and the centroid is positive.
constexpr std::size_t faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                     {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

// Writes the twelve tetrahedra of hexahedron h with corners at p. Returns the least of their
// volumes, times six. (Without branches: equal diagonals fall either way at random.)
double split(const std::int32_t *h, const std::array<Vec3, 8> &p, Vec3 centroid,
             std::int32_t centre, std::int32_t *t) {
    std::array<Vec3, 8> r;
    for (std::size_t n = 0; n < 8; ++n) {
        r[n] = p[n] - centroid;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const auto &f : faces) {
        const auto [a, b, c, d] = std::array{f[0], f[1], f[2], f[3]};
        const bool joined = joins_second_and_fourth(p[a], p[b], p[c], p[d], h[a], h[b], h[c], h[d]);
        // The diagonal runs from `from` to `to`; the triangles are (e, from', to') around it.
        const std::size_t from = joined ? b : c;
        const std::size_t to = joined ? d : a;
        const Vec3 n = cross(r[to], r[from]);
        const double v1 = dot(n, r[joined ? a : b]);
        const double v2 = -dot(n, r[joined ? c : d]);
        least = std::min(least, std::min(v1, v2));
        t[0] = h[a];
        t[1] = h[b];
        t[2] = h[joined ? d : c];
        t[3] = centre;
        t[4] = h[c];
        t[5] = h[d];
        t[6] = h[joined ? b : a];
        t[7] = centre;
        t += 8;
    }
    return least;
}

// Where the centroid would leave a tetrahedron without volume, a better place if there is one.
std::optional<Vec3> place_inside(std::span<const Vec3> points, const std::int32_t *t) {
    std::array<std::array<Vec3, 3>, 12> triangles;
    for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t n = 0; n < 3; ++n) {
            triangles[i][n] = points[static_cast<std::size_t>(t[4 * i + n])];
        }
    }
    return inner_point(triangles);
}

} // namespace

std::vector<FlippedFace>
split_hexahedra(std::span<const Vec3> points, std::span<const std::int32_t> hexahedra,
                std::int32_t first_centroid, std::span<std::int32_t> tetrahedra,
                std::span<Vec3> centroids, const Progress &progress, double from, double to) {
    std::vector<std::int64_t> bad;
    std::mutex bad_mutex;
    parallel_for(
        hexahedra.size() / 8, 1 << 13,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const std::int32_t *h = hexahedra.data() + 8 * i;
                std::array<Vec3, 8> p;
                Vec3 sum{0, 0, 0};
                for (std::size_t n = 0; n < 8; ++n) {
                    p[n] = points[static_cast<std::size_t>(h[n])];
                    sum += p[n];
                }
                centroids[i] = 0.125 * sum;
                std::int32_t *t = tetrahedra.data() + 48 * i;
                const double least =
                    split(h, p, centroids[i], first_centroid + static_cast<std::int32_t>(i), t);
                if (!(least > 0)) {
                    if (const auto inside = place_inside(points, t)) {
                        centroids[i] = *inside;
                    } else {
                        const std::lock_guard lock(bad_mutex);
                        bad.push_back(static_cast<std::int64_t>(i));
                    }
                }
            }
        },
        progress, from, to);
    if (bad.empty()) {
        return {};
    }
    std::sort(bad.begin(), bad.end());
    return flip_diagonals(points, hexahedra, bad, tetrahedra, centroids);
}

} // namespace nmgs
