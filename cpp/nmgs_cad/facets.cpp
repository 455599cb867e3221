// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/facets.h"

#include "nmgs/support/error.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepClass3d.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Lin.hxx>

#include <algorithm>
#include <optional>

namespace nmgs::cad {
namespace {

Vec3 vec(const gp_Pnt &p) {
    return {p.X(), p.Y(), p.Z()};
}

struct Builder {
    const CadShape &shape; // triangulated
    Facets facets;
    std::vector<std::int32_t> vertex_node;             // by vertex number, -1 unused
    std::vector<std::vector<std::int32_t>> edge_nodes; // by edge number, in the curve's sense

    explicit Builder(const CadShape &s)
        : shape(s), vertex_node(static_cast<std::size_t>(s.vertices.Extent()) + 1, -1),
          edge_nodes(static_cast<std::size_t>(s.edges.Extent()) + 1) {}

    std::int32_t add(Vec3 p) {
        facets.points.push_back(p);
        return static_cast<std::int32_t>(facets.points.size()) - 1;
    }
    std::int32_t vertex(const TopoDS_Vertex &v) {
        auto &node = vertex_node[static_cast<std::size_t>(shape.vertices.FindIndex(v))];
        if (node < 0) {
            node = add(vec(BRep_Tool::Pnt(v)));
        }
        return node;
    }
    // Numbers of the nodes of an edge, made by the first face that has it.
    const std::vector<std::int32_t> &edge(const TopoDS_Edge &e,
                                          const Poly_PolygonOnTriangulation &polygon,
                                          const Poly_Triangulation &mesh, const gp_Trsf &move);
    bool face(int n);
};

const std::vector<std::int32_t> &Builder::edge(const TopoDS_Edge &e,
                                               const Poly_PolygonOnTriangulation &polygon,
                                               const Poly_Triangulation &mesh,
                                               const gp_Trsf &move) {
    auto &nodes = edge_nodes[static_cast<std::size_t>(shape.edges.FindIndex(e))];
    if (nodes.empty()) {
        const TopoDS_Edge forward = TopoDS::Edge(e.Oriented(TopAbs_FORWARD));
        const int last = polygon.NbNodes();
        for (int i = 1; i <= last; ++i) {
            if (i == 1 || i == last) {
                nodes.push_back(
                    vertex(i == 1 ? TopExp::FirstVertex(forward) : TopExp::LastVertex(forward)));
            } else {
                nodes.push_back(add(vec(mesh.Node(polygon.Nodes().Value(i)).Transformed(move))));
            }
        }
    }
    return nodes;
}

bool Builder::face(int n) {
    const TopoDS_Face f = shape.face(n);
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(f, location);
    if (mesh.IsNull() || mesh->NbTriangles() == 0) {
        return false;
    }
    const gp_Trsf move = location.Transformation();
    std::vector<std::int32_t> number(static_cast<std::size_t>(mesh->NbNodes()) + 1, -1);
    // A seam is met twice, once in each orientation, each with its own polygon.
    for (TopExp_Explorer it(f.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge e = TopoDS::Edge(it.Current());
        const Handle(Poly_PolygonOnTriangulation) polygon =
            BRep_Tool::PolygonOnTriangulation(e, mesh, location);
        if (polygon.IsNull()) {
            continue;
        }
        if (BRep_Tool::Degenerated(e)) {
            for (int i = 1; i <= polygon->NbNodes(); ++i) {
                number[static_cast<std::size_t>(polygon->Nodes().Value(i))] =
                    vertex(TopExp::FirstVertex(e));
            }
            continue;
        }
        const auto &nodes = edge(e, *polygon, *mesh, move);
        for (int i = 1; i <= polygon->NbNodes() && i <= static_cast<int>(nodes.size()); ++i) {
            number[static_cast<std::size_t>(polygon->Nodes().Value(i))] =
                nodes[static_cast<std::size_t>(i) - 1];
        }
    }
    for (int i = 1; i <= mesh->NbNodes(); ++i) {
        auto &node = number[static_cast<std::size_t>(i)];
        if (node < 0) {
            node = add(vec(mesh->Node(i).Transformed(move)));
        }
    }
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
        int a = 0;
        int b = 0;
        int c = 0;
        mesh->Triangle(t).Get(a, b, c);
        if (f.Orientation() == TopAbs_REVERSED) {
            std::swap(b, c);
        }
        const auto at = [&](int i) { return number[static_cast<std::size_t>(i)]; };
        // At a pole the triangulation has triangles without area.
        if (at(a) != at(b) && at(b) != at(c) && at(c) != at(a)) {
            facets.triangles.push_back({at(a), at(b), at(c)});
            facets.face.push_back(n);
        }
    }
    return true;
}

// The middle of the longest chord of the solid that leaves the largest triangles of its faces at a
// right angle. A short chord may lie between a curved face and its triangles.
std::optional<Vec3> point_inside(const CadShape &shape, const Facets &facets,
                                 const TopoDS_Solid &solid) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(solid, TopAbs_FACE, faces);
    struct Candidate {
        double area;
        Vec3 centre, normal;
    };
    std::vector<Candidate> candidates;
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
        if (!faces.Contains(shape.face(facets.face[t]))) {
            continue;
        }
        const auto [a, b, c] = facets.triangles[t];
        const auto p = [&](std::int32_t n) { return facets.points[static_cast<std::size_t>(n)]; };
        const Vec3 normal = cross(p(b) - p(a), p(c) - p(a));
        candidates.push_back({norm(normal), (1.0 / 3) * (p(a) + p(b) + p(c)), normal});
    }
    constexpr std::size_t tries = 20;
    const std::size_t kept = std::min(tries, candidates.size());
    std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(kept),
                      candidates.end(),
                      [](const Candidate &x, const Candidate &y) { return x.area > y.area; });
    IntCurvesFace_ShapeIntersector intersector;
    intersector.Load(solid, 1e-9 * shape.diagonal());
    BRepClass3d_SolidClassifier classifier(solid);
    const double skin = 1e-6 * shape.diagonal();
    std::optional<Vec3> best;
    double longest = 10 * skin;
    for (std::size_t i = 0; i < kept; ++i) {
        const Candidate &candidate = candidates[i];
        if (candidate.area <= 0) {
            continue;
        }
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 n = (sign / candidate.area) * candidate.normal;
            const gp_Lin line({candidate.centre.x, candidate.centre.y, candidate.centre.z},
                              {n.x, n.y, n.z});
            // The triangle may lie off its curved face: start before it.
            intersector.Perform(line, -skin, RealLast());
            std::vector<double> hits;
            for (int k = 1; intersector.IsDone() && k <= intersector.NbPnt(); ++k) {
                hits.push_back(intersector.WParameter(k));
            }
            hits.push_back(0);
            std::sort(hits.begin(), hits.end());
            for (std::size_t k = 1; k < hits.size(); ++k) {
                if (hits[k] - hits[k - 1] <= longest) {
                    continue;
                }
                const Vec3 p = candidate.centre + 0.5 * (hits[k - 1] + hits[k]) * n;
                classifier.Perform({p.x, p.y, p.z}, skin);
                if (classifier.State() == TopAbs_IN) {
                    best = p;
                    longest = hits[k] - hits[k - 1];
                }
            }
        }
    }
    return best;
}

} // namespace

Facets make_facets(const CadShape &input, double deviation) {
    // A copy: the triangulation is kept in the shape, and the caller's is not to change.
    CadShape shape = make_shape(BRepBuilderAPI_Copy(input.shape, Standard_False).Shape());
    constexpr double angle = 0.35; // radians between neighbouring triangles, at most
    BRepMesh_IncrementalMesh mesher(shape.shape, deviation, Standard_False, angle, Standard_True);

    Builder builder(shape);
    std::vector<std::string> failed;
    for (int n = 1; n <= shape.faces.Extent(); ++n) {
        if (!builder.face(n)) {
            failed.push_back(entity_name(2, n));
        }
    }
    if (!failed.empty()) {
        std::string text = "shape: OpenCASCADE cannot triangulate " + failed.front();
        text += failed.size() > 1 ? " and " + std::to_string(failed.size() - 1) + " more" : "";
        throw GeometryError(text, failed);
    }
    Facets facets = std::move(builder.facets);
    for (int n = 1; n <= shape.solids.Extent(); ++n) {
        const auto inside = point_inside(shape, facets, shape.solid(n));
        if (!inside) {
            throw GeometryError("shape: no point was found inside " + entity_name(3, n),
                                {entity_name(3, n)});
        }
        facets.solid_points.push_back(*inside);
    }
    // A cavity that no solid of the shape fills is a hole.
    for (int n = 1; n <= shape.solids.Extent(); ++n) {
        const TopoDS_Solid solid = shape.solid(n);
        const TopoDS_Shell outer = BRepClass3d::OuterShell(solid);
        for (TopExp_Explorer it(solid, TopAbs_SHELL); it.More(); it.Next()) {
            if (it.Current().IsSame(outer)) {
                continue;
            }
            TopoDS_Solid cavity = BRepBuilderAPI_MakeSolid(TopoDS::Shell(it.Current())).Solid();
            BRepLib::OrientClosedSolid(cavity);
            const auto inside = point_inside(shape, facets, cavity);
            if (!inside) {
                throw GeometryError("shape: no point was found inside a cavity of " +
                                        entity_name(3, n),
                                    {entity_name(3, n)});
            }
            bool filled = false;
            for (int m = 1; m <= shape.solids.Extent() && !filled; ++m) {
                BRepClass3d_SolidClassifier classifier(shape.solid(m));
                classifier.Perform({inside->x, inside->y, inside->z}, 1e-9);
                filled = classifier.State() == TopAbs_IN;
            }
            if (!filled) {
                facets.hole_points.push_back(*inside);
            }
        }
    }
    return facets;
}

} // namespace nmgs::cad
