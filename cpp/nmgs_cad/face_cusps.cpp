// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_cusps.h"

#include "nmgs/support/vec3.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {

// The place at a length along the edge from one of its ends.
Vec3 place(const EdgeSize &size, bool from_start, double length) {
    const auto pieces = static_cast<double>(size.at.size() - 1);
    const double f = std::clamp(length / size.length, 0.0, 1.0);
    const double x = (from_start ? f : 1 - f) * pieces;
    // The quadratic through three of the places: a chord's error would be an angle of its own.
    const auto i =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(x)), 1, size.at.size() - 2);
    const double t = x - static_cast<double>(i);
    return 0.5 * t * (t - 1) * size.at[i - 1] + (1 - t * t) * size.at[i] +
           0.5 * t * (t + 1) * size.at[i + 1];
}

constexpr double sharpest = 0.3; // radians; more is no cusp

bool sharp(const EdgeUse &before, const EdgeUse &use) {
    return !before.degenerated && !use.degenerated && use.angle <= sharpest;
}

// The length at which a quad fits into the corner at the start of use u; 0 where it is no cusp.
double tip_length(const CadShape &shape, int face, const FaceLoop &loop, std::size_t u,
                  const EdgeSizes &sizes) {
    constexpr double wanted = 0.3; // radians, of the chords
    constexpr double least = 0.02;   // share of the shorter edge
    constexpr double step = 1.01;
    const std::size_t n = loop.size();
    const EdgeUse &before = loop[(u + n - 1) % n];
    const EdgeUse &use = loop[u];
    if (!sharp(before, use)) {
        return 0;
    }
    constexpr double most_of_edge = 0.45;
    const EdgeSize &one = sizes.at(before.edge);
    const EdgeSize &two = sizes.at(use.edge);
    const double shorter = std::min(one.length, two.length);
    const double most = most_of_edge * shorter;
    const auto angle = [&](double s) {
        return angle_between(place(one, !before.forward, s) - use.start,
                             place(two, use.forward, s) - use.start);
    };
    double best = 0;
    double widest = 0;
    double narrowest = wanted;
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape.face(face), properties);
    const double area = std::abs(properties.Mass());
    for (double s = least * shorter; s <= most && widest < wanted; s *= step) {
        const double a = angle(s);
        // Between a tangent and an arc the chord is off by the area of a segment of the circle.
        constexpr double share = 0.006;
        if (s * s * a / 6 > share * area) {
            break;
        }
        narrowest = std::min(narrowest, a);
        if (a > widest) {
            widest = a;
            best = s;
        }
    }
    return widest > 1.5 * narrowest ? best : 0;
}

} // namespace

bool size_cusps(const CadShape &shape, int face, const FaceLoops &loops, EdgeSizes &sizes) {
    bool any = false;
    for (const FaceLoop &loop : loops.loops) {
        for (std::size_t u = 0; u < loop.size(); ++u) {
            const EdgeUse &use = loop[u];
            const EdgeUse &before = loop[(u + loop.size() - 1) % loop.size()];
            const double length = tip_length(shape, face, loop, u, sizes);
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
    constexpr double turn = 0.18; // along a segment, in radians
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
