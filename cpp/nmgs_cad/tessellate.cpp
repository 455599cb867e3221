// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/tessellate.h"

#include "nmgs/support/error.h"
#include "nmgs_cad/inner_points.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <map>
#include <utility>

namespace nmgs::cad {
namespace {

struct Gatherer {
    const CadShape &shape;
    Tessellation &result;
    std::vector<std::int32_t> of_vertex;                   // point of VertexN at n, or -1
    std::map<std::pair<int, int>, std::int32_t> of_edge{}; // point of (EdgeN, place on it)

    std::int32_t add(Vec3 p) {
        result.points.push_back(p);
        return static_cast<std::int32_t>(result.points.size()) - 1;
    }

    std::int32_t vertex_point(const TopoDS_Vertex &vertex) {
        std::int32_t &point = of_vertex[static_cast<std::size_t>(shape.vertices.FindIndex(vertex))];
        if (point < 0) {
            point = add(vec(BRep_Tool::Pnt(vertex)));
        }
        return point;
    }

    // Points of the nodes of a face's triangulation that lie on one of its edges.
    void edge_points(const TopoDS_Edge &edge, const Handle(Poly_Triangulation) & mesh,
                     const TopLoc_Location &place, std::vector<std::int32_t> &points) {
        const Handle(Poly_PolygonOnTriangulation) line =
            BRep_Tool::PolygonOnTriangulation(edge, mesh, place);
        if (line.IsNull()) {
            return;
        }
        const auto forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
        const std::int32_t begin = vertex_point(TopExp::FirstVertex(forward));
        const std::int32_t end = vertex_point(TopExp::LastVertex(forward));
        const int number = shape.edges.FindIndex(edge);
        const int count = line->NbNodes();
        const bool pole = BRep_Tool::Degenerated(edge);
        for (int k = 1; k <= count; ++k) {
            const int node = line->Nodes().Value(k);
            std::int32_t &point = points[static_cast<std::size_t>(node)];
            if (k == 1 || pole) {
                point = begin;
            } else if (k == count) {
                point = end;
            } else {
                const auto [at, fresh] = of_edge.try_emplace({number, k}, 0);
                if (fresh) {
                    at->second = add(vec(mesh->Node(node).Transformed(place.Transformation())));
                }
                point = at->second;
            }
        }
    }

    void face(int number) {
        const TopoDS_Face face = shape.face(number);
        TopLoc_Location place;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
        if (mesh.IsNull()) {
            throw GeometryError("OpenCASCADE cannot triangulate " + entity_name(2, number),
                                {entity_name(2, number)});
        }
        std::vector<std::int32_t> points(static_cast<std::size_t>(mesh->NbNodes()) + 1, -1);
        for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
            edge_points(TopoDS::Edge(at.Current()), mesh, place, points);
        }
        for (int n = 1; n <= mesh->NbNodes(); ++n) {
            std::int32_t &point = points[static_cast<std::size_t>(n)];
            if (point < 0) {
                point = add(vec(mesh->Node(n).Transformed(place.Transformation())));
            }
        }
        const bool reversed = face.Orientation() == TopAbs_REVERSED;
        for (int t = 1; t <= mesh->NbTriangles(); ++t) {
            int a = 0;
            int b = 0;
            int c = 0;
            mesh->Triangle(t).Get(a, b, c);
            if (reversed) {
                std::swap(b, c);
            }
            const std::array<std::int32_t, 3> nodes{points[static_cast<std::size_t>(a)],
                                                    points[static_cast<std::size_t>(b)],
                                                    points[static_cast<std::size_t>(c)]};
            // At a pole a side of the parameter plane is one point.
            if (nodes[0] != nodes[1] && nodes[1] != nodes[2] && nodes[2] != nodes[0]) {
                result.triangles.push_back(nodes);
                result.faces.push_back(number);
            }
        }
    }
};

} // namespace

Tessellation tessellate(const CadShape &shape, double deviation, double angle,
                        const Progress &progress) {
    poll(progress, 0);
    try {
        BRepMesh_IncrementalMesh(shape.shape, deviation, Standard_False, angle, Standard_False);
    } catch (const Standard_Failure &failure) {
        throw GeometryError(std::string("OpenCASCADE cannot triangulate the shape: ") +
                                failure.GetMessageString(),
                            {});
    }
    poll(progress, 0.7);
    Tessellation result;
    const auto vertices = static_cast<std::size_t>(shape.vertices.Extent());
    Gatherer gatherer{shape, result, std::vector<std::int32_t>(vertices + 1, -1)};
    for (int n = 1; n <= shape.faces.Extent(); ++n) {
        gatherer.face(n);
        poll(progress, 0.7 + 0.1 * n / shape.faces.Extent());
    }
    add_inner_points(shape, result, progress);
    return result;
}

} // namespace nmgs::cad
