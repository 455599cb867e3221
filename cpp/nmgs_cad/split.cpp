// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/split.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/edge_curve.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace nmgs::cad {
namespace {

// What the entity has become: its images, itself where it is unchanged.
TopTools_ListOfShape images(BRepAlgoAPI_BuilderAlgo &algorithm, const TopoDS_Shape &entity) {
    TopTools_ListOfShape list;
    if (algorithm.HasHistory()) {
        list = algorithm.Modified(entity);
    }
    if (list.IsEmpty() && (!algorithm.HasHistory() || !algorithm.IsDeleted(entity))) {
        list.Append(entity);
    }
    return list;
}

void name_images(BRepAlgoAPI_BuilderAlgo &algorithm, const TopoDS_Shape &entity, CadEntity as,
                 const TopTools_IndexedMapOfShape &map, std::vector<CadEntity> &on) {
    for (const TopoDS_Shape &image : images(algorithm, entity)) {
        const int n = map.FindIndex(image);
        if (n > 0 && on[at(n)].dimension > as.dimension) { // the first one's name stays
            on[at(n)] = as;
        }
    }
}

// A vertex that has become one with a tool's may be gone from the history: it is found by place.
void name_by_place(const CadShape &shape, const TopTools_IndexedMapOfShape &vertices,
                   Pieces &pieces) {
    std::set<int> there;
    for (const CadEntity &on : pieces.vertex_on) {
        if (on.dimension == 0) {
            there.insert(on.index);
        }
    }
    for (int n = 1; n <= vertices.Extent(); ++n) {
        const int number = shape.vertices.FindIndex(vertices(n));
        if (there.contains(number)) {
            continue;
        }
        const TopoDS_Vertex old = TopoDS::Vertex(vertices(n));
        int nearest = 0;
        double least = 0;
        for (int v = 1; v <= pieces.cad.vertices.Extent(); ++v) {
            const TopoDS_Vertex vertex = pieces.cad.vertex(v);
            const double away = BRep_Tool::Pnt(vertex).Distance(BRep_Tool::Pnt(old));
            if (away <= BRep_Tool::Tolerance(vertex) + BRep_Tool::Tolerance(old) &&
                pieces.vertex_on[at(v)].dimension != 0 && (nearest == 0 || away < least)) {
                nearest = v;
                least = away;
            }
        }
        if (nearest > 0) {
            pieces.vertex_on[at(nearest)] = {0, number};
        }
    }
}

// What is not an image of a smaller entity lies on the face that it bounds a piece of, else in the
// solid.
void inherit(const CadShape &cad, Pieces &pieces) {
    for (int f = 1; f <= cad.faces.Extent(); ++f) {
        const CadEntity on = pieces.face_on[at(f)];
        for (TopExp_Explorer it(cad.faces(f), TopAbs_EDGE); it.More(); it.Next()) {
            auto &mine = pieces.edge_on[at(cad.edges.FindIndex(it.Current()))];
            mine = mine.dimension > on.dimension ? on : mine;
        }
        for (TopExp_Explorer it(cad.faces(f), TopAbs_VERTEX); it.More(); it.Next()) {
            auto &mine = pieces.vertex_on[at(cad.vertices.FindIndex(it.Current()))];
            mine = mine.dimension > on.dimension ? on : mine;
        }
    }
    for (int e = 1; e <= cad.edges.Extent(); ++e) {
        const CadEntity on = pieces.edge_on[at(e)];
        for (TopExp_Explorer it(cad.edges(e), TopAbs_VERTEX); it.More(); it.Next()) {
            auto &mine = pieces.vertex_on[at(cad.vertices.FindIndex(it.Current()))];
            mine = mine.dimension > on.dimension ? on : mine;
        }
    }
}

struct Parts {
    TopTools_IndexedMapOfShape faces, edges, vertices;
};
Parts parts_of(const CadShape &shape, std::span<const int> solids) {
    Parts parts;
    for (const int n : solids) {
        TopExp::MapShapes(shape.solid(n), TopAbs_FACE, parts.faces);
        TopExp::MapShapes(shape.solid(n), TopAbs_EDGE, parts.edges);
        TopExp::MapShapes(shape.solid(n), TopAbs_VERTEX, parts.vertices);
    }
    return parts;
}

// The first entity of these solids, other than a degenerated edge, that no piece lies on.
std::optional<CadEntity> lost(const CadShape &shape, std::span<const int> solids,
                              const Pieces &pieces) {
    std::set<std::array<int, 2>> there;
    for (const auto *list : {&pieces.vertex_on, &pieces.edge_on, &pieces.face_on}) {
        for (const CadEntity &e : *list) {
            there.insert({e.dimension, e.index});
        }
    }
    const Parts parts = parts_of(shape, solids);
    for (int n = 1; n <= parts.vertices.Extent(); ++n) {
        const int number = shape.vertices.FindIndex(parts.vertices(n));
        if (!there.contains({0, number})) {
            return CadEntity{0, number};
        }
    }
    for (int n = 1; n <= parts.edges.Extent(); ++n) {
        const int number = shape.edges.FindIndex(parts.edges(n));
        if (!there.contains({1, number}) && !BRep_Tool::Degenerated(TopoDS::Edge(parts.edges(n)))) {
            return CadEntity{1, number};
        }
    }
    for (int n = 1; n <= parts.faces.Extent(); ++n) {
        const int number = shape.faces.FindIndex(parts.faces(n));
        if (!there.contains({2, number})) {
            return CadEntity{2, number};
        }
    }
    return std::nullopt;
}

// What becomes of the arguments, which are made of these solids, whose volumes are given by number;
// OpenCASCADE's failures are thrown.
std::optional<Pieces> pieces_of(const CadShape &shape, std::span<const int> solids,
                                const std::vector<double> &volumes,
                                const TopTools_ListOfShape &arguments,
                                const TopTools_ListOfShape &tools, Refusal &refusal) {
    double volume = 0;
    for (const int n : solids) {
        volume += volumes[at(n)];
    }
    BRepAlgoAPI_Splitter splitter;
    BRepAlgoAPI_BuilderAlgo fuse;
    BRepAlgoAPI_BuilderAlgo &algorithm = tools.IsEmpty() ? fuse : splitter;
    algorithm.SetArguments(arguments);
    if (!tools.IsEmpty()) {
        splitter.SetTools(tools);
    }
    algorithm.SetNonDestructive(Standard_True);
    algorithm.SetRunParallel(Standard_False);
    const bool alone = tools.IsEmpty() && arguments.Size() == 1; // nothing to do
    algorithm.SetToFillHistory(!alone);
    if (!alone) {
        algorithm.Build();
        if (!algorithm.IsDone() || algorithm.HasErrors()) {
            refusal.reason = "OpenCASCADE cannot split it";
            return std::nullopt;
        }
    }
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    TopTools_IndexedMapOfShape found;
    TopExp::MapShapes(alone ? arguments.First() : algorithm.Shape(), TopAbs_SOLID, found);
    for (int n = 1; n <= found.Extent(); ++n) {
        builder.Add(compound, found(n));
    }
    Pieces pieces;
    pieces.cad = make_shape(compound);
    pieces.volume.assign(at(pieces.cad.solids.Extent()) + 1, 0);
    double sum = 0;
    for (int n = 1; n <= pieces.cad.solids.Extent(); ++n) {
        const int before = shape.solids.FindIndex(pieces.cad.solids(n)); // as it was
        pieces.volume[at(n)] =
            before > 0 ? volumes[at(before)] : std::abs(volume_of(pieces.cad.solid(n)));
        sum += pieces.volume[at(n)];
    }
    if (std::abs(sum - volume) > 1e-4 * volume) {
        refusal.reason = "the pieces do not have its volume";
        return std::nullopt;
    }
    const CadShape &cad = pieces.cad;
    const CadEntity nowhere{4, 0};
    pieces.vertex_on.assign(at(cad.vertices.Extent()) + 1, nowhere);
    pieces.edge_on.assign(at(cad.edges.Extent()) + 1, nowhere);
    pieces.face_on.assign(at(cad.faces.Extent()) + 1, nowhere);
    pieces.solid_on.assign(at(cad.solids.Extent()) + 1, nowhere);
    for (const int n : solids) {
        name_images(algorithm, shape.solid(n), {3, n}, cad.solids, pieces.solid_on);
    }
    const Parts parts = parts_of(shape, solids);
    for (int n = 1; n <= parts.faces.Extent(); ++n) {
        name_images(algorithm, parts.faces(n), {2, shape.faces.FindIndex(parts.faces(n))},
                    cad.faces, pieces.face_on);
    }
    for (int n = 1; n <= parts.edges.Extent(); ++n) {
        name_images(algorithm, parts.edges(n), {1, shape.edges.FindIndex(parts.edges(n))},
                    cad.edges, pieces.edge_on);
    }
    for (int n = 1; n <= parts.vertices.Extent(); ++n) {
        name_images(algorithm, parts.vertices(n), {0, shape.vertices.FindIndex(parts.vertices(n))},
                    cad.vertices, pieces.vertex_on);
    }
    name_by_place(shape, parts.vertices, pieces);
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        if (pieces.solid_on[at(n)].dimension != 3) {
            refusal.reason = "a piece has lost the solid that it comes from";
            return std::nullopt;
        }
        for (TopExp_Explorer it(cad.solids(n), TopAbs_FACE); it.More(); it.Next()) {
            auto &on = pieces.face_on[at(cad.faces.FindIndex(it.Current()))];
            on = on.dimension > 3 ? pieces.solid_on[at(n)] : on;
        }
    }
    inherit(cad, pieces);
    return pieces;
}

TopoDS_Compound compound_of(const CadShape &shape, std::span<const int> solids) {
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const int n : solids) {
        builder.Add(compound, shape.solid(n));
    }
    return compound;
}

std::vector<int> all_solids(const CadShape &shape) {
    std::vector<int> solids(at(shape.solids.Extent()));
    std::iota(solids.begin(), solids.end(), 1);
    return solids;
}

} // namespace

std::optional<Pieces> split(const CadShape &shape, std::span<const int> solids,
                            const TopTools_ListOfShape &tools, Refusal &refusal) {
    refusal = {};
    for (const int n : solids) {
        refusal.blockers.push_back(entity_name(3, n));
    }
    try {
        TopTools_ListOfShape arguments;
        std::vector<double> volumes(at(shape.solids.Extent()) + 1, 0);
        for (const int n : solids) {
            arguments.Append(shape.solid(n));
            volumes[at(n)] = std::abs(volume_of(shape.solid(n)));
        }
        auto pieces = pieces_of(shape, solids, volumes, arguments, tools, refusal);
        if (!pieces) {
            return std::nullopt;
        }
        // Solids that touch may have given their entities to each other; cuts leave all there.
        if (const auto missing = tools.IsEmpty() ? std::nullopt : lost(shape, solids, *pieces)) {
            const std::string name = entity_name(missing->dimension, missing->index);
            refusal = {"cutting loses " + name, {name}};
            return std::nullopt;
        }
        refusal = {};
        return pieces;
    } catch (const Standard_Failure &failure) {
        refusal.reason = std::string("OpenCASCADE: ") + failure.GetMessageString();
        return std::nullopt;
    }
}

std::optional<Pieces> split(const CadShape &shape, const Pieces &pieces,
                            const TopTools_ListOfShape &tools, Refusal &refusal) {
    std::set<int> whole;
    for (std::size_t n = 1; n < pieces.solid_on.size(); ++n) {
        whole.insert(pieces.solid_on[n].index);
    }
    refusal = {};
    for (const int n : whole) {
        refusal.blockers.push_back(entity_name(3, n));
    }
    try {
        const std::vector<int> parts = all_solids(pieces.cad);
        TopTools_ListOfShape arguments;
        // OpenCASCADE turns solids that are stored inside out only where they are arguments.
        const bool turned = std::any_of(parts.begin(), parts.end(), [&](int n) {
            const TopoDS_Solid solid = pieces.cad.solid(n);
            return solid.Orientation() != TopAbs_FORWARD || volume_of(solid) < 0;
        });
        if (turned) {
            for (const int n : parts) {
                arguments.Append(pieces.cad.solid(n));
            }
        } else {
            arguments.Append(compound_of(pieces.cad, parts));
        }
        auto finer = pieces_of(pieces.cad, parts, pieces.volume, arguments, tools, refusal);
        if (!finer) {
            return std::nullopt;
        }
        for (auto *list : {&finer->vertex_on, &finer->edge_on, &finer->face_on, &finer->solid_on}) {
            for (CadEntity &e : *list) {
                const auto &on = e.dimension == 0   ? pieces.vertex_on
                                 : e.dimension == 1 ? pieces.edge_on
                                 : e.dimension == 2 ? pieces.face_on
                                                    : pieces.solid_on;
                e = e.dimension > 3 ? e : on[at(e.index)];
            }
        }
        const std::vector<int> solids(whole.begin(), whole.end());
        if (const auto missing = lost(shape, solids, *finer)) {
            const std::string name = entity_name(missing->dimension, missing->index);
            refusal = {"cutting loses " + name, {name}};
            return std::nullopt;
        }
        refusal = {};
        return finer;
    } catch (const Standard_Failure &failure) {
        refusal.reason = std::string("OpenCASCADE: ") + failure.GetMessageString();
        return std::nullopt;
    }
}

std::optional<Pieces> imprint(const CadShape &shape, Refusal &refusal) {
    return split(shape, all_solids(shape), {}, refusal);
}

namespace {

Vec3 normal_near(const CadShape &shape, int face, Vec3 p) {
    const TopoDS_Face f = shape.face(face);
    ShapeAnalysis_Surface surface(BRep_Tool::Surface(f));
    const gp_Pnt2d uv = surface.ValueOfUV({p.x, p.y, p.z}, 1e-7);
    gp_Pnt q;
    gp_Vec du;
    gp_Vec dv;
    BRep_Tool::Surface(f)->D1(uv.X(), uv.Y(), q, du, dv);
    const gp_Vec n = du.Crossed(dv);
    const Vec3 v{n.X(), n.Y(), n.Z()};
    return f.Orientation() == TopAbs_REVERSED ? -1.0 * v : v;
}

} // namespace

bool join(const CadShape &shape, const Pieces &pieces, const Layout &of_pieces, Layout &layout,
          Refusal &refusal) {
    const CadShape &cad = pieces.cad;
    std::set<int> solids;
    for (std::size_t n = 1; n < pieces.solid_on.size(); ++n) {
        solids.insert(pieces.solid_on[n].index);
    }
    const std::vector<int> list(solids.begin(), solids.end());
    const Parts parts = parts_of(shape, list);
    std::set<int> laid;
    for (const auto &quad : layout.quads) {
        laid.insert(quad.face);
    }
    for (int n = 1; n <= parts.edges.Extent(); ++n) {
        const int edge = shape.edges.FindIndex(parts.edges(n));
        if (!layout.edges[at(edge)].empty()) {
            refusal = {entity_name(1, edge) + " is laid out already by a neighbour",
                       {entity_name(1, edge)}};
            return false;
        }
    }
    for (int n = 1; n <= parts.faces.Extent(); ++n) {
        const int face = shape.faces.FindIndex(parts.faces(n));
        if (laid.contains(face)) {
            refusal = {entity_name(2, face) + " is laid out already by a neighbour",
                       {entity_name(2, face)}};
            return false;
        }
    }

    std::vector<std::int32_t> number;
    for (std::size_t p = 0; p < of_pieces.points.size(); ++p) {
        const auto [dimension, index] = of_pieces.on[p];
        const CadEntity on = dimension == 0   ? pieces.vertex_on[at(index)]
                             : dimension == 1 ? pieces.edge_on[at(index)]
                             : dimension == 2 ? pieces.face_on[at(index)]
                                              : pieces.solid_on[at(index)];
        number.push_back(on.dimension == 0 ? layout.vertex(shape, on.index)
                                           : layout.add_point(of_pieces.points[p], on));
    }

    // The pieces of each edge, in the order and sense in which it runs.
    struct Part {
        double place;
        std::vector<std::int32_t> points;
    };
    std::map<int, std::vector<Part>> edges;
    for (int e = 1; e <= cad.edges.Extent(); ++e) {
        const CadEntity on = pieces.edge_on[at(e)];
        if (on.dimension != 1 || of_pieces.edges[at(e)].empty()) {
            continue;
        }
        const EdgeCurve whole(shape.edge(on.index));
        const EdgeCurve piece(cad.edge(e));
        Part part{whole.fraction(piece.at(0.5)), {}};
        for (const auto p : of_pieces.edges[at(e)]) {
            part.points.push_back(number[at(p)]);
        }
        if (whole.fraction(piece.at(0.25)) > whole.fraction(piece.at(0.75))) {
            std::reverse(part.points.begin(), part.points.end());
        }
        edges[on.index].push_back(std::move(part));
    }
    for (auto &[edge, sequence] : edges) {
        std::sort(sequence.begin(), sequence.end(),
                  [](const Part &a, const Part &b) { return a.place < b.place; });
        auto &points = layout.edges[at(edge)];
        for (const Part &part : sequence) {
            if (!points.empty() && points.back() != part.points.front()) {
                refusal = {"the pieces of " + entity_name(1, edge) + " do not follow one another",
                           {entity_name(1, edge)}};
                return false;
            }
            points.insert(points.end(), part.points.begin() + (points.empty() ? 0 : 1),
                          part.points.end());
        }
    }

    std::map<int, bool> turned; // of each piece of a face
    for (const auto &quad : of_pieces.quads) {
        const CadEntity on = pieces.face_on[at(quad.face)];
        if (on.dimension != 2) {
            continue;
        }
        Layout::Quad mine{{}, on.index};
        std::array<Vec3, 4> p{};
        for (std::size_t i = 0; i < 4; ++i) {
            mine.points[i] = number[at(quad.points[i])];
            p[i] = of_pieces.points[at(quad.points[i])];
        }
        auto known = turned.find(quad.face);
        if (known == turned.end()) {
            const Vec3 centre = 0.25 * (p[0] + p[1] + p[2] + p[3]);
            const Vec3 mine_normal = normal_near(cad, quad.face, centre);
            const Vec3 theirs = normal_near(shape, on.index, centre);
            known = turned.emplace(quad.face, dot(mine_normal, theirs) < 0).first;
        }
        if (known->second) {
            std::swap(mine.points[1], mine.points[3]);
        }
        layout.quads.push_back(mine);
    }

    std::set<std::array<std::int32_t, 2>> on_edges;
    for (const auto &[edge, sequence] : edges) {
        const auto &points = layout.edges[at(edge)];
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            on_edges.insert(ascending(points[i], points[i + 1]));
        }
    }
    const CadBlocks blocks = blocks_of(cad, of_pieces, 3);
    for (std::size_t b = 0; b < of_pieces.hexas.size(); ++b) {
        const auto &hexa = of_pieces.hexas[b];
        Layout::Hexa mine{{}, pieces.solid_on[at(hexa.solid)].index};
        for (std::size_t i = 0; i < 8; ++i) {
            mine.points[i] = number[at(hexa.points[i])];
        }
        layout.hexas.push_back(mine);
        const auto nodes = blocks.model.element(static_cast<std::int32_t>(b));
        for (std::size_t n = 8; n < 20; ++n) {
            // The two corners whose mean is the middle's natural place.
            std::array<std::size_t, 2> ends{};
            std::size_t count = 0;
            for (std::size_t c = 0; c < 8; ++c) {
                bool beside = true;
                for (std::size_t d = 0; d < 3; ++d) {
                    beside = beside && (hexa20::natural[n][d] == 0 ||
                                        hexa20::natural[n][d] == hexa20::natural[c][d]);
                }
                if (beside) {
                    ends[count++] = c;
                }
            }
            const auto pair = ascending(mine.points[ends[0]], mine.points[ends[1]]);
            const Vec3 a = nodes[ends[0]];
            const Vec3 z = nodes[ends[1]];
            if (!on_edges.contains(pair) &&
                distance(nodes[n], 0.5 * (a + z)) > 1e-9 * distance(a, z)) {
                layout.middles[pair] = nodes[n];
            }
        }
    }
    return true;
}

} // namespace nmgs::cad
