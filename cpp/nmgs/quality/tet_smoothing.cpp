// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/tet_improver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmgs {

// Moves a point to where the worst tetrahedron round it is best: along that one's gradient, else
// along the axes.
bool TetImprover::smooth(std::int32_t point, int steps) {
    if (mesh_.fixed[at(point)] != 0 || of_[at(point)].empty()) {
        return false;
    }
    auto list = of_[at(point)];
    const auto worse = [&](std::int32_t a, std::int32_t b) {
        return quality_[at(a)] < quality_[at(b)];
    };
    std::sort(list.begin(), list.end(), worse);
    Vec3 here = mesh_.points[at(point)];
    double worth = quality_[at(list[0])];
    double reach = 0;
    Vec3 middle{0, 0, 0};
    for (const std::int32_t t : list) {
        for (const std::int32_t n : mesh_.tets[at(t)].p) {
            reach = std::max(reach, distance(mesh_.points[at(n)], here));
            middle += (1.0 / 3) * mesh_.points[at(n)];
        }
        middle += (-1.0 / 3) * here;
    }
    middle = (1 / static_cast<double>(list.size())) * middle;
    const double start = worth;
    std::size_t worst = 0;
    const auto attempt = [&](Vec3 place) {
        double least = 1;
        std::size_t lowest = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const double q = quality_at(mesh_.tets[at(list[i])].p, point, place, worth);
            if (q <= worth) {
                std::swap(list[i], list[i / 2]); // it will fail early the next time
                worst = 0;
                return false;
            }
            if (q < least) {
                least = q;
                lowest = i;
            }
        }
        worth = least;
        here = place;
        worst = lowest;
        return true;
    };
    attempt(middle);
    double step = 0.1 * reach;
    for (int k = 0; k < steps && worth < options_.good + 0.1; ++k) {
        const auto &p = mesh_.tets[at(list[worst])].p;
        const double h = 1e-5 * reach;
        const double q = quality_at(p, point, here, -2);
        Vec3 slope{quality_at(p, point, here + Vec3{h, 0, 0}, -2) - q,
                   quality_at(p, point, here + Vec3{0, h, 0}, -2) - q,
                   quality_at(p, point, here + Vec3{0, 0, h}, -2) - q};
        slope = unit(slope);
        bool better = attempt(here + step * slope);
        for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0},
                             Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
            if (better) {
                break;
            }
            better = attempt(here + step * d);
        }
        step *= better ? 1.2 : 0.4;
        if (step < 1e-3 * reach) {
            break;
        }
    }
    if (worth <= start) {
        return false;
    }
    mesh_.points[at(point)] = here;
    for (const std::int32_t t : list) {
        quality_[at(t)] = quality(mesh_.tets[at(t)].p);
    }
    return true;
}

} // namespace nmgs
