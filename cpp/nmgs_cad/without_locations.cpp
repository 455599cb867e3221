// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/without_locations.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <ShapeUpgrade_RemoveLocations.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>

namespace nmgs::cad {
namespace {

bool numbered_alike(const CadShape &a, const CadShape &b) {
    if (a.solids.Extent() != b.solids.Extent() || a.faces.Extent() != b.faces.Extent() ||
        a.edges.Extent() != b.edges.Extent() || a.vertices.Extent() != b.vertices.Extent()) {
        return false;
    }
    for (int v = 1; v <= a.vertices.Extent(); ++v) {
        if (distance(a.point(v), b.point(v)) > BRep_Tool::Tolerance(a.vertex(v))) {
            return false;
        }
    }
    const auto ends_alike = [&](int e) {
        const TopoDS_Edge p = a.edge(e);
        const TopoDS_Edge q = b.edge(e);
        return a.vertices.FindIndex(TopExp::FirstVertex(p)) ==
                   b.vertices.FindIndex(TopExp::FirstVertex(q)) &&
               a.vertices.FindIndex(TopExp::LastVertex(p)) ==
                   b.vertices.FindIndex(TopExp::LastVertex(q)) &&
               p.Orientation() == q.Orientation();
    };
    for (int e = 1; e <= a.edges.Extent(); ++e) {
        if (!ends_alike(e)) {
            return false;
        }
    }
    for (int f = 1; f <= a.faces.Extent(); ++f) {
        if (a.faces(f).Orientation() != b.faces(f).Orientation()) {
            return false;
        }
        TopExp_Explorer p(a.faces(f), TopAbs_EDGE);
        TopExp_Explorer q(b.faces(f), TopAbs_EDGE);
        for (; p.More() && q.More(); p.Next(), q.Next()) {
            if (a.edges.FindIndex(p.Current()) != b.edges.FindIndex(q.Current())) {
                return false;
            }
        }
        if (p.More() || q.More()) {
            return false;
        }
    }
    return true;
}

bool near(const gp_Pnt &p, const gp_Pnt &q, double tolerance) {
    return p.Distance(q) <= std::max(tolerance, Precision::Confusion());
}

bool same_edge(const TopoDS_Edge &p, const TopoDS_Edge &q) {
    if (BRep_Tool::Degenerated(p) || BRep_Tool::Degenerated(q)) {
        return BRep_Tool::Degenerated(p) == BRep_Tool::Degenerated(q);
    }
    const BRepAdaptor_Curve a(p);
    const BRepAdaptor_Curve b(q);
    const auto at_part = [](const BRepAdaptor_Curve &c, double t) {
        return c.Value((1 - t) * c.FirstParameter() + t * c.LastParameter());
    };
    constexpr std::array<double, 3> parts{0.25, 0.5, 0.75};
    return std::all_of(parts.begin(), parts.end(), [&](double t) {
        return near(at_part(a, t), at_part(b, t), BRep_Tool::Tolerance(p));
    });
}

// The middle of the face's parameters, and of each of its edges as the face has it.
bool same_face(const TopoDS_Face &p, const TopoDS_Face &q) {
    const BRepAdaptor_Surface a(p, Standard_False);
    const BRepAdaptor_Surface b(q, Standard_False);
    std::array<double, 4> r{};
    std::array<double, 4> s{};
    BRepTools::UVBounds(p, r[0], r[1], r[2], r[3]);
    BRepTools::UVBounds(q, s[0], s[1], s[2], s[3]);
    const double size = a.Value(r[0], r[2]).Distance(a.Value(r[1], r[3]));
    const double tolerance = std::max(BRep_Tool::Tolerance(p), 1e-7 * size);
    if (!near(a.Value((r[0] + r[1]) / 2, (r[2] + r[3]) / 2),
              b.Value((s[0] + s[1]) / 2, (s[2] + s[3]) / 2), tolerance)) {
        return false;
    }
    TopExp_Explorer x(p, TopAbs_EDGE);
    TopExp_Explorer y(q, TopAbs_EDGE);
    for (; x.More() && y.More(); x.Next(), y.Next()) {
        const BRepAdaptor_Curve c(TopoDS::Edge(x.Current()), p);
        const BRepAdaptor_Curve d(TopoDS::Edge(y.Current()), q);
        if (x.Current().Orientation() != y.Current().Orientation() ||
            !near(c.Value((c.FirstParameter() + c.LastParameter()) / 2),
                  d.Value((d.FirstParameter() + d.LastParameter()) / 2),
                  std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(x.Current()))))) {
            return false;
        }
    }
    return !x.More() && !y.More();
}

// Whether the shapes, numbered alike, are the same in space: of some compounds OpenCASCADE's tool
// makes faces that are elsewhere, or have no box.
bool same_in_space(const CadShape &a, const CadShape &b) {
    for (int s = 1; s <= a.solids.Extent(); ++s) {
        TopExp_Explorer p(a.solid(s), TopAbs_FACE);
        TopExp_Explorer q(b.solid(s), TopAbs_FACE);
        for (; p.More() && q.More(); p.Next(), q.Next()) {
            if (a.faces.FindIndex(p.Current()) != b.faces.FindIndex(q.Current()) ||
                p.Current().Orientation() != q.Current().Orientation()) {
                return false;
            }
        }
        if (p.More() || q.More()) {
            return false;
        }
    }
    for (int e = 1; e <= a.edges.Extent(); ++e) {
        if (!same_edge(a.edge(e), b.edge(e))) {
            return false;
        }
    }
    for (int f = 1; f <= a.faces.Extent(); ++f) {
        if (!same_face(a.face(f), b.face(f))) {
            return false;
        }
    }
    return true;
}

} // namespace

CadShape without_locations(const CadShape &shape) {
    try {
        ShapeUpgrade_RemoveLocations remover;
        remover.SetRemoveLevel(TopAbs_COMPOUND);
        if (remover.Remove(shape.shape)) {
            CadShape result = make_shape(remover.GetResult());
            if (numbered_alike(shape, result) && same_in_space(shape, result)) {
                return result;
            }
        }
    } catch (const Standard_Failure &) { // NOLINT(bugprone-empty-catch): it stays as it is
    }
    return shape;
}

} // namespace nmgs::cad
