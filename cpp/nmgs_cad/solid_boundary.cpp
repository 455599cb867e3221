// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/solid_boundary.h"

#include "nmgs/support/vec3.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace nmgs::cad {
namespace {

// The oriented edge of each coedge, and the oriented face of each face.
struct Geometry {
    std::vector<TopoDS_Edge> edges;
    std::vector<TopoDS_Face> faces;
    std::vector<BRepAdaptor_Surface> surfaces;

    // Outward normal of the face beside the coedge, at a fraction of the parameter range of the
    // curve.
    [[nodiscard]] Vec3 normal(std::size_t coedge, std::size_t face, double fraction) const {
        double first = 0;
        double last = 0;
        const Handle(Geom2d_Curve) curve =
            BRep_Tool::CurveOnSurface(edges[coedge], faces[face], first, last);
        if (curve.IsNull()) {
            return {0, 0, 0};
        }
        const BRepAdaptor_Surface &surface = surfaces[face];
        gp_Pnt2d uv = curve->Value(first + fraction * (last - first));
        const gp_Pnt2d inside(0.5 * (surface.FirstUParameter() + surface.LastUParameter()),
                              0.5 * (surface.FirstVParameter() + surface.LastVParameter()));
        for (int tries = 0; tries < 4; ++tries) {
            gp_Pnt p;
            gp_Vec du;
            gp_Vec dv;
            surface.D1(uv.X(), uv.Y(), p, du, dv);
            const gp_Vec n = du.Crossed(dv);
            if (n.Magnitude() > 1e-9 * (du.SquareMagnitude() + dv.SquareMagnitude()) &&
                n.Magnitude() > 0) {
                const Vec3 out = unit(vec(n));
                return faces[face].Orientation() == TopAbs_REVERSED ? -1.0 * out : out;
            }
            // At a pole of the surface: the normal a little farther inside stands for it.
            uv.SetXY(0.99 * uv.XY() + 0.01 * inside.XY());
        }
        return {0, 0, 0};
    }
    // Unit tangent along the coedge at its start (0), middle (0.5) or end (1).
    [[nodiscard]] Vec3 tangent(std::size_t coedge, double along) const {
        const TopoDS_Edge &edge = edges[coedge];
        const bool forward = edge.Orientation() == TopAbs_FORWARD;
        double first = 0;
        double last = 0;
        BRep_Tool::Range(edge, first, last);
        const double at = forward ? along : 1 - along;
        const Vec3 t = tangent_at(edge, first + at * (last - first));
        return forward ? t : -1.0 * t;
    }
};

double signed_angle(Vec3 a, Vec3 b, Vec3 about) {
    return std::atan2(dot(about, cross(a, b)), dot(a, b));
}

// The edges of a wire in order. The explorer stops at gaps: then in the order of the file.
std::vector<TopoDS_Edge> ordered(const TopoDS_Wire &wire, const TopoDS_Face &face) {
    std::vector<TopoDS_Edge> edges;
    std::vector<TopoDS_Edge> listed;
    for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next()) {
        edges.push_back(it.Current());
    }
    for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
        listed.push_back(TopoDS::Edge(it.Value()));
    }
    return edges.size() == listed.size() ? edges : listed;
}

} // namespace

std::vector<std::pair<int, bool>> solid_faces(const CadShape &shape, int solid) {
    std::map<int, bool> faces;
    for (TopExp_Explorer f(shape.solid(solid), TopAbs_FACE); f.More(); f.Next()) {
        const auto orientation = f.Current().Orientation();
        const bool bounds = orientation == TopAbs_FORWARD || orientation == TopAbs_REVERSED;
        const auto [known, fresh] = faces.try_emplace(shape.faces.FindIndex(f.Current()), bounds);
        if (!fresh) {
            known->second = false;
        }
    }
    return {faces.begin(), faces.end()};
}

Vec3 tangent_at(const TopoDS_Edge &edge, double parameter) {
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter();
    const double last = curve.LastParameter();
    gp_Pnt p;
    gp_Vec t;
    curve.D1(parameter, p, t);
    if (t.Magnitude() <= 1e-12 * p.Distance(curve.Value(0.5 * (first + last)))) {
        // A stationary point of the parametrisation: the chord next to it.
        const double step = 1e-3 * (last - first);
        t = gp_Vec(curve.Value(std::max(first, parameter - step)),
                   curve.Value(std::min(last, parameter + step)));
    }
    return unit(vec(t));
}

double turning(const TopoDS_Edge &edge) {
    double first = 0;
    double last = 0;
    BRep_Tool::Range(edge, first, last);
    constexpr int steps = 16;
    double sum = 0;
    Vec3 before = tangent_at(edge, first);
    for (int i = 1; i <= steps; ++i) {
        const Vec3 t = tangent_at(edge, first + (last - first) * i / steps);
        sum += std::atan2(norm(cross(before, t)), dot(before, t));
        before = t;
    }
    return sum;
}

std::optional<SolidBoundary> boundary_of(const CadShape &shape, int solid, Refusal &refusal) {
    SolidBoundary result;
    result.solid = solid;
    Geometry geometry;
    const auto names = [&](int dimension, int n) {
        return std::vector<std::string>{entity_name(dimension, n)};
    };
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        const int number = shape.faces.FindIndex(face);
        const bool known =
            std::find(result.faces.begin(), result.faces.end(), number) != result.faces.end();
        if (known ||
            (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED)) {
            refusal = {entity_name(2, number) + " lies inside " + entity_name(3, solid),
                       names(2, number)};
            return std::nullopt;
        }
        result.faces.push_back(number);
        result.reversed.push_back(face.Orientation() != shape.face(number).Orientation() ? 1 : 0);
        result.loops.emplace_back();
        geometry.faces.push_back(face);
        geometry.surfaces.emplace_back(face, Standard_False);
        for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
            if (wire.Value().ShapeType() != TopAbs_WIRE) {
                continue;
            }
            const auto edges = ordered(TopoDS::Wire(wire.Value()), face);
            const int start = static_cast<int>(result.coedges.size());
            const int count = static_cast<int>(edges.size());
            for (int i = 0; i < count; ++i) {
                const TopoDS_Edge &edge = edges[static_cast<std::size_t>(i)];
                if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) {
                    const int n = shape.edges.FindIndex(edge);
                    refusal = {entity_name(1, n) + " lies inside " + entity_name(2, number),
                               names(1, n)};
                    return std::nullopt;
                }
                Coedge c{};
                c.edge = shape.edges.FindIndex(edge);
                c.forward = edge.Orientation() == TopAbs_FORWARD;
                c.face = static_cast<int>(result.faces.size()) - 1;
                c.next = start + (i + 1) % count;
                c.prev = start + (i + count - 1) % count;
                c.mate = -1;
                c.vertex = shape.vertices.FindIndex(TopExp::FirstVertex(edge, Standard_True));
                c.corner = std::numbers::pi;
                c.dihedral = std::numbers::pi;
                c.degenerated = BRep_Tool::Degenerated(edge);
                result.coedges.push_back(c);
                geometry.edges.push_back(edge);
            }
            if (count > 0) {
                result.loops.back().push_back(start);
            }
        }
    }

    std::map<int, std::vector<int>> uses;
    for (std::size_t i = 0; i < result.coedges.size(); ++i) {
        if (!result.coedges[i].degenerated) {
            uses[result.coedges[i].edge].push_back(static_cast<int>(i));
        }
    }
    for (const auto &[edge, both] : uses) {
        if (both.size() != 2 || result.coedges[static_cast<std::size_t>(both[0])].forward ==
                                    result.coedges[static_cast<std::size_t>(both[1])].forward) {
            refusal = {std::to_string(both.size()) + " faces of " + entity_name(3, solid) +
                           " meet at " + entity_name(1, edge) + "; two are needed",
                       names(1, edge)};
            return std::nullopt;
        }
        result.coedges[static_cast<std::size_t>(both[0])].mate = both[1];
        result.coedges[static_cast<std::size_t>(both[1])].mate = both[0];
    }

    for (std::size_t i = 0; i < result.coedges.size(); ++i) {
        Coedge &c = result.coedges[i];
        if (c.degenerated) {
            continue;
        }
        const auto face = static_cast<std::size_t>(c.face);
        auto prev = static_cast<std::size_t>(c.prev);
        if (result.coedges[prev].degenerated) { // across a pole
            prev = static_cast<std::size_t>(result.coedges[prev].prev);
        }
        if (!result.coedges[prev].degenerated) {
            const Vec3 n = geometry.normal(i, face, c.forward ? 0 : 1);
            const double turn = signed_angle(geometry.tangent(prev, 1), geometry.tangent(i, 0), n);
            c.corner = std::numbers::pi - turn;
        }
        const Coedge &mate = result.coedges[static_cast<std::size_t>(c.mate)];
        const auto m = static_cast<std::size_t>(c.mate);
        const Vec3 mine = geometry.normal(i, face, 0.5);
        const Vec3 theirs = geometry.normal(m, static_cast<std::size_t>(mate.face), 0.5);
        c.dihedral = std::numbers::pi - signed_angle(mine, theirs, geometry.tangent(i, 0.5));
    }
    return result;
}

} // namespace nmgs::cad
