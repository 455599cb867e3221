// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/quad_to_triangle.h"

#include "nmgs/convert/diagonal.h"
#include "nmgs/support/parallel.h"

namespace nmgs {
namespace {

constexpr std::size_t grain = 1 << 15;

bool joins(std::span<const Vec3> points, const std::int32_t *q, EqualDiagonals rule) {
    const auto p = [&](int i) { return points[static_cast<std::size_t>(q[i])]; };
    return rule == EqualDiagonals::lowest_node
               ? joins_second_and_fourth(p(0), p(1), p(2), p(3), q[0], q[1], q[2], q[3])
               : joins_second_and_fourth(p(0), p(1), p(2), p(3));
}

} // namespace

void split_quads(std::span<const Vec3> points, std::span<const std::int32_t> quads,
                 EqualDiagonals rule, std::span<std::int32_t> triangles, const Progress &progress,
                 double from, double to) {
    parallel_for(
        quads.size() / 4, grain,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const std::int32_t *q = quads.data() + 4 * i;
                std::int32_t *t = triangles.data() + 6 * i;
                const bool joined = joins(points, q, rule);
                t[0] = q[0];
                t[1] = q[1];
                t[2] = joined ? q[3] : q[2];
                t[3] = q[2];
                t[4] = q[3];
                t[5] = joined ? q[1] : q[0];
            }
        },
        progress, from, to);
}

void triangulation_parameters(std::span<const Vec3> points, std::span<const std::int32_t> quads,
                              EqualDiagonals rule, std::span<std::uint8_t> parameters,
                              const Progress &progress) {
    parallel_for(
        quads.size() / 4, grain,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                parameters[i] = joins(points, quads.data() + 4 * i, rule) ? 1 : 0;
            }
        },
        progress);
}

} // namespace nmgs
