// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/hexa_to_tetra.h"

#include "nmgs/convert/diagonal.h"
#include "nmgs/support/parallel.h"

#include <array>

namespace nmgs {
namespace {

// Seen from inside, so that a tetrahedron of a face's triangle and the centroid is positive.
constexpr int faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                             {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

} // namespace

void split_hexahedra(std::span<const Vec3> points, std::span<const std::int32_t> hexahedra,
                     std::int32_t first_centroid, std::span<std::int32_t> tetrahedra,
                     std::span<Vec3> centroids, const Progress &progress, double from, double to) {
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
                const std::int32_t centre = first_centroid + static_cast<std::int32_t>(i);
                std::int32_t *t = tetrahedra.data() + 48 * i;
                for (const auto &f : faces) {
                    const std::int32_t a = h[f[0]];
                    const std::int32_t b = h[f[1]];
                    const std::int32_t c = h[f[2]];
                    const std::int32_t d = h[f[3]];
                    const bool joined = joins_second_and_fourth(
                        p[static_cast<std::size_t>(f[0])], p[static_cast<std::size_t>(f[1])],
                        p[static_cast<std::size_t>(f[2])], p[static_cast<std::size_t>(f[3])], a, b,
                        c, d);
                    t[0] = a;
                    t[1] = b;
                    t[2] = joined ? d : c;
                    t[3] = centre;
                    t[4] = c;
                    t[5] = d;
                    t[6] = joined ? b : a;
                    t[7] = centre;
                    t += 8;
                }
            }
        },
        progress, from, to);
}

} // namespace nmgs
