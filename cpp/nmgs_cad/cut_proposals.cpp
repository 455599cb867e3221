// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut_proposals.h"

#include "nmgs_cad/solid_boundary.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GProp_PrincipalProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace nmgs::cad {
namespace {

gp_Pnt centre_of(const TopoDS_Shape &shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, Standard_False);
    const gp_Pnt a = box.CornerMin();
    const gp_Pnt b = box.CornerMax();
    return {0.5 * (a.X() + b.X()), 0.5 * (a.Y() + b.Y()), 0.5 * (a.Z() + b.Z())};
}

// The planes and cylinders that come into question, each once.
struct Proposer {
    const CadShape &cad;
    double tolerance;
    std::vector<Cut> cuts;

    explicit Proposer(const CadShape &c) : cad(c), tolerance(1e-4 * diagonal_of(c.shape)) {}

    void add(Cut cut) {
        for (const Cut &known : cuts) {
            if (same(known, cut, tolerance)) {
                return;
            }
        }
        cuts.push_back(std::move(cut));
    }
    void plane(const gp_Pnt &p, const gp_Dir &normal, const std::string &name,
               std::vector<std::string> entities) {
        Cut cut;
        cut.place = gp_Ax3(p, normal);
        cut.name = name;
        cut.entities = std::move(entities);
        add(std::move(cut));
    }
    void of_face(int face);
    void of_edge(int edge, bool flat, const std::vector<int> &faces);
    void of_round_face(int face, const std::vector<std::pair<double, gp_Dir>> &sides);
    void of_vertex(int vertex, const std::vector<int> &edges);
    void symmetry(int solid);
};

// The plane or cylinder that a face lies on.
void Proposer::of_face(int face) {
    const BRepAdaptor_Surface surface(cad.face(face), Standard_False);
    const std::string name = entity_name(2, face);
    if (surface.GetType() == GeomAbs_Plane) {
        const gp_Pln pln = surface.Plane();
        plane(pln.Location(), pln.Axis().Direction(), "plane of " + name, {name});
    }
    if (surface.GetType() == GeomAbs_Cylinder) {
        Cut cut;
        cut.cylinder = true;
        cut.place = surface.Cylinder().Position();
        cut.radius = surface.Cylinder().Radius();
        cut.name = "cylinder of " + name;
        cut.entities = {name};
        add(cut);
    }
}

void Proposer::of_edge(int edge, bool flat, const std::vector<int> &faces) {
    const BRepAdaptor_Curve curve(cad.edge(edge));
    const double middle = 0.5 * (curve.FirstParameter() + curve.LastParameter());
    gp_Pnt p;
    gp_Vec t;
    curve.D1(middle, p, t);
    const std::string name = entity_name(1, edge);
    if (curve.GetType() == GeomAbs_Circle) {
        const gp_Circ circle = curve.Circle();
        plane(circle.Location(), circle.Axis().Direction(), "plane of " + name, {name});
        Cut cut;
        cut.cylinder = true;
        cut.place = gp_Ax3(circle.Position());
        cut.radius = circle.Radius();
        cut.name = "cylinder through " + name;
        cut.entities = {name};
        add(cut);
    } else if (curve.GetType() == GeomAbs_Ellipse) {
        plane(p, curve.Ellipse().Axis().Direction(), "plane of " + name, {name});
    } else if (curve.GetType() != GeomAbs_Line) {
        // A plane curve of another kind: by three points.
        const gp_Pnt a = curve.Value(curve.FirstParameter());
        const gp_Pnt b = curve.Value(0.3 * curve.FirstParameter() + 0.7 * curve.LastParameter());
        const gp_Vec n = gp_Vec(a, p).Crossed(gp_Vec(a, b));
        if (n.Magnitude() > tolerance * gp_Vec(a, p).Magnitude()) {
            plane(p, gp_Dir(n), "plane of " + name, {name});
        }
    }
    for (const int f : faces) {
        const BRepAdaptor_Surface surface(cad.face(f), Standard_False);
        const std::string face = entity_name(2, f);
        if (!flat) {
            of_face(f);
        }
        if (curve.GetType() == GeomAbs_Line && t.Magnitude() > 0) {
            double first = 0;
            double last = 0;
            const Handle(Geom2d_Curve) parameters =
                BRep_Tool::CurveOnSurface(cad.edge(edge), cad.face(f), first, last);
            if (parameters.IsNull()) {
                continue;
            }
            const gp_Pnt2d uv = parameters->Value(0.5 * (first + last));
            gp_Pnt q;
            gp_Vec du;
            gp_Vec dv;
            surface.D1(uv.X(), uv.Y(), q, du, dv);
            const gp_Vec n = du.Crossed(dv);
            if (n.Magnitude() > 0 && n.Crossed(t).Magnitude() > 1e-9 * n.Magnitude()) {
                // Across the face, and along its tangent.
                std::string where = face; // face and edge
                where.append(" at ").append(name);
                plane(p, gp_Dir(n.Crossed(t)), "plane across " + where, {face, name});
                if (!flat) {
                    plane(p, gp_Dir(n), "tangent plane of " + where, {face, name});
                }
            }
        }
    }
}

// Planes through the axis of a round face: along its seam or along the largest flat side, and
// across.
void Proposer::of_round_face(int face, const std::vector<std::pair<double, gp_Dir>> &sides) {
    const BRepAdaptor_Surface surface(cad.face(face), Standard_False);
    gp_Ax3 place;
    switch (surface.GetType()) {
    case GeomAbs_Cylinder:
        place = surface.Cylinder().Position();
        break;
    case GeomAbs_Cone:
        place = surface.Cone().Position();
        break;
    case GeomAbs_Sphere:
        place = surface.Sphere().Position();
        break;
    case GeomAbs_Torus:
        place = surface.Torus().Position();
        break;
    case GeomAbs_SurfaceOfRevolution: {
        const gp_Ax1 axis = surface.AxeOfRevolution();
        place = gp_Ax3(axis.Location(), axis.Direction());
        break;
    }
    default:
        return;
    }
    const gp_Dir axis = place.Direction();
    std::optional<gp_Dir> along;
    for (TopExp_Explorer it(cad.face(face), TopAbs_EDGE); it.More() && !along; it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        if (!BRep_Tool::Degenerated(edge) && BRep_Tool::IsClosed(edge, cad.face(face))) {
            const BRepAdaptor_Curve seam(edge);
            const gp_Vec out(place.Location(),
                             seam.Value(0.6 * seam.FirstParameter() + 0.4 * seam.LastParameter()));
            const gp_Vec across = out - out.Dot(gp_Vec(axis)) * gp_Vec(axis);
            if (across.Magnitude() > tolerance) {
                along = gp_Dir(across);
            }
        }
    }
    for (const auto &[area, normal] : sides) {
        if (!along && std::abs(normal.Dot(axis)) < 1e-3) {
            along = normal;
        }
    }
    const gp_Dir u = along ? gp_Dir(axis.Crossed(*along)) : place.YDirection();
    const std::string name = entity_name(2, face);
    plane(place.Location(), u, "plane through the axis of " + name, {name});
    plane(place.Location(), axis.Crossed(u), "plane across through the axis of " + name, {name});
    if (surface.GetType() == GeomAbs_Sphere || surface.GetType() == GeomAbs_Torus) {
        plane(place.Location(), axis, "equator of " + name, {name});
    }
}

// Planes through two edges that meet at a vertex.
void Proposer::of_vertex(int vertex, const std::vector<int> &edges) {
    const gp_Pnt p = BRep_Tool::Pnt(cad.vertex(vertex));
    std::vector<Vec3> out;
    for (const int e : edges) {
        const TopoDS_Edge edge = cad.edge(e);
        double first = 0;
        double last = 0;
        BRep_Tool::Range(edge, first, last);
        const bool starts = TopExp::FirstVertex(edge).IsSame(cad.vertex(vertex));
        const Vec3 t = tangent_at(edge, starts ? first : last);
        out.push_back(starts ? t : -1.0 * t);
    }
    constexpr std::size_t most = 6;
    for (std::size_t i = 0; i < std::min(most, out.size()); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3 n = cross(out[i], out[j]);
            if (norm(n) > 0.1) {
                plane(p, gp_Dir(n.x, n.y, n.z),
                      "plane of " + entity_name(1, edges[i]) + " and " + entity_name(1, edges[j]),
                      {entity_name(1, edges[i]), entity_name(1, edges[j])});
            }
        }
    }
}

void Proposer::symmetry(int solid) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(cad.solid(solid), properties);
    const GProp_PrincipalProps principal = properties.PrincipalProperties();
    const gp_Pnt centre = properties.CentreOfMass();
    const std::string name = entity_name(3, solid);
    for (const gp_Vec &axis : {principal.FirstAxisOfInertia(), principal.SecondAxisOfInertia(),
                               principal.ThirdAxisOfInertia()}) {
        plane(centre, gp_Dir(axis), "middle plane of " + name, {name});
    }
}

double signed_distance(const Cut &cut, const gp_Pnt &p) {
    const gp_XYZ apart = p.XYZ() - cut.place.Location().XYZ();
    const gp_XYZ n = cut.place.Direction().XYZ();
    return cut.cylinder ? apart.Crossed(n).Modulus() - cut.radius : apart.Dot(n);
}
double distance_from(const Cut &cut, const gp_Pnt &p) {
    return std::abs(signed_distance(cut, p));
}

bool contains(const CadShape &cad, int edge, const Cut &cut, double tolerance) {
    const BRepAdaptor_Curve curve(cad.edge(edge));
    for (const double t : {0.0, 0.31, 0.62, 1.0}) {
        const double at = (1 - t) * curve.FirstParameter() + t * curve.LastParameter();
        if (distance_from(cut, curve.Value(at)) > tolerance) {
            return false;
        }
    }
    return true;
}

bool through_centre(const CadShape &cad, int edge, const Cut &cut, double tolerance) {
    const BRepAdaptor_Curve curve(cad.edge(edge));
    return curve.GetType() == GeomAbs_Circle && !cut.cylinder &&
           distance_from(cut, curve.Circle().Location()) < tolerance &&
           std::abs(curve.Circle().Axis().Direction().Dot(cut.place.Direction())) < 1e-3;
}

// Points all over the edges of a solid.
std::vector<gp_Pnt> points_of(const CadShape &cad, int solid) {
    std::vector<gp_Pnt> points;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(cad.solid(solid), TopAbs_EDGE, edges);
    for (int e = 1; e <= edges.Extent(); ++e) {
        if (BRep_Tool::Degenerated(TopoDS::Edge(edges(e)))) {
            continue;
        }
        const BRepAdaptor_Curve curve(TopoDS::Edge(edges(e)));
        const int steps = curve.GetType() == GeomAbs_Line ? 2 : 8;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            points.push_back(
                curve.Value((1 - t) * curve.FirstParameter() + t * curve.LastParameter()));
        }
    }
    return points;
}

// Whether the cut has points on both its sides; one that only touches cuts nothing.
bool divides(const Cut &cut, const std::vector<gp_Pnt> &points, double tolerance) {
    bool below = false;
    bool above = false;
    for (const gp_Pnt &p : points) {
        const double side = signed_distance(cut, p);
        below = below || side < -tolerance;
        above = above || side > tolerance;
        if (below && above) {
            return true;
        }
    }
    return false;
}

} // namespace

double diagonal_of(const TopoDS_Shape &shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, Standard_False);
    return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

bool same(const Cut &a, const Cut &b, double tolerance) {
    if (a.cylinder != b.cylinder) {
        return false;
    }
    const gp_Dir n = a.place.Direction();
    if (n.XYZ().Crossed(b.place.Direction().XYZ()).Modulus() > 1e-4) {
        return false;
    }
    const gp_XYZ apart = b.place.Location().XYZ() - a.place.Location().XYZ();
    return a.cylinder ? std::abs(a.radius - b.radius) < tolerance &&
                            apart.Crossed(n.XYZ()).Modulus() < tolerance
                      : std::abs(apart.Dot(n.XYZ())) < tolerance;
}

Proposals candidates(const CadShape &cad, const std::vector<int> &solids,
                     const std::vector<Obstacles> &obstacles) {
    Proposer proposer(cad);
    std::vector<std::pair<double, gp_Dir>> sides;
    for (int f = 1; f <= cad.faces.Extent(); ++f) {
        const BRepAdaptor_Surface surface(cad.face(f), Standard_False);
        if (surface.GetType() == GeomAbs_Plane) {
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(cad.face(f), properties);
            sides.emplace_back(properties.Mass(), surface.Plane().Axis().Direction());
        }
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const auto &a, const auto &b) { return a.first > b.first * (1 + 1e-9); });
    for (std::size_t s = 0; s < solids.size(); ++s) {
        for (const int face : obstacles[s].inner) {
            proposer.of_face(face);
        }
        Refusal refusal;
        const auto boundary = boundary_of(cad, solids[s], refusal);
        if (!boundary) {
            continue;
        }
        std::map<int, std::vector<int>> faces_of;
        std::map<int, double> dihedral;
        std::map<int, std::vector<int>> edges_at;
        for (const Coedge &c : boundary->coedges) {
            if (c.degenerated) {
                continue;
            }
            faces_of[c.edge].push_back(boundary->faces[static_cast<std::size_t>(c.face)]);
            dihedral[c.edge] = c.dihedral;
            for (const int v :
                 {c.vertex, boundary->coedges[static_cast<std::size_t>(c.next)].vertex}) {
                auto &list = edges_at[v];
                if (std::find(list.begin(), list.end(), c.edge) == list.end()) {
                    list.push_back(c.edge);
                }
            }
        }
        for (const int e : obstacles[s].edges) {
            proposer.of_edge(e, std::abs(dihedral[e] - std::numbers::pi) < least_angle,
                             faces_of[e]);
        }
        for (const int f : obstacles[s].round) {
            proposer.of_round_face(f, sides);
        }
        for (const int v : obstacles[s].vertices) {
            if (edges_at[v].size() > 3) {
                proposer.of_vertex(v, edges_at[v]);
            }
        }
        proposer.symmetry(solids[s]);
    }
    // Which edges and vertices (negative) lie on which cut, of solids that it divides.
    std::vector<std::vector<gp_Pnt>> points;
    std::set<int> open;
    for (std::size_t s = 0; s < solids.size(); ++s) {
        points.push_back(points_of(cad, solids[s]));
        open.insert(obstacles[s].edges.begin(), obstacles[s].edges.end());
        for (const int v : obstacles[s].vertices) {
            open.insert(-v);
        }
    }
    std::vector<std::set<int>> on(proposer.cuts.size());
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t c = 0; c < proposer.cuts.size(); ++c) {
        Cut &cut = proposer.cuts[c];
        for (std::size_t s = 0; s < solids.size(); ++s) {
            if (!divides(cut, points[s], proposer.tolerance)) {
                continue;
            }
            for (const int e : obstacles[s].edges) {
                if (contains(cad, e, cut, proposer.tolerance) ||
                    through_centre(cad, e, cut, proposer.tolerance)) {
                    on[c].insert(e);
                }
            }
            for (const int v : obstacles[s].vertices) {
                if (distance_from(cut, BRep_Tool::Pnt(cad.vertex(v))) < proposer.tolerance) {
                    on[c].insert(-v);
                }
            }
        }
        cut.resolves = static_cast<int>(on[c].size());
        order.emplace_back(-cut.resolves + (cut.cylinder ? 0.5 : 0.0), c);
    }
    std::sort(order.begin(), order.end());
    Proposals result;
    for (const auto &[gain, c] : order) {
        if (proposer.cuts[c].resolves > 0) {
            result.cuts.push_back(proposer.cuts[c]);
        }
    }
    while (!open.empty()) {
        std::size_t best = on.size();
        std::size_t most = 0;
        for (std::size_t c = 0; c < on.size(); ++c) {
            std::size_t count = 0;
            for (const int n : on[c]) {
                count += open.count(n);
            }
            if (count > most) {
                most = count;
                best = c;
            }
        }
        if (best == on.size()) {
            break;
        }
        for (const int n : on[best]) {
            open.erase(n);
        }
        result.cover.push_back(proposer.cuts[best]);
    }
    result.all = open.empty();
    result.needed = static_cast<int>(result.cover.size() + open.size());
    for (const Obstacles &o : obstacles) {
        result.needed += static_cast<int>(o.cusps.size());
        result.all = result.all && o.cusps.empty();
    }
    return result;
}

std::vector<Cut> propose_cuts(const CadShape &shape, int solid) {
    return candidates(shape, {solid}, {obstacles_of(shape, solid)}).cuts;
}

TopoDS_Face cut_face(const CadShape &shape, const Cut &cut) {
    const double reach = 1.1 * diagonal_of(shape.shape);
    const gp_Pnt centre = centre_of(shape.shape);
    const gp_XYZ apart = centre.XYZ() - cut.place.Location().XYZ();
    const gp_XYZ n = cut.place.Direction().XYZ();
    gp_Ax3 place = cut.place;
    if (cut.cylinder) {
        place.SetLocation(gp_Pnt(cut.place.Location().XYZ() + apart.Dot(n) * n));
        return BRepBuilderAPI_MakeFace(gp_Cylinder(place, cut.radius), 0.0, 2 * std::numbers::pi,
                                       -reach, reach)
            .Face();
    }
    place.SetLocation(gp_Pnt(centre.XYZ() - apart.Dot(n) * n));
    return BRepBuilderAPI_MakeFace(gp_Pln(place), -reach, reach, -reach, reach).Face();
}

} // namespace nmgs::cad
