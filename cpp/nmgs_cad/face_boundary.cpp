// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_boundary.h"

#include "nmgs/support/vec3.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {

// The parameter in [from, to] at which the curve is nearest to p: sampling, then golden section.
double parameter_of(const BRepAdaptor_Curve &curve, Vec3 p, double from, double to) {
    constexpr int samples = 64;
    const auto d2 = [&](double t) { return norm2(vec(curve.Value(t).XYZ()) - p); };
    int best = 0;
    double nearest = d2(from);
    for (int i = 1; i <= samples; ++i) {
        const double d = d2(from + (to - from) * i / samples);
        // Both ends of a closed curve are equally near to a point beside them.
        if (d < nearest * (1 - 1e-6)) {
            nearest = d;
            best = i;
        }
    }
    double a = from + (to - from) * std::max(0, best - 1) / samples;
    double b = from + (to - from) * std::min(samples, best + 1) / samples;
    // Newton's method on the foot of the perpendicular; where it leads out, golden section.
    double x = from + (to - from) * best / samples;
    const double near = 1e-14 * std::max(std::abs(a), std::abs(b));
    for (int i = 0; i < 12 && x >= a && x <= b; ++i) {
        gp_Pnt at;
        gp_Vec d1;
        gp_Vec dd;
        curve.D2(x, at, d1, dd);
        const Vec3 off = vec(at.XYZ()) - p;
        const double slope = norm2(vec(d1.XYZ()));
        const double bend = slope + dot(off, vec(dd.XYZ()));
        if (!(bend > 1e-3 * slope)) {
            break;
        }
        const double move = -dot(off, vec(d1.XYZ())) / bend;
        x += move;
        if (std::abs(move) <= near + 1e-12 * (b - a)) {
            return std::clamp(x, a, b);
        }
    }
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < 60; ++i) {
        const double s = b - golden * (b - a);
        const double t = a + golden * (b - a);
        (d2(s) < d2(t) ? b : a) = d2(s) < d2(t) ? t : s;
    }
    return 0.5 * (a + b);
}

Vec3 tangent(const BRepAdaptor_Curve &curve, double t, bool forward) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(t, p, d);
    if (d.Magnitude() < 1e-12) {
        const double span = 1e-4 * (curve.LastParameter() - curve.FirstParameter());
        const double s = std::clamp(t, curve.FirstParameter() + span, curve.LastParameter() - span);
        curve.D1(s, p, d);
    }
    return (forward ? 1.0 : -1.0) * unit(vec(d.XYZ()));
}

} // namespace

BoundaryLoop nodes_along(const CadShape &shape, const EdgeUse &use, const Layout &layout) {
    BoundaryLoop nodes;
    BoundaryNode start;
    start.uv = use.begin();
    start.vertex = true;
    start.angle = use.angle;
    start.at = use.start;
    if (use.degenerated) {
        start.pole = true;
        nodes.push_back(start);
        return nodes;
    }
    const auto &points = layout.edges[static_cast<std::size_t>(use.edge)];
    const BRepAdaptor_Curve curve(shape.edge(use.edge));
    const double first = curve.FirstParameter();
    const double last = curve.LastParameter();
    std::vector<double> at{first};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        at.push_back(parameter_of(curve, layout.points[static_cast<std::size_t>(points[i])],
                                  at.back(), last));
    }
    at.push_back(last);
    const std::size_t segments = points.size() - 1;
    for (std::size_t k = 0; k < segments; ++k) {
        const std::size_t i = use.forward ? k : segments - k;
        BoundaryNode node = k == 0 ? start : BoundaryNode{};
        node.point = points[i];
        node.at = layout.points[static_cast<std::size_t>(points[i])];
        if (k > 0) {
            // The curve in the parameters runs over the same range as the edge's own.
            const double share = (at[i] - first) / (last - first);
            node.uv = use.at(use.first + share * (use.last - use.first));
            node.in = tangent(curve, at[i], use.forward);
        }
        node.out = tangent(curve, at[i], use.forward);
        const std::size_t next = use.forward ? i + 1 : i - 1;
        const double half = 0.5 * (at[i] + at[next]);
        node.middle = vec(curve.Value(half).XYZ());
        node.uv_middle =
            use.at(use.first + (half - first) / (last - first) * (use.last - use.first));
        nodes.push_back(node);
    }
    return nodes;
}

std::vector<BoundaryLoop> boundary_of(const CadShape &shape, const FaceLoops &loops,
                                      const Layout &layout) {
    std::vector<BoundaryLoop> result;
    for (const FaceLoop &loop : loops.loops) {
        BoundaryLoop nodes;
        std::vector<std::size_t> starts;
        for (std::size_t u = 0; u < loop.size(); ++u) {
            starts.push_back(nodes.size());
            for (BoundaryNode &node : nodes_along(shape, loop[u], layout)) {
                node.use = u;
                nodes.push_back(node);
            }
        }
        for (std::size_t u = 0; u < loop.size(); ++u) {
            BoundaryNode &node = nodes[starts[u]];
            if (node.point < 0) {
                // A pole has the number of its vertex, which the edges at it have, too.
                const EdgeUse &before = loop[(u + loop.size() - 1) % loop.size()];
                const auto &points = layout.edges[static_cast<std::size_t>(before.edge)];
                const std::size_t next = starts[(u + 1) % loop.size()];
                node.point = !points.empty() ? (before.forward ? points.back() : points.front())
                                             : nodes[next].point;
            }
            const EdgeUse &before = loop[(u + loop.size() - 1) % loop.size()];
            if (!before.degenerated) {
                const BRepAdaptor_Curve curve(shape.edge(before.edge));
                node.in =
                    tangent(curve, before.forward ? curve.LastParameter() : curve.FirstParameter(),
                            before.forward);
            }
        }
        result.push_back(std::move(nodes));
    }
    return result;
}

} // namespace nmgs::cad
