// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/triangle_to_quad.h"

#include "nmgs/convert/matching.h"
#include "nmgs/mesh/edges.h"
#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmgs {
namespace {

// The two triangles at an edge, as first triangle * 3 + its edge; -1 none, -2 for a third one.
struct Sides {
    std::int64_t first = -1, second = -1;
    bool crowded = false;
};

// Corners of the quad round the edge e of triangle t, whose other side ends in `opposite`.
std::array<std::int32_t, 4> quad_over(const std::int32_t *t, std::size_t e, std::int32_t opposite) {
    return {t[(e + 2) % 3], t[e], opposite, t[(e + 1) % 3]};
}

// Verdict's scaled Jacobian: least over the corners of the sine of the angle, signed by the normal.
double scaled_jacobian(const std::array<Vec3, 4> &p) {
    const Vec3 mean = cross(p[2] - p[0], p[3] - p[1]);
    double least = 1;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 ahead = p[(i + 1) % 4] - p[i];
        const Vec3 back = p[(i + 3) % 4] - p[i];
        const double lengths = norm(ahead) * norm(back) * norm(mean);
        least = std::min(least, lengths > 0 ? dot(mean, cross(ahead, back)) / lengths : 0);
    }
    return least;
}

Vec3 normal(std::span<const Vec3> points, const std::int32_t *t) {
    const auto p = [&](int i) { return points[static_cast<std::size_t>(t[i])]; };
    return cross(p(1) - p(0), p(2) - p(0));
}

} // namespace

PairedTriangles pair_triangles(std::span<const Vec3> points,
                               std::span<const std::int32_t> triangles,
                               std::span<const std::int32_t> labels, const Progress &progress) {
    const std::size_t count = triangles.size() / 3;
    if (count > std::numeric_limits<std::int32_t>::max() / 4) {
        throw ArgumentError("triangles: too many to be paired: " + std::to_string(count));
    }
    const CellView view{CellType::triangle, triangles};
    const Edges edges = find_edges(points.size(), {&view, 1}, progress, 0.0, 0.3);
    std::vector<Sides> sides(edges.ends.size());
    for (std::size_t i = 0; i < edges.of_cells[0].size(); ++i) {
        Sides &s = sides[static_cast<std::size_t>(edges.of_cells[0][i])];
        s.crowded = s.crowded || s.second >= 0;
        (s.first < 0 ? s.first : s.second) = static_cast<std::int64_t>(i);
    }
    // More pairs always weigh more than better ones.
    constexpr double steps = 1e4;
    const auto base = static_cast<std::int64_t>(steps) * static_cast<std::int64_t>(count + 1);
    std::vector<WeightedPair> pairs;
    std::vector<std::array<std::int32_t, 4>> quads;
    for (const Sides &s : sides) {
        if (s.second < 0 || s.crowded) {
            continue;
        }
        const auto a = static_cast<std::size_t>(s.first / 3);
        const auto b = static_cast<std::size_t>(s.second / 3);
        if (a == b || (!labels.empty() && labels[a] != labels[b])) {
            continue;
        }
        const std::int32_t *ta = triangles.data() + 3 * a;
        const std::int32_t *tb = triangles.data() + 3 * b;
        const std::int32_t opposite = tb[(s.second + 2) % 3];
        const auto quad = quad_over(ta, static_cast<std::size_t>(s.first % 3), opposite);
        // Seen from the first triangle, even if the second is turned over.
        const bool turned = tb[s.second % 3] == ta[s.first % 3];
        const Vec3 na = normal(points, ta);
        const Vec3 nb = (turned ? -1.0 : 1.0) * normal(points, tb);
        if (!(dot(na, nb) > 0.5 * norm(na) * norm(nb))) {
            continue;
        }
        std::array<Vec3, 4> p{};
        for (std::size_t i = 0; i < 4; ++i) {
            p[i] = points[static_cast<std::size_t>(quad[i])];
        }
        const double quality = scaled_jacobian(p);
        if (quality > 1e-3) {
            pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b),
                             base + std::llround(steps * quality)});
            quads.push_back(quad);
        }
    }
    poll(progress, 0.4);
    const auto mate = maximum_weight_matching(static_cast<std::int32_t>(count), pairs);
    poll(progress, 0.95);
    PairedTriangles result;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (mate[static_cast<std::size_t>(pairs[i].a)] == pairs[i].b) {
            result.quads.push_back(quads[i]);
            result.parents.push_back({pairs[i].a, pairs[i].b});
        }
    }
    for (std::size_t t = 0; t < count; ++t) {
        if (mate[t] < 0) {
            result.left.push_back(static_cast<std::int32_t>(t));
        }
    }
    return result;
}

void split_at_corners(int corners, std::span<const std::int32_t> cells, std::int32_t first_centre,
                      std::span<std::int32_t> quads, const Progress &progress) {
    const auto k = static_cast<std::size_t>(corners);
    parallel_for(
        cells.size() / (2 * k), 1 << 14,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t c = first; c < last; ++c) {
                const std::int32_t *cell = cells.data() + 2 * k * c;
                std::int32_t *out = quads.data() + 4 * k * c;
                for (std::size_t i = 0; i < k; ++i) {
                    *out++ = cell[i];
                    *out++ = cell[k + i];
                    *out++ = first_centre + static_cast<std::int32_t>(c);
                    *out++ = cell[k + (i + k - 1) % k];
                }
            }
        },
        progress);
}

} // namespace nmgs
