// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/inner_edges.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GCPnts_UniformAbscissa.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <set>

namespace nmgs::cad {
namespace {

double turn_of(const BRepAdaptor_Curve &curve) {
    constexpr int samples = 32;
    double turn = 0;
    Vec3 last{0, 0, 0};
    for (int i = 0; i <= samples; ++i) {
        const double f = static_cast<double>(i) / samples;
        gp_Pnt p;
        gp_Vec d;
        curve.D1((1 - f) * curve.FirstParameter() + f * curve.LastParameter(), p, d);
        const Vec3 now = vec(d.XYZ());
        if (norm(last) > 0 && norm(now) > 0) {
            turn += angle_between(last, now);
        }
        last = now;
    }
    return turn;
}

} // namespace

std::vector<int> inner_edges(const CadShape &shape, int solid) {
    std::set<int> of_faces;
    for (TopExp_Explorer f(shape.solid(solid), TopAbs_FACE); f.More(); f.Next()) {
        for (TopExp_Explorer e(f.Current(), TopAbs_EDGE); e.More(); e.Next()) {
            of_faces.insert(shape.edges.FindIndex(e.Current()));
        }
    }
    std::set<int> result;
    for (TopExp_Explorer e(shape.solid(solid), TopAbs_EDGE, TopAbs_FACE); e.More(); e.Next()) {
        const int n = shape.edges.FindIndex(e.Current());
        if (!of_faces.contains(n) && !BRep_Tool::Degenerated(TopoDS::Edge(e.Current()))) {
            result.insert(n);
        }
    }
    return {result.begin(), result.end()};
}

void add_inner_edges(const CadShape &shape, std::span<const int> faces, double size, double angle,
                     Skin &skin) {
    const auto add = [&](Vec3 p, CadEntity on) {
        skin.points.push_back(p);
        skin.on.push_back(on);
        skin.source.push_back(-1);
        return static_cast<std::int32_t>(skin.points.size()) - 1;
    };
    const auto vertex = [&](const TopoDS_Vertex &v) {
        const int n = shape.vertices.FindIndex(v);
        for (std::size_t k = 0; k < skin.on.size(); ++k) {
            if (skin.on[k].dimension == 0 && skin.on[k].index == n) {
                return static_cast<std::int32_t>(k);
            }
        }
        return add(shape.point(n), {0, n});
    };
    for (int s = 1; s <= shape.solids.Extent(); ++s) {
        bool whole = true;
        for (TopExp_Explorer f(shape.solid(s), TopAbs_FACE); f.More() && whole; f.Next()) {
            const int n = shape.faces.FindIndex(f.Current());
            whole = std::find(faces.begin(), faces.end(), n) != faces.end();
        }
        for (const int e : whole ? inner_edges(shape, s) : std::vector<int>()) {
            if (!skin.edges[at(e)].empty()) {
                continue;
            }
            const TopoDS_Edge edge = shape.edge(e);
            const BRepAdaptor_Curve curve(edge);
            const TopoDS_Vertex first = TopExp::FirstVertex(edge);
            const TopoDS_Vertex last = TopExp::LastVertex(edge);
            const double length = GCPnts_AbscissaPoint::Length(curve);
            const int count = std::max({first.IsSame(last) ? 3 : 1,
                                        static_cast<int>(std::ceil(length / size - 1e-9)),
                                        static_cast<int>(std::ceil(turn_of(curve) / angle))});
            const GCPnts_UniformAbscissa parts(curve, count + 1);
            auto &points = skin.edges[at(e)];
            auto &parameters = skin.parameters[at(e)];
            points.push_back(vertex(first));
            parameters.push_back(curve.FirstParameter());
            for (int k = 1; k < count; ++k) {
                const double f = static_cast<double>(k) / count;
                const double t = parts.IsDone()
                                     ? parts.Parameter(k + 1)
                                     : (1 - f) * curve.FirstParameter() + f * curve.LastParameter();
                points.push_back(add(vec(curve.Value(t).XYZ()), {1, e}));
                parameters.push_back(t);
            }
            points.push_back(vertex(last));
            parameters.push_back(curve.LastParameter());
        }
    }
}

} // namespace nmgs::cad
