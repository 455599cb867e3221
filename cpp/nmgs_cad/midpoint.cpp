// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/midpoint.h"

#include "nmgs/support/ascending.h"
#include "nmgs_cad/face_projection.h"
#include "nmgs_cad/midpoint_star.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace nmgs::cad {
namespace {

std::optional<FaceSides> loop_of(const CadShape &shape, const TopoDS_Face &face, Refusal &refusal) {
    const int n = shape.faces.FindIndex(face);
    const std::string name = entity_name(2, n);
    FaceSides loop{n, face.Orientation() != shape.face(n).Orientation(), {}};
    int wires = 0;
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
        if (it.Value().ShapeType() != TopAbs_WIRE || ++wires > 1) {
            refusal = {name + " has more than one boundary loop", {name}};
            return std::nullopt;
        }
        std::set<int> seen;
        for (BRepTools_WireExplorer edge(TopoDS::Wire(it.Value()), face); edge.More();
             edge.Next()) {
            const int e = shape.edges.FindIndex(edge.Current());
            const int v =
                shape.vertices.FindIndex(TopExp::FirstVertex(edge.Current(), Standard_True));
            if (BRep_Tool::Degenerated(edge.Current())) {
                continue; // a pole is a vertex like others
            }
            if (!seen.insert(e).second) {
                refusal = {name + " has a seam", {name, entity_name(1, e)}};
                return std::nullopt;
            }
            loop.sides.push_back({v, e});
        }
    }
    if (loop.sides.size() < 2) {
        refusal = {name + " is bounded by fewer than two edges", {name}};
        return std::nullopt;
    }
    return loop;
}

Vec3 mean(const Layout &layout, const std::vector<std::int32_t> &points) {
    Vec3 sum{};
    for (const auto p : points) {
        sum += layout.points[static_cast<std::size_t>(p)];
    }
    return 1.0 / static_cast<double>(points.size()) * sum;
}

// The point in the middle of a face: new, or the one that all quads of an earlier subdivision
// share.
std::optional<std::int32_t> centre_of(const CadShape &shape, const FaceSides &loop, Layout &layout,
                                      const std::map<int, std::int32_t> &middle) {
    const auto quads = layout.quads_of(loop.face);
    if (!quads.empty()) {
        std::map<std::int32_t, std::size_t> uses;
        for (const auto q : quads) {
            for (const auto p : layout.quads[static_cast<std::size_t>(q)].points) {
                ++uses[p];
            }
        }
        if (quads.size() == loop.sides.size()) {
            for (const auto &[p, count] : uses) {
                if (count == quads.size()) {
                    return p;
                }
            }
        }
        return std::nullopt;
    }
    std::vector<std::int32_t> around;
    for (const FaceSide &side : loop.sides) {
        around.push_back(middle.at(side.edge));
    }
    FaceProjection projection(shape.face(loop.face));
    const auto centre = layout.add_point(projection.nearest(mean(layout, around)), {2, loop.face});
    for (std::size_t i = 0; i < loop.sides.size(); ++i) {
        const std::size_t before = (i + loop.sides.size() - 1) % loop.sides.size();
        Layout::Quad quad{{layout.vertex(shape, loop.sides[i].vertex),
                           middle.at(loop.sides[i].edge), centre,
                           middle.at(loop.sides[before].edge)},
                          loop.face};
        if (loop.reversed) {
            std::swap(quad.points[1], quad.points[3]);
        }
        layout.quads.push_back(quad);
    }
    return centre;
}

} // namespace

bool fill_midpoint(const CadShape &shape, int solid, Layout &layout, const LayoutOptions & /*o*/,
                   Refusal &refusal, const Progress & /*progress*/) {
    std::vector<FaceSides> loops;
    // Edges at a vertex, and the face that has two edges of it.
    std::map<int, std::set<int>> edges_at;
    std::map<std::array<int, 2>, std::size_t> face_with;
    int shells = 0;
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_SHELL); it.More(); it.Next()) {
        ++shells;
    }
    if (shells != 1) {
        refusal = {entity_name(3, solid) + " has a cavity", {entity_name(3, solid)}};
        return false;
    }
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        auto loop = loop_of(shape, TopoDS::Face(it.Current()), refusal);
        if (!loop) {
            return false;
        }
        loops.push_back(std::move(*loop));
        for (std::size_t i = 0; i < loops.back().sides.size(); ++i) {
            const auto &sides = loops.back().sides;
            const int before = sides[(i + sides.size() - 1) % sides.size()].edge;
            edges_at[sides[i].vertex].insert({sides[i].edge, before});
            face_with[ascending(sides[i].edge, before)] = loops.size() - 1;
        }
    }
    for (const auto &[vertex, edges] : edges_at) {
        if (edges.size() != 3) {
            refusal = {std::to_string(edges.size()) + " edges meet at " + entity_name(0, vertex) +
                           "; three are needed",
                       {entity_name(0, vertex)}};
            Layout trial = layout;
            Refusal no_star;
            if (edges.size() > 3 && fill_star(shape, solid, loops, trial, no_star)) {
                layout = std::move(trial);
                return true;
            }
            return false;
        }
    }
    std::map<int, std::int32_t> middle;
    for (const FaceSides &loop : loops) {
        for (const FaceSide &side : loop.sides) {
            constexpr double half = 0.5;
            const auto &points = layout.divide_edge(shape, side.edge, {&half, 1});
            if (points.size() != 3) {
                refusal = {entity_name(1, side.edge) + " is not in two parts already",
                           {entity_name(1, side.edge)}};
                return false;
            }
            middle[side.edge] = points[1];
        }
    }
    std::vector<std::int32_t> centre;
    for (const FaceSides &loop : loops) {
        const auto c = centre_of(shape, loop, layout, middle);
        if (!c) {
            refusal = {entity_name(2, loop.face) + " is laid out in another way already",
                       {entity_name(2, loop.face)}};
            return false;
        }
        centre.push_back(*c);
    }
    const auto inner = layout.add_point(mean(layout, centre), {3, solid});
    std::set<int> done;
    for (std::size_t f = 0; f < loops.size(); ++f) {
        const auto &sides = loops[f].sides;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            if (!done.insert(sides[i].vertex).second) {
                continue;
            }
            // Seen from outside the face runs counter-clockwise, so that the edge that comes, the
            // one that goes, and the third are right-handed.
            const int a = sides[(i + sides.size() - 1) % sides.size()].edge;
            const int b = sides[i].edge;
            int c = 0;
            for (const int e : edges_at[sides[i].vertex]) {
                c = e != a && e != b ? e : c;
            }
            const auto ac = face_with.find(ascending(a, c));
            const auto bc = face_with.find(ascending(b, c));
            if (ac == face_with.end() || bc == face_with.end()) {
                refusal = {"the faces at " + entity_name(0, sides[i].vertex) +
                               " do not close round it",
                           {entity_name(0, sides[i].vertex)}};
                return false;
            }
            layout.hexas.push_back(
                {{layout.vertex(shape, sides[i].vertex), middle[a], centre[f], middle[b], middle[c],
                  centre[ac->second], inner, centre[bc->second]},
                 solid});
        }
    }
    return true;
}

} // namespace nmgs::cad
