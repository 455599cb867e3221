// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut.h"

#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/midpoint.h"
#include "nmgs_cad/solid_boundary.h"
#include "nmgs_cad/split.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GProp_PrincipalProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace nmgs::cad {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_angle = 12 * degree; // of a corner of a block

double diagonal_of(const TopoDS_Shape &shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, Standard_False);
    return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}
gp_Pnt centre_of(const TopoDS_Shape &shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, Standard_False);
    const gp_Pnt a = box.CornerMin();
    const gp_Pnt b = box.CornerMax();
    return {0.5 * (a.X() + b.X()), 0.5 * (a.Y() + b.Y()), 0.5 * (a.Z() + b.Z())};
}

// What stands in the way of mid-point subdivision of one solid.
struct Obstacles {
    double weight = 0;
    std::set<int> edges;    // concave, smooth, closed, or with an end where a face has no corner
    std::set<int> cusps;    // where the solid runs out to nothing, or leaves nothing: no cut helps
    std::set<int> vertices; // where other than three edges meet
    std::set<int> round;    // faces with a seam or more than one loop
};

bool sharp(double angle) {
    return angle > least_angle && angle < std::numbers::pi - least_angle;
}

Obstacles obstacles_of(const CadShape &cad, int solid) {
    Obstacles result;
    Refusal refusal;
    const auto boundary = boundary_of(cad, solid, refusal);
    if (!boundary) {
        result.weight = 10;
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

// The planes and cylinders that come into question, each once.
struct Proposer {
    const CadShape &cad;
    double tolerance;
    std::vector<Cut> cuts;

    explicit Proposer(const CadShape &c) : cad(c), tolerance(1e-4 * diagonal_of(c.shape)) {}

    static bool same(const Cut &a, const Cut &b, double tolerance) {
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
    void of_edge(int edge, bool flat, const std::vector<int> &faces);
    void of_round_face(int face, const std::vector<std::pair<double, gp_Dir>> &sides);
    void of_vertex(int vertex, const std::vector<int> &edges);
    void symmetry(int solid);
};

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
        if (surface.GetType() == GeomAbs_Plane && !flat) {
            const gp_Pln pln = surface.Plane();
            plane(pln.Location(), pln.Axis().Direction(), "plane of " + face, {face});
        }
        if (surface.GetType() == GeomAbs_Cylinder && !flat) {
            Cut cut;
            cut.cylinder = true;
            cut.place = surface.Cylinder().Position();
            cut.radius = surface.Cylinder().Radius();
            cut.name = "cylinder of " + face;
            cut.entities = {face};
            add(cut);
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
                plane(p, gp_Dir(n.Crossed(t)), "plane across " + face + " at " + name,
                      {face, name});
                if (!flat) {
                    plane(p, gp_Dir(n), "tangent plane of " + face + " at " + name, {face, name});
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

double distance_from(const Cut &cut, const gp_Pnt &p) {
    const gp_XYZ apart = p.XYZ() - cut.place.Location().XYZ();
    const gp_XYZ n = cut.place.Direction().XYZ();
    return cut.cylinder ? std::abs(apart.Crossed(n).Modulus() - cut.radius)
                        : std::abs(apart.Dot(n));
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

// The cuts that the obstacles of some solids suggest, the most promising first, and a guess how
// many of them are needed: as many as cover the obstacles (greedy set cover), and one each for
// those that no cut resolves.
struct Proposals {
    std::vector<Cut> cuts;
    int needed = 0;
};

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
    // Which edges and vertices (negative) lie on which cut.
    std::set<int> open;
    for (const Obstacles &o : obstacles) {
        open.insert(o.edges.begin(), o.edges.end());
        for (const int v : o.vertices) {
            open.insert(-v);
        }
    }
    std::vector<std::set<int>> on(proposer.cuts.size());
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t c = 0; c < proposer.cuts.size(); ++c) {
        Cut &cut = proposer.cuts[c];
        for (const int n : open) {
            const bool lies =
                n > 0 ? contains(cad, n, cut, proposer.tolerance) ||
                            through_centre(cad, n, cut, proposer.tolerance)
                      : distance_from(cut, BRep_Tool::Pnt(cad.vertex(-n))) < proposer.tolerance;
            if (lies) {
                on[c].insert(n);
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
        ++result.needed;
    }
    result.needed += static_cast<int>(open.size());
    for (const Obstacles &o : obstacles) {
        result.needed += static_cast<int>(o.cusps.size());
    }
    return result;
}

// The solids as the cuts leave them.
struct State {
    std::vector<Cut> cuts;
    Pieces pieces;
    std::vector<int> bad; // pieces with obstacles
    std::vector<Obstacles> obstacles;
    Proposals proposals;
    double weight = 0;
};

std::optional<State> make_state(const CadShape &shape, std::span<const int> solids,
                                std::vector<Cut> cuts, Refusal &refusal) {
    TopTools_ListOfShape tools;
    for (const Cut &cut : cuts) {
        tools.Append(cut_face(shape, cut));
    }
    auto pieces = split(shape, solids, tools, refusal);
    if (!pieces) {
        return std::nullopt;
    }
    State state{std::move(cuts), std::move(*pieces), {}, {}, {}, 0};
    const CadShape &cad = state.pieces.cad;
    for (int n = 1; n <= cad.solids.Extent(); ++n) {
        Obstacles o = obstacles_of(cad, n);
        state.weight += o.weight;
        if (o.weight > 0) {
            state.bad.push_back(n);
            state.obstacles.push_back(std::move(o));
        }
    }
    // Slivers cost as much as an obstacle.
    const double diagonal = diagonal_of(shape.shape);
    for (int e = 1; e <= cad.edges.Extent(); ++e) {
        if (state.pieces.edge_on[static_cast<std::size_t>(e)].dimension > 1 &&
            !BRep_Tool::Degenerated(cad.edge(e)) &&
            EdgeCurve(cad.edge(e)).length() < 2e-3 * diagonal) {
            state.weight += 0.5;
        }
    }
    state.weight += 0.02 * cad.solids.Extent();
    state.proposals = candidates(cad, state.bad, state.obstacles);
    state.weight = state.proposals.needed + 0.02 * state.weight;
    return state;
}

bool fill_pieces(const Pieces &pieces, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress) {
    for (int n = 1; n <= pieces.cad.solids.Extent(); ++n) {
        poll(progress, 0.7);
        if (!fill_midpoint(pieces.cad, n, layout, options, refusal, progress)) {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<int> obstacles(const CadShape &shape, int solid) {
    const Obstacles found = obstacles_of(shape, solid);
    return {found.edges.begin(), found.edges.end()};
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

bool fill_cut(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
              Refusal &refusal, const Progress &progress) {
    const std::vector<int> solids{solid};
    constexpr int most_cuts = 24;
    constexpr int most_pieces = 400;
    constexpr int patient = 3;
    constexpr std::size_t tries = 10; // of the most promising cuts
    constexpr auto patience = std::chrono::seconds(20);
    const auto start = std::chrono::steady_clock::now();
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_EDGE); it.More(); it.Next()) {
        const int edge = shape.edges.FindIndex(it.Current());
        if (!layout.edges[static_cast<std::size_t>(edge)].empty()) {
            refusal = {entity_name(1, edge) + " is laid out already by a neighbour",
                       {entity_name(1, edge)}};
            return false;
        }
    }
    auto state = make_state(shape, solids, {}, refusal);
    if (!state) {
        return false;
    }
    double lowest = state->weight;
    int idle = 0; // cuts since the last that left less than any before
    while (!state->bad.empty() && static_cast<int>(state->cuts.size()) < most_cuts) {
        std::optional<State> best;
        std::size_t tried = 0;
        for (const Cut &cut : state->proposals.cuts) {
            poll(progress, static_cast<double>(state->cuts.size()) / most_cuts);
            const bool used =
                std::any_of(state->cuts.begin(), state->cuts.end(), [&](const Cut &c) {
                    return Proposer::same(c, cut, 1e-4 * diagonal_of(shape.shape));
                });
            if (used) {
                continue;
            }
            if (tried++ == tries || std::chrono::steady_clock::now() - start > patience) {
                break;
            }
            auto cuts = state->cuts;
            cuts.push_back(cut);
            Refusal ignored;
            auto next = make_state(shape, solids, std::move(cuts), ignored);
            if (next && next->pieces.cad.solids.Extent() > state->pieces.cad.solids.Extent() &&
                next->pieces.cad.solids.Extent() <= most_pieces &&
                (!best || next->weight < best->weight)) {
                best = std::move(next);
            }
        }
        idle = best && best->weight < lowest ? 0 : idle + 1;
        if (!best || idle > patient) {
            break;
        }
        lowest = std::min(lowest, best->weight);
        state = std::move(best);
    }
    if (!state->bad.empty()) {
        refusal = {"after " + std::to_string(state->cuts.size()) + " cuts " +
                       std::to_string(state->bad.size()) + " of " +
                       std::to_string(state->pieces.cad.solids.Extent()) +
                       " pieces still have edges that stand in the way",
                   {}};
        for (const int e : obstacles(shape, solid)) {
            refusal.blockers.push_back(entity_name(1, e));
        }
        return false;
    }
    Layout of_pieces(state->pieces.cad);
    if (!fill_pieces(state->pieces, of_pieces, options, refusal, progress)) {
        return false;
    }
    Layout result = layout;
    if (!join(shape, state->pieces, of_pieces, result, refusal)) {
        return false;
    }
    layout = std::move(result);
    return true;
}

} // namespace nmgs::cad
