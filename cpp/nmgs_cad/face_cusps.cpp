// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_cusps.h"

#include "nmgs/support/vec3.h"

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {

// The place at a length along the edge from one of its ends.
Vec3 place(const EdgeSize &size, bool from_start, double length) {
    const auto pieces = static_cast<double>(size.at.size() - 1);
    const double f = std::clamp(length / size.length, 0.0, 1.0);
    const double x = (from_start ? f : 1 - f) * pieces;
    const auto i = std::min(static_cast<std::size_t>(x), size.at.size() - 2);
    const double t = x - static_cast<double>(i);
    return (1 - t) * size.at[i] + t * size.at[i + 1];
}

// The length at which a quad fits into the corner between two uses; 0 where it is no cusp.
double tip_length(const EdgeUse &before, const EdgeUse &use, const EdgeSizes &sizes) {
    constexpr double sharpest = 0.3; // radians; more is no cusp
    constexpr double wanted = 0.36;  // of the chords
    constexpr double least = 0.02;   // share of the shorter edge
    constexpr double most = 0.45;
    constexpr double step = 1.1;
    if (before.degenerated || use.degenerated || use.angle > sharpest) {
        return 0;
    }
    const EdgeSize &one = sizes.at(before.edge);
    const EdgeSize &two = sizes.at(use.edge);
    const double shorter = std::min(one.length, two.length);
    double best = 0;
    double widest = 0;
    double narrowest = wanted;
    for (double s = least * shorter; s <= most * shorter; s *= step) {
        const Vec3 a = place(one, !before.forward, s) - use.start;
        const Vec3 b = place(two, use.forward, s) - use.start;
        const double angle = angle_between(a, b);
        narrowest = std::min(narrowest, angle);
        if (angle > widest) {
            widest = angle;
            best = s;
        }
        if (angle > wanted) {
            break;
        }
    }
    return widest > 1.5 * narrowest ? best : 0;
}

} // namespace

bool size_cusps(const FaceLoops &loops, EdgeSizes &sizes) {
    bool any = false;
    for (const FaceLoop &loop : loops.loops) {
        for (std::size_t u = 0; u < loop.size(); ++u) {
            const EdgeUse &use = loop[u];
            const EdgeUse &before = loop[(u + loop.size() - 1) % loop.size()];
            const double length = tip_length(before, use, sizes);
            if (!(length > 0)) {
                continue;
            }
            any = true;
            const auto set = [&](int edge, bool at_start) {
                double &tip = sizes.at(edge).tip[at_start ? 0 : 1];
                tip = tip > 0 ? std::min(tip, length) : length;
            };
            set(before.edge, !before.forward);
            set(use.edge, use.forward);
        }
    }
    return any;
}

void size_as_elements(const FaceLoops &loops, EdgeSizes &sizes, double longest) {
    constexpr double turn = 0.3; // along a segment, in radians
    for (const FaceLoop &loop : loops.loops) {
        for (const EdgeUse &use : loop) {
            if (use.degenerated) {
                continue;
            }
            EdgeSize &size = sizes.at(use.edge);
            const double most =
                std::min(longest, size.turn > turn ? size.length * turn / size.turn : longest);
            for (double &wanted : size.wanted) {
                wanted = std::min(wanted, most);
            }
        }
    }
}

} // namespace nmgs::cad
