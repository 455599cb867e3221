// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/skin_start.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs/support/error.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeAnalysis_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmgs::cad {
namespace {

// A face's triangulation with nodes of its own: both sides of a seam, each place of a pole.
struct Patch {
    struct Side {
        std::int32_t edge;
        std::vector<int> nodes; // along the curve
    };
    std::int32_t face;
    std::vector<std::array<int, 3>> triangles;
    std::vector<Uv> uv;
    std::vector<Vec3> places;
    std::vector<Side> sides;
};

struct Start {
    const CadShape &shape;
    SkinMesh &mesh;
    std::vector<Patch> patches{};
    std::vector<std::vector<double>> parameters; // of each edge's points, ends included

    void read(int number);
    static void insert(Patch &patch, Vec3 place, Uv uv);
    void halve(std::int32_t edge, std::size_t k);
    void mend();
    void build();
};

// Puts a point into the triangle that it falls into, or the two at an edge.
void Start::insert(Patch &patch, Vec3 place, Uv uv) {
    const auto twice = [](Uv a, Uv b, Uv c) {
        return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    };
    std::size_t best = 0;
    std::size_t opposite = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        const auto &p = patch.triangles[t];
        const double all = twice(patch.uv[at(p[0])], patch.uv[at(p[1])], patch.uv[at(p[2])]);
        double least = std::numeric_limits<double>::infinity();
        std::size_t corner = 0;
        for (std::size_t i = 0; i < 3 && all != 0; ++i) {
            const double share =
                twice(uv, patch.uv[at(p[(i + 1) % 3])], patch.uv[at(p[(i + 2) % 3])]) / all;
            if (share < least) {
                least = share;
                corner = i;
            }
        }
        if (all != 0 && least > most) {
            most = least;
            best = t;
            opposite = corner;
        }
    }
    if (!(most > -1e-6)) {
        return;
    }
    const auto fresh = static_cast<int>(patch.places.size());
    patch.places.push_back(place);
    patch.uv.push_back(uv);
    const auto old = patch.triangles[best];
    if (most > 1e-3) {
        for (std::size_t i = 0; i < 3; ++i) {
            auto part = old;
            part[i] = fresh;
            if (i == 0) {
                patch.triangles[best] = part;
            } else {
                patch.triangles.push_back(part);
            }
        }
        return;
    }
    const int a = old[(opposite + 1) % 3];
    const int b = old[(opposite + 2) % 3];
    const std::size_t count = patch.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        auto one = patch.triangles[t];
        if (std::find(one.begin(), one.end(), a) != one.end() &&
            std::find(one.begin(), one.end(), b) != one.end()) {
            auto two = one;
            std::replace(one.begin(), one.end(), a, fresh);
            std::replace(two.begin(), two.end(), b, fresh);
            patch.triangles[t] = one;
            patch.triangles.push_back(two);
        }
    }
}

void Start::read(int number) {
    const TopoDS_Face face = shape.face(number);
    TopLoc_Location place;
    const Handle(Poly_Triangulation) source = BRep_Tool::Triangulation(face, place);
    if (source.IsNull() || source->NbTriangles() == 0) {
        throw GeometryError("OpenCASCADE cannot triangulate " + entity_name(2, number),
                            {entity_name(2, number)});
    }
    Patch patch;
    patch.face = number;
    for (int n = 1; n <= source->NbNodes(); ++n) {
        patch.places.push_back(vec(source->Node(n).Transformed(place.Transformation())));
        if (source->HasUVNodes()) {
            patch.uv.push_back({source->UVNode(n).X(), source->UVNode(n).Y()});
        } else {
            patch.uv.push_back(mesh.face(number).nearest(patch.places.back(), {}));
        }
    }
    const bool reversed = face.Orientation() == TopAbs_REVERSED;
    for (int t = 1; t <= source->NbTriangles(); ++t) {
        int a = 0;
        int b = 0;
        int c = 0;
        source->Triangle(t).Get(a, b, c);
        if (reversed) {
            std::swap(b, c);
        }
        patch.triangles.push_back({a - 1, b - 1, c - 1});
    }
    // OpenCASCADE leaves out the vertices inside a face.
    for (TopoDS_Iterator v(face); v.More(); v.Next()) {
        if (v.Value().ShapeType() != TopAbs_VERTEX) {
            continue;
        }
        const Vec3 p = vec(BRep_Tool::Pnt(TopoDS::Vertex(v.Value())));
        const bool known = std::any_of(patch.places.begin(), patch.places.end(), [&](Vec3 q) {
            return distance(p, q) <= 1e-7 * mesh.diagonal;
        });
        if (!known) {
            insert(patch, p, mesh.face(number).nearest(p, {}));
        }
    }
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge &edge = TopoDS::Edge(e.Current());
        const Handle(Poly_PolygonOnTriangulation) line =
            BRep_Tool::PolygonOnTriangulation(edge, source, place);
        if (line.IsNull()) {
            continue;
        }
        Patch::Side side{shape.edges.FindIndex(edge), {}};
        for (int k = 1; k <= line->NbNodes(); ++k) {
            side.nodes.push_back(line->Node(k) - 1);
        }
        auto &known = parameters[at(side.edge)];
        if (known.empty() && !BRep_Tool::Degenerated(edge)) {
            const EdgeGeometry &geometry = mesh.edge(side.edge);
            known.push_back(geometry.first);
            for (int k = 2; k < line->NbNodes(); ++k) {
                double t = 0;
                if (line->HasParameters()) {
                    t = line->Parameter(k);
                } else {
                    gp_Pnt foot;
                    const Vec3 p = patch.places[at(side.nodes[at(k - 1)])];
                    ShapeAnalysis_Curve().Project(geometry.curve, {p.x, p.y, p.z}, 1e-7, foot, t,
                                                  Standard_False);
                }
                known.push_back(t);
            }
            known.push_back(geometry.last);
        }
        patch.sides.push_back(std::move(side));
    }
    patches.push_back(std::move(patch));
}

// Puts a point into segment k of an edge, in all faces that it bounds.
void Start::halve(std::int32_t edge, std::size_t k) {
    auto &t = parameters[at(edge)];
    const double middle = 0.5 * (t[k] + t[k + 1]);
    t.insert(t.begin() + static_cast<std::ptrdiff_t>(k) + 1, middle);
    const gp_Pnt p = mesh.edge(edge).curve.Value(middle);
    for (Patch &patch : patches) {
        for (auto &side : patch.sides) {
            if (side.edge != edge) {
                continue;
            }
            const int a = side.nodes[k];
            const int b = side.nodes[k + 1];
            const auto fresh = static_cast<int>(patch.places.size());
            patch.places.push_back(vec(p));
            patch.uv.push_back({0.5 * (patch.uv[at(a)].u + patch.uv[at(b)].u),
                                0.5 * (patch.uv[at(a)].v + patch.uv[at(b)].v)});
            side.nodes.insert(side.nodes.begin() + static_cast<std::ptrdiff_t>(k) + 1, fresh);
            const std::size_t count = patch.triangles.size();
            for (std::size_t i = 0; i < count; ++i) {
                auto one = patch.triangles[i];
                if (std::find(one.begin(), one.end(), a) != one.end() &&
                    std::find(one.begin(), one.end(), b) != one.end()) {
                    auto two = one;
                    std::replace(one.begin(), one.end(), a, fresh);
                    std::replace(two.begin(), two.end(), b, fresh);
                    patch.triangles[i] = one;
                    patch.triangles.push_back(two);
                }
            }
        }
    }
}

// Three segments a loop, and no two edges with a segment between the same two vertices.
void Start::mend() {
    std::map<std::array<std::int32_t, 2>, std::int32_t> single;
    for (std::int32_t e = 1; e <= shape.edges.Extent(); ++e) {
        auto &t = parameters[at(e)];
        if (t.empty()) {
            continue;
        }
        const auto a = shape.vertices.FindIndex(TopExp::FirstVertex(shape.edge(e)));
        const auto b = shape.vertices.FindIndex(TopExp::LastVertex(shape.edge(e)));
        while (a == b && t.size() < 4) {
            std::size_t longest = 0;
            for (std::size_t k = 0; k + 1 < t.size(); ++k) {
                if (t[k + 1] - t[k] > t[longest + 1] - t[longest]) {
                    longest = k;
                }
            }
            halve(e, longest);
        }
        if (t.size() == 2) {
            const auto [other, fresh] = single.try_emplace(ascending(a, b), e);
            if (!fresh) {
                // Either may be straight; both get a point.
                halve(e, 0);
                if (parameters[at(other->second)].size() == 2) {
                    halve(other->second, 0);
                }
            }
        }
    }
}

void Start::build() {
    std::vector<std::int32_t> of_vertex(at(shape.vertices.Extent()) + 1, -1);
    const auto vertex = [&](const TopoDS_Vertex &v) {
        std::int32_t &n = of_vertex[at(shape.vertices.FindIndex(v))];
        if (n < 0) {
            SkinPoint p;
            p.p = vec(BRep_Tool::Pnt(v));
            p.on = {0, shape.vertices.FindIndex(v)};
            p.kept = true;
            n = static_cast<std::int32_t>(mesh.points.size());
            mesh.points.push_back(p);
        }
        return n;
    };
    std::vector<std::vector<std::int32_t>> of_edge(parameters.size());
    for (std::int32_t e = 1; e <= shape.edges.Extent(); ++e) {
        const auto &t = parameters[at(e)];
        if (t.empty()) {
            continue;
        }
        auto &list = of_edge[at(e)];
        list.push_back(vertex(TopExp::FirstVertex(shape.edge(e))));
        for (std::size_t k = 1; k + 1 < t.size(); ++k) {
            SkinPoint p;
            p.t = t[k];
            p.p = vec(mesh.edge(e).curve.Value(t[k]));
            p.on = {1, e};
            list.push_back(static_cast<std::int32_t>(mesh.points.size()));
            mesh.points.push_back(p);
        }
        list.push_back(vertex(TopExp::LastVertex(shape.edge(e))));
        for (std::size_t k = 0; k + 1 < list.size(); ++k) {
            mesh.add_segment(list[k], list[k + 1], e);
            if (k > 0) {
                mesh.points[at(list[k])].previous = list[k - 1];
                mesh.points[at(list[k])].next = list[k + 1];
            }
        }
        mesh.inner[at(e)] = static_cast<int>(list.size()) - 2;
    }
    for (const Patch &patch : patches) {
        std::vector<std::int32_t> number(patch.places.size(), -1);
        for (const auto &side : patch.sides) {
            const TopoDS_Edge edge = shape.edge(side.edge);
            for (std::size_t k = 0; k < side.nodes.size(); ++k) {
                number[at(side.nodes[k])] = BRep_Tool::Degenerated(edge)
                                                ? vertex(TopExp::FirstVertex(edge))
                                                : of_edge[at(side.edge)][k];
            }
        }
        // Vertices inside the face, on none of its edges.
        std::vector<TopoDS_Vertex> inside;
        for (TopoDS_Iterator v(shape.face(patch.face)); v.More(); v.Next()) {
            if (v.Value().ShapeType() == TopAbs_VERTEX) {
                inside.push_back(TopoDS::Vertex(v.Value()));
            }
        }
        for (const TopoDS_Vertex &v : inside) {
            const Vec3 place = vec(BRep_Tool::Pnt(v));
            const double near = std::max(BRep_Tool::Tolerance(v), 1e-7 * mesh.diagonal);
            for (std::size_t n = 0; n < number.size(); ++n) {
                if (number[n] < 0 && distance(patch.places[n], place) <= near) {
                    number[n] = vertex(v);
                    break;
                }
            }
        }
        for (std::size_t n = 0; n < number.size(); ++n) {
            if (number[n] < 0) {
                SkinPoint p;
                p.p = patch.places[n];
                p.uv = patch.uv[n];
                p.on = {2, patch.face};
                number[n] = static_cast<std::int32_t>(mesh.points.size());
                mesh.points.push_back(p);
            }
        }
        for (const auto &t : patch.triangles) {
            const std::array<std::int32_t, 3> p{number[at(t[0])], number[at(t[1])],
                                                number[at(t[2])]};
            if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) {
                mesh.add_triangle(p, patch.face);
            }
        }
    }
    mesh.around.resize(mesh.points.size());
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
        mesh.points[n].alive = !mesh.around[n].empty() || mesh.points[n].on.dimension < 2;
    }
}

// Points of a given division, put into the edges' chains.
void insert_fixed(const CadShape &shape, const Layout &fixed, SkinMesh &mesh) {
    std::vector<std::vector<std::int32_t>> chains(fixed.edges.size());
    for (const auto &[ends, e] : mesh.segments()) {
        if (at(e) >= fixed.edges.size() || fixed.edges[at(e)].empty()) {
            continue;
        }
        mesh.bound[at(e)] = 1;
    }
    for (std::size_t e = 1; e < fixed.edges.size(); ++e) {
        if (mesh.bound[e] == 0) {
            continue;
        }
        const auto edge = static_cast<std::int32_t>(e);
        const auto &list = fixed.edges[e];
        const EdgeGeometry &geometry = mesh.edge(edge);
        double after = geometry.first;
        for (std::size_t k = 1; k + 1 < list.size(); ++k) {
            const Vec3 p = fixed.points[at(list[k])];
            double t = 0;
            gp_Pnt foot;
            ShapeAnalysis_Curve().Project(geometry.curve, {p.x, p.y, p.z}, 1e-9, foot, t,
                                          Standard_False);
            t = std::clamp(t, after, geometry.last);
            after = t;
            // The segment that it falls into, or the point that is there.
            for (const auto &[ends, on] : mesh.segments()) {
                if (on != edge) {
                    continue;
                }
                const auto [ta, tb] = mesh.parameters(ends[0], ends[1], edge);
                const double low = std::min(ta, tb);
                const double high = std::max(ta, tb);
                if (t < low || t > high) {
                    continue;
                }
                const double near = 1e-3 * (high - low);
                std::int32_t n = -1;
                for (const auto &[end, te] : {std::pair{ends[0], ta}, std::pair{ends[1], tb}}) {
                    if (std::abs(te - t) <= near && mesh.points[at(end)].on.dimension == 1) {
                        n = end;
                    }
                }
                if (n < 0) {
                    const std::array<std::int32_t, 2> both = ends;
                    if (!mesh.split(both[0], both[1], 0, true)) {
                        break;
                    }
                    n = static_cast<std::int32_t>(mesh.points.size()) - 1;
                }
                mesh.points[at(n)].t = t;
                mesh.points[at(n)].p = p;
                mesh.points[at(n)].kept = true;
                mesh.points[at(n)].source = list[k];
                break;
            }
        }
    }
    (void)shape;
}

} // namespace

void start_skin(const CadShape &shape, std::span<const int> faces, const SkinOptions &options,
                SkinMesh &mesh, const Progress &progress) {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const int n : faces) {
        builder.Add(compound, shape.face(n));
    }
    Start start{shape, mesh, {}, {}};
    std::string why = "no triangles";
    // What fails at one fineness often works at another.
    for (const double fineness : {1.0, 0.3, 0.1}) {
        start.patches.clear();
        start.parameters.assign(at(shape.edges.Extent()) + 1, {});
        try {
            BRepTools::Clean(compound);
            const BRepMesh_IncrementalMesh mesher(compound, 2e-3 * mesh.diagonal * fineness,
                                                  Standard_False, 0.35 * std::sqrt(fineness),
                                                  Standard_False);
            poll(progress, 0.1);
            for (const int n : faces) {
                start.read(n);
            }
            why.clear();
            break;
        } catch (const Standard_Failure &failure) {
            why = failure.GetMessageString();
        } catch (const GeometryError &) {
            if (fineness == 0.1) {
                throw;
            }
        }
    }
    if (!why.empty()) {
        throw GeometryError("OpenCASCADE cannot triangulate the shape: " + why, {});
    }
    start.mend();
    start.build();
    if (options.fixed != nullptr) {
        insert_fixed(shape, *options.fixed, mesh);
    }
}

} // namespace nmgs::cad
