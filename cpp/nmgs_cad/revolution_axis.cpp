// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/revolution_axis.h"

#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nmgs::cad {
namespace {

constexpr double angular = 1e-4;

struct Axes {
    double tolerance;
    std::vector<gp_Ax1> list;

    void add(const gp_Ax1 &axis) {
        for (const gp_Ax1 &known : list) {
            const gp_Vec between(known.Location(), axis.Location());
            if (known.Direction().IsParallel(axis.Direction(), 1e-6) &&
                between.Crossed(gp_Vec(known.Direction())).Magnitude() < tolerance) {
                return;
            }
        }
        list.push_back(axis);
    }
    void add(const TopoDS_Face &face) {
        const BRepAdaptor_Surface surface(face, Standard_False);
        switch (surface.GetType()) {
        case GeomAbs_Cylinder:
            return add(surface.Cylinder().Axis());
        case GeomAbs_Cone:
            return add(surface.Cone().Axis());
        case GeomAbs_Sphere:
            return add(surface.Sphere().Position().Axis());
        case GeomAbs_Torus:
            return add(surface.Torus().Axis());
        case GeomAbs_SurfaceOfRevolution:
            return add(surface.AxeOfRevolution());
        default:
            return;
        }
    }
    // The axis of the circle through three points of the edge: an edge of unknown kind may be one.
    void add(const TopoDS_Edge &edge) {
        const BRepAdaptor_Curve curve(edge);
        if (curve.GetType() == GeomAbs_Line) {
            return;
        }
        const double a = curve.FirstParameter();
        const double b = curve.LastParameter();
        const Vec3 p = vec(curve.Value(a).XYZ());
        const Vec3 u = vec(curve.Value(a + (b - a) / 3).XYZ()) - p;
        const Vec3 v = vec(curve.Value(a + (b - a) * 2 / 3).XYZ()) - p;
        const Vec3 n = cross(u, v);
        if (norm2(n) < 1e-12 * norm2(u) * norm2(v)) {
            return;
        }
        const Vec3 c = p + (1 / (2 * norm2(n))) * (norm2(u) * cross(v, n) + norm2(v) * cross(n, u));
        add(gp_Ax1(gp_Pnt(c.x, c.y, c.z), gp_Dir(n.x, n.y, n.z)));
    }
};

bool turns(const TopoDS_Shape &solid, const gp_Ax1 &axis, double tolerance) {
    const Vec3 origin = vec(axis.Location().XYZ());
    const Vec3 direction = vec(axis.Direction().XYZ());
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
        for (const auto &[point, normal] : sample_normals(TopoDS::Face(it.Current()))) {
            const Vec3 round = cross(direction, point - origin);
            const double r = norm(round);
            if (r > tolerance && std::abs(dot(normal, round)) > angular * r) {
                return false;
            }
        }
    }
    return true;
}

double angle_at(const gp_Ax2 &frame, Vec3 p) {
    const Vec3 q = p - vec(frame.Location().XYZ());
    const double a =
        std::atan2(dot(q, vec(frame.YDirection().XYZ())), dot(q, vec(frame.XDirection().XYZ())));
    return a < 0 ? a + 2 * std::numbers::pi : a;
}

} // namespace

std::optional<RevolutionAxis> revolution_axis(const CadShape &shape, int solid, Refusal &refusal) {
    const TopoDS_Solid body = shape.solid(solid);
    const double tolerance = 1e-5 * extent_of(body);
    Axes axes{tolerance, {}};
    std::vector<gp_Pnt> poles;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(body, TopAbs_EDGE, edges);
    for (int e = 1; e <= edges.Extent(); ++e) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(e));
        if (!BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const gp_Pnt p = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
        for (const gp_Pnt &q : poles) {
            if (p.Distance(q) > tolerance) {
                axes.add(gp_Ax1(p, gp_Dir(gp_Vec(p, q))));
            }
        }
        poles.push_back(p);
    }
    for (TopExp_Explorer it(body, TopAbs_FACE); it.More(); it.Next()) {
        axes.add(TopoDS::Face(it.Current()));
    }
    for (int e = 1; e <= edges.Extent(); ++e) {
        if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(e)))) {
            axes.add(TopoDS::Edge(edges(e)));
        }
    }
    refusal = {"no axis about which all its faces turn", {entity_name(3, solid)}};
    for (const gp_Ax1 &axis : axes.list) {
        if (!turns(body, axis, tolerance)) {
            continue;
        }
        RevolutionAxis result;
        result.frame = gp_Ax2(axis.Location(), axis.Direction());
        const Vec3 origin = vec(axis.Location().XYZ());
        const Vec3 direction = vec(axis.Direction().XYZ());
        const auto radius = [&](Vec3 p) { return norm(cross(direction, p - origin)); };
        bool first = true;
        bool good = true;
        std::vector<double> angles;
        const auto note = [&](Vec3 p) {
            if (radius(p) < 2 * tolerance) {
                result.poles = true;
                return;
            }
            if (first) { // angles from the first vertex
                const Vec3 q = p - origin;
                result.frame = gp_Ax2(axis.Location(), axis.Direction(), gp_Dir(q.x, q.y, q.z));
                first = false;
            }
            angles.push_back(angle_at(result.frame, p));
        };
        for (int e = 1; e <= edges.Extent() && good; ++e) {
            const TopoDS_Edge edge = TopoDS::Edge(edges(e));
            if (BRep_Tool::Degenerated(edge)) {
                result.poles = true;
                continue;
            }
            const BRepAdaptor_Curve curve(edge);
            const double a = curve.FirstParameter();
            const double b = curve.LastParameter();
            const Vec3 start = vec(curve.Value(a).XYZ());
            const Vec3 end = vec(curve.Value(b).XYZ());
            note(start);
            note(end);
            bool round = true;
            bool along = true;
            Vec3 plane{};
            for (int i = 1; i < 6; ++i) {
                const Vec3 p = vec(curve.Value(a + (b - a) * i / 6).XYZ());
                round = round && std::abs(radius(p) - radius(start)) < 3 * tolerance &&
                        std::abs(dot(p - start, direction)) < 3 * tolerance;
                const Vec3 n = cross(direction, p - origin);
                if (norm(n) > 10 * tolerance) {
                    plane = norm(plane) == 0 ? (1 / norm(n)) * n : plane;
                    // The same side of the axis, and in the plane.
                    along = along && dot(plane, n) > 0 && norm(cross(plane, n)) < 3 * tolerance;
                    if (i == 3) {
                        if (along && !round) {
                            note(p);
                        }
                    }
                }
            }
            if (!round && !along) {
                const int n = shape.edges.FindIndex(edge);
                refusal = {entity_name(1, n) + " runs neither round the axis nor along it",
                           {entity_name(1, n)}};
                good = false;
            }
        }
        if (!good) {
            continue;
        }
        std::sort(angles.begin(), angles.end());
        for (const double t : angles) {
            if (t < 2 * std::numbers::pi - 1e-5 &&
                (result.angles.empty() || t - result.angles.back() > 1e-5)) {
                result.angles.push_back(t);
            }
        }
        if (result.angles.empty()) {
            result.angles.push_back(0);
        }
        return result;
    }
    return std::nullopt;
}

} // namespace nmgs::cad
