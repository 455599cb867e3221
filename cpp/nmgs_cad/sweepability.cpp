// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/sweepability.h"

#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/loft_rings.h"
#include "nmgs_cad/midpoint_obstacles.h"
#include "nmgs_cad/occt_vec.h"
#include "nmgs_cad/revolution_axis.h"
#include "nmgs_cad/solid_boundary.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace nmgs::cad {
namespace {

constexpr double angular = 1e-4;
// What comes out of steeper caps is poor, and so is what comes of caps that meet walls in a sharp
// edge or go over into them smoothly: sines of the angles.
constexpr double steepest = 0.3;
constexpr double sharpest = 0.25;

enum class Role { wall, low, high, none };

Role role_of(const std::vector<PointNormal> &samples, Vec3 direction) {
    double least = 2;
    double most = -2;
    for (const auto &[point, normal] : samples) {
        const double along = dot(normal, direction);
        least = std::min(least, along);
        most = std::max(most, along);
    }
    if (std::max(std::abs(least), std::abs(most)) < angular) {
        return Role::wall;
    }
    if (samples.empty() || least * most < 0 ||
        std::min(std::abs(least), std::abs(most)) < steepest) {
        return Role::none;
    }
    return least > 0 ? Role::high : Role::low;
}

std::optional<Vec3> axis_of(const TopoDS_Face &face, const std::vector<PointNormal> &samples) {
    if (samples.empty()) {
        return std::nullopt;
    }
    if (std::all_of(samples.begin(), samples.end(), [&](const PointNormal &s) {
            return norm(cross(s.normal, samples.front().normal)) < angular;
        })) {
        return samples.front().normal;
    }
    const BRepAdaptor_Surface surface(face, Standard_False);
    switch (surface.GetType()) {
    case GeomAbs_Cylinder:
        return vec(surface.Cylinder().Axis().Direction().XYZ());
    case GeomAbs_Cone:
        return vec(surface.Cone().Axis().Direction().XYZ());
    default:
        break;
    }
    // The direction that all normals are square to, if there is one.
    for (const PointNormal &s : samples) {
        const Vec3 n = cross(samples.front().normal, s.normal);
        if (norm(n) > 0.2) {
            const Vec3 axis = unit(n);
            const bool all = std::all_of(samples.begin(), samples.end(), [&](const PointNormal &t) {
                return std::abs(dot(t.normal, axis)) < angular;
            });
            return all ? std::optional<Vec3>(axis) : std::nullopt;
        }
    }
    return std::nullopt;
}

bool askew(const TopoDS_Edge &edge, Vec3 direction, double tolerance) {
    const BRepAdaptor_Curve curve(edge);
    const double a = curve.FirstParameter();
    const double b = curve.LastParameter();
    const Vec3 start = vec(curve.Value(a).XYZ());
    bool along = true;
    bool across = true;
    for (int i = 1; i <= 4; ++i) {
        const Vec3 p = vec(curve.Value(a + (b - a) * i / 4).XYZ()) - start;
        along = along && norm(cross(p, direction)) <= 2 * tolerance;
        across = across && std::abs(dot(p, direction)) <= 2 * tolerance;
    }
    return !along && !across;
}

Vec3 normal_on(const TopoDS_Face &face, const TopoDS_Edge &edge, double parameter) {
    double first = 0;
    double last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull()) {
        return {};
    }
    const gp_Pnt2d uv = curve->Value(parameter);
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    BRepAdaptor_Surface(face, Standard_False).D1(uv.X(), uv.Y(), p, du, dv);
    const gp_Vec n = du.Crossed(dv);
    return n.Magnitude() > 0 ? (1 / n.Magnitude()) * vec(n.XYZ()) : Vec3{};
}

// Whether two faces meet in a knife edge, or without one, anywhere along their edge.
bool sharp_or_smooth(const TopoDS_Edge &edge, const TopoDS_Face &a, const TopoDS_Face &b) {
    double first = 0;
    double last = 0;
    BRep_Tool::Range(edge, first, last);
    for (const double t : {0.02, 0.25, 0.5, 0.75, 0.98}) {
        const double parameter = (1 - t) * first + t * last;
        const Vec3 n = normal_on(a, edge, parameter);
        const Vec3 m = normal_on(b, edge, parameter);
        if (norm2(n) > 0 && norm2(m) > 0 && norm(cross(n, m)) < sharpest) {
            return true;
        }
    }
    return false;
}

// Whether the wall has no height at some vertex: two of its edges go off to the same side there.
bool pinched(const TopoDS_Face &wall, Vec3 along) {
    TopTools_IndexedDataMapOfShapeListOfShape edges_at;
    TopExp::MapShapesAndAncestors(wall, TopAbs_VERTEX, TopAbs_EDGE, edges_at);
    for (int v = 1; v <= edges_at.Extent(); ++v) {
        std::vector<Vec3> out;
        for (const TopoDS_Shape &shape : edges_at(v)) {
            const TopoDS_Edge edge = TopoDS::Edge(shape);
            double first = 0;
            double last = 0;
            BRep_Tool::Range(edge, first, last);
            const bool starts = TopExp::FirstVertex(edge).IsSame(edges_at.FindKey(v));
            if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, wall) ||
                TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge))) {
                continue;
            }
            const Vec3 t = tangent_at(edge, starts ? first : last);
            const Vec3 side = (starts ? 1.0 : -1.0) * (t - dot(t, along) * along);
            if (norm(side) > 0.1) {
                out.push_back(side);
            }
        }
        for (std::size_t i = 1; i < out.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (dot(out[i], out[j]) > 0 && out.size() == 2) {
                    return true;
                }
            }
        }
    }
    return false;
}

} // namespace

Sweepability sweepability(const CadShape &shape, int solid) {
    Sweepability result;
    Refusal refusal;
    constexpr int hopeless = 100;
    if (!boundary_of(shape, solid, refusal)) {
        result.cost = hopeless; // no strategy knows inside from outside there
        return result;
    }
    const Obstacles obstacles = obstacles_of(shape, solid);
    const int cusps = static_cast<int>(obstacles.cusps.size()); // no strategy makes good of them
    if (obstacles.weight == 0 || revolution_axis(shape, solid, refusal) ||
        loft_rings(shape, solid)) {
        result.cost = cusps;
        return result;
    }
    std::map<int, std::vector<PointNormal>> samples;
    std::map<int, std::vector<int>> faces_of; // an edge's
    std::vector<std::pair<int, Vec3>> found;
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        const int n = shape.faces.FindIndex(face);
        samples[n] = sample_normals(face);
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(face, TopAbs_EDGE, edges);
        for (int e = 1; e <= edges.Extent(); ++e) {
            if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(e)))) {
                faces_of[shape.edges.FindIndex(edges(e))].push_back(n);
            }
        }
        const auto axis = axis_of(face, samples[n]);
        if (!axis) {
            continue;
        }
        const auto known = std::find_if(found.begin(), found.end(), [&](const auto &f) {
            return norm(cross(f.second, *axis)) < angular;
        });
        if (known == found.end()) {
            found.emplace_back(1, *axis);
        } else {
            ++known->first;
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto &a, const auto &b) { return a.first > b.first; });
    constexpr std::size_t most_directions = 8;
    found.resize(std::min(found.size(), most_directions));
    const double tolerance = 1e-5 * extent_of(shape.solid(solid));
    for (const auto &[count, along] : found) {
        SweepDirection direction;
        direction.along = along;
        std::map<int, Role> roles;
        for (const auto &[n, list] : samples) {
            roles[n] = role_of(list, along);
            if (roles[n] == Role::none) {
                direction.faces.insert(n);
            }
        }
        for (const auto &[n, list] : samples) {
            if (roles[n] == Role::wall && pinched(shape.face(n), along)) {
                direction.faces.insert(n);
            }
        }
        for (const auto &[edge, faces] : faces_of) {
            if (faces.size() == 2 &&
                (roles[faces[0]] == Role::wall) != (roles[faces[1]] == Role::wall) &&
                roles[faces[0]] != Role::none && roles[faces[1]] != Role::none &&
                sharp_or_smooth(shape.edge(edge), shape.face(faces[0]), shape.face(faces[1]))) {
                direction.faces.insert(roles[faces[0]] == Role::wall ? faces[1] : faces[0]);
            }
            bool walls = true;
            bool low = false;
            bool high = false;
            for (const int f : faces) {
                walls = walls && roles[f] == Role::wall;
                low = low || roles[f] == Role::low;
                high = high || roles[f] == Role::high;
            }
            if (low && high) {
                direction.faces.insert(faces.begin(), faces.end());
            } else if (walls && askew(shape.edge(edge), along, tolerance)) {
                ++direction.edges;
            }
        }
        result.directions.push_back(std::move(direction));
    }
    std::stable_sort(
        result.directions.begin(), result.directions.end(),
        [](const SweepDirection &a, const SweepDirection &b) { return a.cost() < b.cost(); });
    result.cost = cusps + (result.directions.empty() ? hopeless : result.directions.front().cost());
    return result;
}

} // namespace nmgs::cad
