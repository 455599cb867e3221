// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/four_sides.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>

namespace nmgs::cad {

std::optional<FourSides> four_sides(const CadShape &shape, int face, Refusal &refusal) {
    // A reversed face hands its orientation on to its wires and edges, so that the explorer runs
    // counter-clockwise about the outward normal in any case.
    const TopoDS_Face oriented = shape.face(face);
    std::vector<TopoDS_Wire> wires;
    for (TopoDS_Iterator it(oriented); it.More(); it.Next()) {
        if (it.Value().ShapeType() == TopAbs_WIRE) {
            wires.push_back(TopoDS::Wire(it.Value()));
        }
    }
    const std::string name = entity_name(2, face);
    if (wires.size() != 1) {
        refusal = {name + " has " + std::to_string(wires.size()) +
                       " boundary loops; one with four sides is needed",
                   {name}};
        return std::nullopt;
    }
    std::vector<int> edges;
    std::vector<int> corners;
    for (BRepTools_WireExplorer it(wires.front(), oriented); it.More(); it.Next()) {
        const TopoDS_Edge &edge = it.Current();
        const int n = shape.edges.FindIndex(edge);
        if (BRep_Tool::Degenerated(edge)) {
            refusal = {name + " has a pole at " +
                           entity_name(0, shape.vertices.FindIndex(it.CurrentVertex())),
                       {name, entity_name(0, shape.vertices.FindIndex(it.CurrentVertex()))}};
            return std::nullopt;
        }
        if (std::find(edges.begin(), edges.end(), n) != edges.end()) {
            refusal = {name + " is closed: it meets itself along the seam " + entity_name(1, n),
                       {name, entity_name(1, n)}};
            return std::nullopt;
        }
        edges.push_back(n);
        corners.push_back(shape.vertices.FindIndex(TopExp::FirstVertex(edge, Standard_True)));
    }
    if (edges.size() != 4) {
        refusal = {name + " has " + std::to_string(edges.size()) + " sides; four are needed",
                   {name}};
        return std::nullopt;
    }
    FourSides sides{};
    std::copy(edges.begin(), edges.end(), sides.edge.begin());
    std::copy(corners.begin(), corners.end(), sides.corner.begin());
    return sides;
}

} // namespace nmgs::cad
