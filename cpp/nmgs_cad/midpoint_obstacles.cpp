// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/midpoint_obstacles.h"

#include "nmgs_cad/solid_boundary.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Pln.hxx>

#include <array>
#include <cmath>
#include <map>

namespace nmgs::cad {
namespace {

bool sharp(double angle) {
    return angle > least_angle && angle < std::numbers::pi - least_angle;
}

// Whether the mid-point subdivision of a plane face has a fold, or nearly: its middle does not see
// all its sides well. Adds the sides that bend into the face, and the faces there.
bool awkward(const CadShape &cad, const SolidBoundary &boundary, std::size_t face,
             Obstacles &result) {
    const TopoDS_Face f = cad.face(boundary.faces[face]);
    const BRepAdaptor_Surface surface(f, Standard_False);
    if (surface.GetType() != GeomAbs_Plane || boundary.loops[face].size() != 1) {
        return false;
    }
    const gp_Dir axis = surface.Plane().Axis().Direction();
    const bool turned = (f.Orientation() == TopAbs_REVERSED) != (boundary.reversed[face] != 0);
    Vec3 normal = (turned ? -1.0 : 1.0) * Vec3{axis.X(), axis.Y(), axis.Z()};
    if (!surface.Plane().Direct()) {
        normal = -1.0 * normal;
    }
    std::vector<Vec3> corners;
    std::vector<Vec3> middles;
    std::vector<Coedge> inward;
    Vec3 centre{0, 0, 0};
    int at = boundary.loops[face].front();
    do {
        const Coedge &c = boundary.coedges[static_cast<std::size_t>(at)];
        const BRepAdaptor_Curve curve(cad.edge(c.edge));
        gp_Pnt p;
        gp_Vec t;
        gp_Vec bend;
        curve.D2(0.5 * (curve.FirstParameter() + curve.LastParameter()), p, t, bend);
        middles.push_back({p.X(), p.Y(), p.Z()});
        centre += middles.back();
        corners.push_back(cad.point(c.vertex));
        const Vec3 along = (c.forward ? 1.0 : -1.0) * Vec3{t.X(), t.Y(), t.Z()};
        if (dot(Vec3{bend.X(), bend.Y(), bend.Z()}, cross(normal, along)) < -1e-9 * norm2(along)) {
            inward.push_back(c);
        }
        at = c.next;
    } while (at != boundary.loops[face].front());
    const std::size_t n = corners.size();
    if (n < 3) {
        return false;
    }
    centre = (1.0 / static_cast<double>(n)) * centre;
    constexpr double least = 0.15; // sine of an angle of a quad
    for (std::size_t i = 0; i < n; ++i) {
        const std::array<Vec3, 4> q{corners[i], middles[i], centre, middles[(i + n - 1) % n]};
        for (std::size_t k = 1; k < 4; ++k) { // the corner itself is the face's
            const Vec3 a = q[(k + 1) % 4] - q[k];
            const Vec3 b = q[(k + 3) % 4] - q[k];
            if (dot(normal, cross(a, b)) < least * norm(a) * norm(b)) {
                for (const Coedge &c : inward) {
                    const Coedge &mate = boundary.coedges[static_cast<std::size_t>(c.mate)];
                    result.edges.insert(c.edge);
                    result.round.insert(boundary.faces[static_cast<std::size_t>(mate.face)]);
                }
                return true;
            }
        }
    }
    return false;
}

} // namespace

Obstacles obstacles_of(const CadShape &cad, int solid) {
    Obstacles result;
    Refusal refusal;
    const auto boundary = boundary_of(cad, solid, refusal);
    if (!boundary) {
        result.weight = 10;
        for (const auto &[face, bounds] : solid_faces(cad, solid)) {
            if (!bounds) {
                result.inner.insert(face);
            }
        }
        for (const int face : result.inner) {
            for (TopExp_Explorer it(cad.face(face), TopAbs_EDGE); it.More(); it.Next()) {
                result.edges.insert(cad.edges.FindIndex(it.Current()));
            }
        }
        return result;
    }
    std::map<int, std::set<int>> edges_at;
    for (std::size_t i = 0; i < boundary->coedges.size(); ++i) {
        const Coedge &c = boundary->coedges[i];
        const int face = boundary->faces[static_cast<std::size_t>(c.face)];
        if (c.degenerated) {
            continue; // a pole is a vertex like others
        }
        edges_at[c.vertex].insert(c.edge);
        const auto &next = boundary->coedges[static_cast<std::size_t>(c.next)];
        edges_at[next.vertex].insert(c.edge);
        if (!sharp(c.corner)) {
            result.weight += 0.5;
        }
        if (c.next == c.prev) { // two edges: the blocks at its middle would be flat
            result.weight += 0.5;
            result.round.insert(face);
            if (BRepAdaptor_Curve(cad.edge(c.edge)).GetType() != GeomAbs_Line) {
                result.edges.insert(c.edge);
            }
        }
        const bool closed = c.next == static_cast<int>(i) || next.vertex == c.vertex;
        if (closed) {
            result.weight += 1;
            result.edges.insert(c.edge);
            result.round.insert(face);
        }
        if (boundary->seam(static_cast<int>(i))) {
            result.weight += 0.5;
            result.edges.insert(c.edge);
            result.round.insert(face);
        } else if (c.dihedral < least_angle || c.dihedral > 2 * std::numbers::pi - least_angle) {
            result.weight += 1;
            result.cusps.insert(c.edge);
        } else if (!sharp(c.dihedral)) {
            result.weight += c.dihedral > std::numbers::pi ? 1 : 0.5;
            result.edges.insert(c.edge);
        }
    }
    for (std::size_t f = 0; f < boundary->faces.size(); ++f) {
        if (boundary->loops[f].size() != 1) {
            result.weight += 1;
            result.round.insert(boundary->faces[f]);
        } else if (awkward(cad, *boundary, f, result)) {
            result.weight += 1;
            ++result.awkward;
        }
    }
    for (const auto &[vertex, edges] : edges_at) {
        if (edges.size() != 3) {
            result.weight += std::abs(static_cast<double>(edges.size()) - 3);
            result.vertices.insert(vertex);
        }
    }
    int shells = 0;
    for (TopExp_Explorer it(cad.solid(solid), TopAbs_SHELL); it.More(); it.Next()) {
        ++shells;
    }
    result.weight += shells - 1;
    return result;
}

} // namespace nmgs::cad
