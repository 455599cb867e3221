// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/edge_sizes.h"

#include "nmgs/support/vec3.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopExp.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nmgs::cad {
namespace {

constexpr int steps = 24; // of an edge's length

// A place on the boundary of a face.
struct Sample {
    Vec3 at;
    int edge;
    std::size_t step;
    std::size_t loop;
    double along; // of the loop's length
    double size;
    std::array<int, 2> vertex; // at the start and the end of the edge
    std::array<double, 2> to;  // way to them along it
    bool tip;                  // beside a cusp, on a segment of a given length
};

// The way from one to the other along their edges when these meet at a vertex: a seam's two sides
// and the ends of a closed edge are neighbours though they are far apart along the loop.
double way(const Sample &s, const Sample &t) {
    double least = std::numeric_limits<double>::infinity();
    if (s.edge == t.edge) {
        least = std::abs(s.to[0] - t.to[0]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            if (s.vertex[i] == t.vertex[j]) {
                least = std::min(least, s.to[i] + t.to[j]);
            }
        }
    }
    return least;
}

} // namespace

namespace {

// Shares of the edge's length, ascending, and how many segments there are up to each.
struct Count {
    std::vector<double> at, sum;
};

Count count_between(const EdgeSize &size, double from, double to) {
    const auto pieces = static_cast<double>(size.wanted.size() - 1);
    const auto density = [&](double f) {
        const double x = std::clamp(f * pieces, 0.0, pieces);
        const auto i = std::min(static_cast<std::size_t>(x), size.wanted.size() - 2);
        const double t = x - static_cast<double>(i);
        return (1 - t) / size.wanted[i] + t / size.wanted[i + 1];
    };
    Count count{{from}, {0}};
    for (std::size_t i = 0; i < size.wanted.size(); ++i) {
        const double f = std::min(static_cast<double>(i) / pieces, to);
        if (f > count.at.back()) {
            count.sum.push_back(count.sum.back() + 0.5 * size.length * (f - count.at.back()) *
                                                       (density(count.at.back()) + density(f)));
            count.at.push_back(f);
        }
    }
    return count;
}

} // namespace

double EdgeSize::segments() const {
    return tips() + count_between(*this, tip[0] / length, 1 - tip[1] / length).sum.back();
}

std::vector<double> EdgeSize::fractions(int n) const {
    const bool no_tips = n <= tips();
    const double from = no_tips ? 0 : tip[0] / length;
    const double to = no_tips ? 1 : 1 - tip[1] / length;
    const int inner = no_tips ? n : n - tips();
    const Count count = count_between(*this, from, to);
    std::vector<double> result;
    if (from > 0) {
        result.push_back(from);
    }
    std::size_t i = 0;
    for (int k = 1; k < inner; ++k) {
        const double goal = count.sum.back() * k / inner;
        while (i + 2 < count.sum.size() && count.sum[i + 1] < goal) {
            ++i;
        }
        const double t = (goal - count.sum[i]) / (count.sum[i + 1] - count.sum[i]);
        result.push_back(count.at[i] + t * (count.at[i + 1] - count.at[i]));
    }
    if (to < 1) {
        result.push_back(to);
    }
    return result;
}

EdgeSize size_of_edge(const CadShape &shape, int edge, const LayoutOptions &options) {
    EdgeSize size;
    const BRepAdaptor_Curve curve(shape.edge(edge));
    const EdgeCurve by_length(shape.edge(edge));
    size.length = by_length.length();
    size.vertex = {shape.vertices.FindIndex(TopExp::FirstVertex(shape.edge(edge))),
                   shape.vertices.FindIndex(TopExp::LastVertex(shape.edge(edge)))};
    size.closed = size.vertex[0] == size.vertex[1];
    constexpr int samples = 48;
    Vec3 last{};
    for (int i = 0; i <= samples; ++i) {
        gp_Pnt p;
        gp_Vec d;
        const double t = static_cast<double>(i) / samples;
        curve.D1(curve.FirstParameter() + t * (curve.LastParameter() - curve.FirstParameter()), p,
                 d);
        const Vec3 tangent = vec(d.XYZ());
        if (i > 0 && norm2(last) > 0 && norm2(tangent) > 0) {
            size.turn += angle_between(last, tangent);
        }
        last = norm2(tangent) > 0 ? tangent : last;
    }
    double count = std::max(1.0, std::ceil(size.turn / options.angle - 0.05));
    if (size.closed) {
        count = std::max(count, 4.0);
    }
    double wanted = std::max(size.length, 1e-12) / count;
    if (options.size > 0) {
        wanted = std::min(wanted, options.size);
    }
    const double speed = curve.GetType() == GeomAbs_Line ? 1 : 0;
    for (int i = 0; i <= steps; ++i) {
        const double f = static_cast<double>(i) / steps;
        // On a line the points need no search for their length.
        size.at.push_back(speed > 0
                              ? vec(curve
                                        .Value(curve.FirstParameter() +
                                               f * (curve.LastParameter() - curve.FirstParameter()))
                                        .XYZ())
                              : by_length.at(f));
        size.wanted.push_back(wanted);
    }
    return size;
}

void size_by_neighbourhood(const FaceLoops &loops, EdgeSizes &sizes) {
    std::vector<Sample> samples;
    std::vector<double> length;
    double all = 0;
    std::size_t uses = 0;
    for (const FaceLoop &loop : loops.loops) {
        uses += loop.size();
    }
    // Faces with very many edges are sampled more coarsely: the work grows with the square.
    const std::size_t stride = uses > 100 ? 12 : uses > 40 ? 4 : 1;
    for (std::size_t l = 0; l < loops.loops.size(); ++l) {
        double along = 0;
        for (const EdgeUse &use : loops.loops[l]) {
            if (use.degenerated) {
                continue;
            }
            const EdgeSize &size = sizes.at(use.edge);
            for (std::size_t k = 0; k < size.at.size(); k += stride) {
                const std::size_t i = use.forward ? k : size.at.size() - 1 - k;
                const double f = static_cast<double>(k) / static_cast<double>(size.at.size() - 1);
                const double from =
                    static_cast<double>(i) / static_cast<double>(size.at.size() - 1);
                const std::array<double, 2> to{from * size.length, (1 - from) * size.length};
                samples.push_back({size.at[i], use.edge, i, l, along + f * size.length,
                                   size.wanted[i], size.vertex, to,
                                   to[0] < size.tip[0] || to[1] < size.tip[1]});
            }
            along += size.length;
        }
        length.push_back(along);
        all += along;
    }
    // Beyond the quad in a cusp the face is as narrow as that is.
    const bool cusps =
        std::any_of(samples.begin(), samples.end(), [](const Sample &s) { return s.tip; });
    const double least = all / (cusps ? 8000 : 500);
    // Another part of the boundary is one that is much farther along the boundary than across. Two
    // quads fit between.
    constexpr double detour = 4;
    constexpr double share = 0.6;
    for (Sample &s : samples) {
        if (s.tip) {
            continue;
        }
        for (const Sample &t : samples) {
            const double d = distance(s.at, t.at);
            if (share * d >= s.size || d <= 1e-9 * all) {
                continue;
            }
            double along = std::numeric_limits<double>::infinity();
            if (s.loop == t.loop) {
                along = std::abs(s.along - t.along);
                along = std::min(along, length[s.loop] - along);
            }
            if (std::min(along, way(s, t)) > detour * d) {
                s.size = std::min(s.size, std::max(share * d, least));
            }
        }
    }
    constexpr double growth = 0.6;
    std::vector<double> sizes_before;
    sizes_before.reserve(samples.size());
    for (const Sample &s : samples) {
        sizes_before.push_back(s.size);
    }
    for (Sample &s : samples) {
        for (std::size_t i = 0; i < samples.size() && !s.tip; ++i) {
            if (sizes_before[i] < s.size && !samples[i].tip) {
                s.size = std::min(s.size, sizes_before[i] + growth * distance(s.at, samples[i].at));
            }
        }
        EdgeSize &size = sizes.at(s.edge);
        for (std::size_t i = s.step >= stride ? s.step - stride + 1 : 0;
             i < std::min(size.wanted.size(), s.step + stride); ++i) {
            size.wanted[i] = std::min(size.wanted[i], s.size);
        }
    }
}

} // namespace nmgs::cad
