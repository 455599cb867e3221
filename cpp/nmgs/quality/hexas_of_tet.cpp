// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/hexas_of_tet.h"

#include <algorithm>
#include <cmath>

namespace nmgs {
namespace {

double scaled(Vec3 u, Vec3 v, Vec3 w) {
    const double l = norm2(u) * norm2(v) * norm2(w);
    return l > 0 ? determinant(u, v, w) / std::sqrt(l) : -1;
}

} // namespace

double hexas_quality(const std::array<Vec3, 4> &p, const std::array<Vec3, 6> &m,
                     const std::array<Vec3, 4> &f, double floor) {
    Vec3 c{0, 0, 0};
    for (const Vec3 q : p) {
        c += -0.125 * q;
    }
    for (const Vec3 q : m) {
        c += 0.25 * q;
    }
    double least = 1;
    const auto take = [&](Vec3 o, Vec3 x, Vec3 y, Vec3 z) {
        least = std::min(least, scaled(x - o, y - o, z - o));
        return least > floor;
    };
    for (std::size_t v = 0; v < 4; ++v) {
        const auto [i, j, k] = tet_others[v];
        const Vec3 vi = m[tet_edge_of[v][i]];
        const Vec3 vj = m[tet_edge_of[v][j]];
        const Vec3 vk = m[tet_edge_of[v][k]];
        if (!take(p[v], vi, vj, vk) || !take(vi, f[k], p[v], f[j]) || !take(vj, p[v], f[k], f[i]) ||
            !take(vk, f[i], f[j], p[v]) || !take(f[k], vj, vi, c) || !take(f[j], vi, vk, c) ||
            !take(f[i], vk, vj, c) || !take(c, f[j], f[i], f[k])) {
            return least;
        }
    }
    return least;
}

} // namespace nmgs
