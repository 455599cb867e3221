// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/without_locations.h"

#include <BRep_Tool.hxx>
#include <ShapeUpgrade_RemoveLocations.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>

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

} // namespace

CadShape without_locations(const CadShape &shape) {
    try {
        ShapeUpgrade_RemoveLocations remover;
        remover.SetRemoveLevel(TopAbs_COMPOUND);
        if (remover.Remove(shape.shape)) {
            CadShape result = make_shape(remover.GetResult());
            if (numbered_alike(shape, result)) {
                return result;
            }
        }
    } catch (const Standard_Failure &) { // NOLINT(bugprone-empty-catch): it stays as it is
    }
    return shape;
}

} // namespace nmgs::cad
