// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/sweepability.h"

#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/loft_rings.h"
#include "nmgs_cad/midpoint_obstacles.h"
#include "nmgs_cad/occt_vec.h"
#include "nmgs_cad/revolution_axis.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
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
constexpr double steepest = 0.15; // as sweeps over slopes have it

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

} // namespace

Sweepability sweepability(const CadShape &shape, int solid) {
    Sweepability result;
    Refusal refusal;
    if (obstacles_of(shape, solid).weight == 0 || revolution_axis(shape, solid, refusal) ||
        loft_rings(shape, solid)) {
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
        for (const auto &[edge, faces] : faces_of) {
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
    result.cost = result.directions.empty() ? 100 : result.directions.front().cost();
    return result;
}

} // namespace nmgs::cad
