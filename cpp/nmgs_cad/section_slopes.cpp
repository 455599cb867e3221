// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/section_slopes.h"

#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/occt_vec.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_IntCS.hxx>
#include <GeomProjLib.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <IntTools_Context.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>

namespace nmgs::cad {
namespace {

constexpr double angular = 1e-4;
constexpr double steepest = 0.15; // cosine of the angle between a cap's normal and the sweep

struct Cap {
    int face = 0;
    bool up = false; // the solid lies below it
    Handle(Geom_Surface) surface;
    Vec3 point{}, normal{}; // of a plane
    bool plane = false, across = false;
    double low = 0, high = 0; // levels of its vertices, and of samples
    int sheet = 0;
    // Where the last line met the surface: the next one is near.
    mutable std::optional<gp_Pnt2d> last;
};

// The level where the line through a place along the sweep meets the surface, by Newton's method
// from where the last line did; nothing when it does not converge.
std::optional<double> level_near(const Cap &cap, Vec3 place, Vec3 direction) {
    if (!cap.last) {
        return std::nullopt;
    }
    const Vec3 axis = std::abs(direction.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 s = unit(cross(direction, axis));
    const Vec3 t = cross(direction, s);
    double u = cap.last->X();
    double v = cap.last->Y();
    double u_low = 0;
    double u_high = 0;
    double v_low = 0;
    double v_high = 0;
    cap.surface->Bounds(u_low, u_high, v_low, v_high);
    constexpr int rounds = 12;
    for (int round = 0; round < rounds; ++round) {
        gp_Pnt p;
        gp_Vec du;
        gp_Vec dv;
        cap.surface->D1(u, v, p, du, dv);
        const Vec3 off = vec(p) - place;
        const double a = dot(off, s);
        const double b = dot(off, t);
        const double as = dot(vec(du), s);
        const double at = dot(vec(du), t);
        const double bs = dot(vec(dv), s);
        const double bt = dot(vec(dv), t);
        if (a * a + b * b < 1e-24 * (1 + norm2(vec(p)))) {
            cap.last = gp_Pnt2d(u, v);
            return dot(vec(p), direction);
        }
        const double det = as * bt - at * bs;
        if (!(std::abs(det) > 1e-12 * (du.SquareMagnitude() + dv.SquareMagnitude()))) {
            return std::nullopt;
        }
        u -= (a * bt - b * bs) / det;
        v -= (b * as - a * at) / det;
        if (!(u >= u_low && u <= u_high && v >= v_low && v <= v_high)) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

// What the heights are asked of.
struct Slopes {
    Vec3 direction{};
    double tolerance = 0;
    std::vector<Cap> caps;
    std::vector<double> nominal;                   // of each level
    std::vector<std::vector<std::size_t>> columns; // of face n: its caps, ascending
    std::vector<std::size_t> level_of_sheet;

    [[nodiscard]] double level_at(const Cap &cap, Vec3 place) const;
    [[nodiscard]] std::size_t level(std::size_t cap) const {
        return level_of_sheet[static_cast<std::size_t>(caps[cap].sheet)];
    }
    [[nodiscard]] Section::Height height(int face, Vec3 place, std::size_t k) const;
};

double Slopes::level_at(const Cap &cap, Vec3 place) const {
    if (cap.plane) {
        const double along = dot(cap.normal, direction);
        return dot(place, direction) + dot(cap.normal, cap.point - place) / along;
    }
    const gp_Dir d(direction.x, direction.y, direction.z);
    const double gap = 0.05 * (cap.high - cap.low) + 100 * tolerance;
    const auto near = level_near(cap, place, direction);
    if (near && *near >= cap.low && *near <= cap.high) {
        return *near;
    }
    const double here = dot(place, direction);
    Handle(Geom_Curve) line =
        new Geom_TrimmedCurve(new Geom_Line(gp_Pnt(place.x, place.y, place.z), d),
                              cap.low - gap - here, cap.high + gap - here);
    const GeomAPI_IntCS meet(line, cap.surface);
    double best = std::numeric_limits<double>::quiet_NaN();
    double outside = gap;
    if (meet.IsDone()) {
        for (int i = 1; i <= meet.NbPoints(); ++i) {
            const double t = dot(vec(meet.Point(i).XYZ()), direction);
            const double off = std::max({0.0, cap.low - t, t - cap.high});
            if (off < outside) {
                outside = off;
                best = t;
                double u = 0;
                double v = 0;
                double w = 0;
                meet.Parameters(i, u, v, w);
                cap.last = gp_Pnt2d(u, v);
            }
        }
    }
    if (!std::isnan(best)) {
        return best;
    }
    // Beside the surface, or along it: the nearest place, again and again.
    ShapeAnalysis_Surface surface(cap.surface);
    double t = 0.5 * (cap.low + cap.high);
    for (int n = 0; n < 50; ++n) {
        const Vec3 p = place + (t - dot(place, direction)) * direction;
        const gp_Pnt2d uv = surface.ValueOfUV(gp_Pnt(p.x, p.y, p.z), tolerance);
        t = dot(vec(surface.Value(uv).XYZ()), direction);
    }
    return std::clamp(t, cap.low, cap.high);
}

Section::Height Slopes::height(int face, Vec3 place, std::size_t k) const {
    const auto &column = columns[static_cast<std::size_t>(face)];
    for (std::size_t i = 0; i + 1 < column.size(); i += 2) {
        const std::size_t low = level(column[i]);
        const std::size_t high = level(column[i + 1]);
        if (k < low || k > high) {
            continue;
        }
        if (k == low || k == high) {
            return {level_at(caps[column[k == low ? i : i + 1]], place), true};
        }
        const double a = level_at(caps[column[i]], place);
        const double b = level_at(caps[column[i + 1]], place);
        const double f = (nominal[k] - nominal[low]) / (nominal[high] - nominal[low]);
        return {a + f * (b - a), false};
    }
    return {nominal[k], false};
}

struct Slicer {
    const CadShape &shape;
    int solid;
    std::shared_ptr<Slopes> slopes;
    std::map<int, std::size_t> cap_of_face;

    bool classify(Refusal &refusal);
    bool join(Refusal &refusal);
    TopoDS_Shape arrange(double base) const;
    bool columns(const TopoDS_Shape &arrangement, Section &section, Refusal &refusal);
    bool order(Refusal &refusal);
    void add_levels(const Layout &layout);
};

bool Slicer::classify(Refusal &refusal) {
    const Vec3 d = slopes->direction;
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        const int n = shape.faces.FindIndex(face);
        double least = 2;
        double most = -2;
        bool across = true;
        bool plane = true;
        Cap cap;
        cap.low = std::numeric_limits<double>::infinity();
        cap.high = -cap.low;
        const auto samples = sample_normals(face);
        for (const auto &[point, normal] : samples) {
            const double along = dot(normal, d);
            least = std::min(least, along);
            most = std::max(most, along);
            across = across && norm(cross(normal, d)) < angular;
            plane = plane && norm(cross(normal, samples.front().normal)) < angular;
        }
        if (std::max(std::abs(least), std::abs(most)) < angular) {
            continue;
        }
        if (samples.empty() || least * most < 0 ||
            std::min(std::abs(least), std::abs(most)) < steepest) {
            refusal = {entity_name(2, n) + " is neither along the sweep nor a cap of it",
                       {entity_name(2, n)}};
            return false;
        }
        for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
            if (BRep_Tool::Degenerated(TopoDS::Edge(e.Current()))) {
                continue;
            }
            const BRepAdaptor_Curve curve(TopoDS::Edge(e.Current()));
            for (int i = 0; i <= 8; ++i) {
                const double f = i / 8.0;
                const double t = dot(
                    vec(curve.Value((1 - f) * curve.FirstParameter() + f * curve.LastParameter())
                            .XYZ()),
                    d);
                cap.low = std::min(cap.low, t);
                cap.high = std::max(cap.high, t);
            }
        }
        for (TopExp_Explorer v(face, TopAbs_VERTEX); v.More(); v.Next()) {
            const double t = dot(vec(BRep_Tool::Pnt(TopoDS::Vertex(v.Current())).XYZ()), d);
            cap.low = std::min(cap.low, t);
            cap.high = std::max(cap.high, t);
        }
        cap.face = n;
        cap.up = least > 0;
        cap.plane = plane;
        cap.across = across;
        cap.point = samples.front().point;
        cap.normal = samples.front().normal;
        cap.surface = BRep_Tool::Surface(face);
        cap_of_face[n] = slopes->caps.size();
        slopes->caps.push_back(cap);
    }
    return true;
}

// Sheets of caps that meet in edges.
bool Slicer::join(Refusal &refusal) {
    auto &caps = slopes->caps;
    std::vector<int> root(caps.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int n) {
        while (root[static_cast<std::size_t>(n)] != n) {
            n = root[static_cast<std::size_t>(n)];
        }
        return n;
    };
    std::map<int, std::vector<std::size_t>> caps_of_edge;
    for (std::size_t c = 0; c < caps.size(); ++c) {
        for (TopExp_Explorer it(shape.face(caps[c].face), TopAbs_EDGE); it.More(); it.Next()) {
            caps_of_edge[shape.edges.FindIndex(it.Current())].push_back(c);
        }
    }
    for (const auto &[edge, list] : caps_of_edge) {
        for (std::size_t i = 1; i < list.size(); ++i) {
            if (caps[list[0]].up != caps[list[i]].up) {
                refusal = {entity_name(1, edge) + " is a knife edge to the sweep",
                           {entity_name(1, edge)}};
                return false;
            }
            root[static_cast<std::size_t>(find(static_cast<int>(list[0])))] =
                find(static_cast<int>(list[i]));
        }
    }
    // Caps across the sweep at one height are one level.
    for (std::size_t a = 0; a < caps.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (caps[a].across && caps[b].across &&
                std::abs(caps[a].low - caps[b].low) < 10 * slopes->tolerance) {
                root[static_cast<std::size_t>(find(static_cast<int>(a)))] =
                    find(static_cast<int>(b));
            }
        }
    }
    for (std::size_t c = 0; c < caps.size(); ++c) {
        caps[c].sheet = find(static_cast<int>(c));
    }
    return true;
}

// The edges of the solid, but for those along the sweep, in the plane at the base.
TopoDS_Shape Slicer::arrange(double base) const {
    const Vec3 d = slopes->direction;
    const Vec3 o = base * d;
    const gp_Pln plane(gp_Pnt(o.x, o.y, o.z), gp_Dir(d.x, d.y, d.z));
    Handle(Geom_Plane) surface = new Geom_Plane(plane);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape.solid(solid), TopAbs_EDGE, edges);
    TopTools_ListOfShape arguments;
    Box box;
    const gp_Ax3 frame = plane.Position();
    for (int e = 1; e <= edges.Extent(); ++e) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(e));
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        bool along = true;
        const Vec3 start = vec(curve.Value(curve.FirstParameter()).XYZ());
        for (int i = 0; i <= 16; ++i) {
            const double f = i / 16.0;
            const gp_Pnt p =
                curve.Value((1 - f) * curve.FirstParameter() + f * curve.LastParameter());
            along = along && norm(cross(vec(p.XYZ()) - start, d)) < slopes->tolerance;
            const gp_Vec q(frame.Location(), p);
            box.add({q.Dot(frame.XDirection()), q.Dot(frame.YDirection()), 0});
        }
        if (along) {
            continue;
        }
        double first = 0;
        double last = 0;
        Handle(Geom_Curve) own = BRep_Tool::Curve(edge, first, last);
        if (own.IsNull()) {
            return {};
        }
        Handle(Geom_Curve) flat = GeomProjLib::ProjectOnPlane(
            new Geom_TrimmedCurve(own, first, last), surface, gp_Dir(d.x, d.y, d.z), Standard_True);
        if (flat.IsNull()) {
            return {};
        }
        BRepBuilderAPI_MakeEdge make(flat, flat->FirstParameter(), flat->LastParameter());
        if (!make.IsDone()) {
            return {};
        }
        arguments.Append(make.Edge());
    }
    const double margin = 0.1 * box.diagonal();
    arguments.Prepend(BRepBuilderAPI_MakeFace(plane, box.low.x - margin, box.high.x + margin,
                                              box.low.y - margin, box.high.y + margin)
                          .Face());
    BRepAlgoAPI_BuilderAlgo fuse;
    fuse.SetArguments(arguments);
    fuse.SetFuzzyValue(slopes->tolerance);
    fuse.SetToFillHistory(Standard_False);
    fuse.Build();
    return fuse.IsDone() && !fuse.HasErrors() ? fuse.Shape() : TopoDS_Shape();
}

bool Slicer::columns(const TopoDS_Shape &arrangement, Section &section, Refusal &refusal) {
    const Vec3 d = slopes->direction;
    Handle(IntTools_Context) context = new IntTools_Context;
    IntCurvesFace_ShapeIntersector intersector;
    intersector.Load(shape.solid(solid), 1e-7);
    TopoDS_Compound kept;
    const BRep_Builder builder;
    builder.MakeCompound(kept);
    slopes->columns.assign(1, {});
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(arrangement, TopAbs_FACE, faces);
    for (int f = 1; f <= faces.Extent(); ++f) {
        gp_Pnt p;
        gp_Pnt2d uv;
        if (BOPTools_AlgoTools3D::PointInFace(TopoDS::Face(faces(f)), p, uv, context) != 0) {
            continue;
        }
        intersector.Perform(gp_Lin(p, gp_Dir(d.x, d.y, d.z)), -1e100, 1e100);
        std::vector<std::pair<double, std::size_t>> hits;
        for (int i = 1; intersector.IsDone() && i <= intersector.NbPnt(); ++i) {
            const auto cap = cap_of_face.find(shape.faces.FindIndex(intersector.Face(i)));
            if (cap != cap_of_face.end()) {
                hits.emplace_back(intersector.WParameter(i), cap->second);
            }
        }
        std::sort(hits.begin(), hits.end());
        if (hits.empty()) {
            continue;
        }
        std::vector<std::size_t> column;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (slopes->caps[hits[i].second].up != (i % 2 == 1)) {
                refusal = {"a line along the sweep does not go in and out in turn",
                           {entity_name(2, slopes->caps[hits[i].second].face)}};
                return false;
            }
            column.push_back(hits[i].second);
        }
        if (column.size() % 2 != 0) {
            refusal = {"a line along the sweep does not come out again", {entity_name(3, solid)}};
            return false;
        }
        builder.Add(kept, faces(f));
        slopes->columns.push_back(std::move(column));
    }
    section.cad = make_shape(kept);
    if (section.cad.faces.IsEmpty()) {
        refusal = {"the section is empty", {entity_name(3, solid)}};
        return false;
    }
    return true;
}

// Levels of the sheets: below is below, and low before high.
bool Slicer::order(Refusal &refusal) {
    auto &caps = slopes->caps;
    struct Sheet {
        double at = 0;
        bool across = false;
        double sum = 0;
        int count = 0;
        std::set<int> above;
        int below = 0;
    };
    std::map<int, Sheet> sheets;
    for (const Cap &cap : caps) {
        Sheet &sheet = sheets[cap.sheet];
        sheet.sum += 0.5 * (cap.low + cap.high);
        ++sheet.count;
        if (cap.across && (!sheet.across || cap.up)) {
            sheet.at = cap.low;
            sheet.across = true;
        }
    }
    for (auto &[n, sheet] : sheets) {
        sheet.at = sheet.across ? sheet.at : sheet.sum / sheet.count;
    }
    for (const auto &column : slopes->columns) {
        for (std::size_t i = 1; i < column.size(); ++i) {
            const int low = caps[column[i - 1]].sheet;
            const int high = caps[column[i]].sheet;
            if (low == high) {
                refusal = {"caps of the sweep go round into each other",
                           {entity_name(2, caps[column[i]].face)}};
                return false;
            }
            if (sheets[low].above.insert(high).second) {
                ++sheets[high].below;
            }
        }
    }
    slopes->level_of_sheet.assign(caps.size(), 0);
    std::size_t done = 0;
    while (done < sheets.size()) {
        int next = -1;
        for (const auto &[n, sheet] : sheets) {
            if (sheet.below == 0 && (next < 0 || sheet.at < sheets[next].at)) {
                next = n;
            }
        }
        if (next < 0) {
            refusal = {"the caps of the sweep have no order", {entity_name(3, solid)}};
            return false;
        }
        Sheet &sheet = sheets[next];
        sheet.below = -1;
        for (const int above : sheet.above) {
            --sheets[above].below;
        }
        slopes->level_of_sheet[static_cast<std::size_t>(next)] = done++;
        const double least =
            slopes->nominal.empty() ? sheet.at : slopes->nominal.back() + 100 * slopes->tolerance;
        slopes->nominal.push_back(std::max(sheet.at, least));
    }
    return true;
}

// Levels of vertices on walls, and of the points of edges along the sweep that neighbours have laid
// out: at their share of the way from the cap below to the cap above.
void Slicer::add_levels(const Layout &layout) {
    const Vec3 d = slopes->direction;
    std::map<int, std::size_t> level_of; // of vertices on caps
    for (std::size_t c = 0; c < slopes->caps.size(); ++c) {
        for (TopExp_Explorer it(shape.face(slopes->caps[c].face), TopAbs_VERTEX); it.More();
             it.Next()) {
            level_of.emplace(shape.vertices.FindIndex(it.Current()), slopes->level(c));
        }
    }
    std::map<int, int> upper; // of an edge along the sweep at its lower vertex
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape.solid(solid), TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        const Vec3 a = vec(curve.Value(curve.FirstParameter()).XYZ());
        const Vec3 b = vec(curve.Value(curve.LastParameter()).XYZ());
        if (curve.GetType() == GeomAbs_Line && norm(cross(b - a, d)) < slopes->tolerance) {
            const TopoDS_Vertex low = TopExp::FirstVertex(edge);
            const TopoDS_Vertex high = TopExp::LastVertex(edge);
            const bool up = dot(b - a, d) > 0;
            upper[shape.vertices.FindIndex(up ? low : high)] = shape.edges.FindIndex(edge);
        }
    }
    std::vector<double> found;
    std::set<std::size_t> passed; // levels of caps that such edges pass by
    for (const auto &[vertex, low] : level_of) {
        // Up from this cap to the next.
        std::vector<double> places;
        int here = vertex;
        const double from = dot(shape.point(vertex), d);
        while (upper.contains(here)) {
            const int e = upper.at(here);
            const TopoDS_Edge edge = shape.edge(e);
            const int first = shape.vertices.FindIndex(TopExp::FirstVertex(edge));
            const int last = shape.vertices.FindIndex(TopExp::LastVertex(edge));
            const auto &points = layout.edges[static_cast<std::size_t>(e)];
            for (std::size_t i = 1; i + 1 < points.size(); ++i) {
                places.push_back(dot(layout.points[static_cast<std::size_t>(points[i])], d));
            }
            here = first == here ? last : first;
            const double to = dot(shape.point(here), d);
            const auto high = level_of.find(here);
            if (high == level_of.end()) {
                places.push_back(to);
                continue;
            }
            const double bottom = slopes->nominal[low];
            const double top = slopes->nominal[high->second];
            for (const double t : places) {
                found.push_back(bottom + (t - from) / (to - from) * (top - bottom));
            }
            for (std::size_t k = low + 1; !places.empty() && k < high->second; ++k) {
                passed.insert(k);
            }
            break;
        }
    }
    if (found.empty()) {
        return;
    }
    // Those of nearly the same share are one.
    std::sort(found.begin(), found.end());
    const double near = 0.02 * (slopes->nominal.back() - slopes->nominal.front());
    // Beside the caps of such a level its height is free: it goes with a neighbour's.
    std::vector<double> &nominal = slopes->nominal;
    for (const std::size_t k : passed) {
        double best = nominal[k];
        double least = std::numeric_limits<double>::infinity();
        for (const double t : found) {
            if (t > nominal[k - 1] + near && t < nominal[k + 1] - near &&
                std::abs(t - nominal[k]) < least) {
                least = std::abs(t - nominal[k]);
                best = t;
            }
        }
        nominal[k] = best;
    }
    std::vector<double> all = nominal;
    for (const double t : found) {
        if (std::none_of(all.begin(), all.end(),
                         [&](double k) { return std::abs(k - t) < near; })) {
            all.push_back(t);
        }
    }
    std::sort(all.begin(), all.end());
    for (std::size_t &level : slopes->level_of_sheet) {
        const auto now = std::lower_bound(all.begin(), all.end(), slopes->nominal[level]);
        level = static_cast<std::size_t>(now - all.begin());
    }
    slopes->nominal = std::move(all);
}

} // namespace

bool section_over(const CadShape &shape, int solid, const gp_Dir &direction, const Layout &layout,
                  Section &section, Refusal &refusal) {
    Slicer slicer{shape, solid, std::make_shared<Slopes>(), {}};
    Slopes &slopes = *slicer.slopes;
    slopes.direction = vec(direction.XYZ());
    slopes.tolerance = 1e-5 * extent_of(shape.solid(solid));
    if (!slicer.classify(refusal) || !slicer.join(refusal)) {
        return false;
    }
    if (slopes.caps.size() < 2) {
        refusal = {"it has no two caps", {entity_name(3, solid)}};
        return false;
    }
    section = {};
    section.motion = {gp_Ax1(gp::Origin(), direction), false};
    section.base =
        std::min_element(slopes.caps.begin(), slopes.caps.end(), [](const Cap &a, const Cap &b) {
            return a.low < b.low;
        })->low;
    const TopoDS_Shape arrangement = slicer.arrange(section.base);
    if (arrangement.IsNull()) {
        refusal = {"the edges could not be laid over each other", {entity_name(3, solid)}};
        return false;
    }
    if (!slicer.columns(arrangement, section, refusal) || !slicer.order(refusal)) {
        return false;
    }
    slicer.add_levels(layout);
    section.levels = slopes.nominal;
    section.filled.assign(slopes.columns.size(), {});
    for (std::size_t f = 1; f < slopes.columns.size(); ++f) {
        section.filled[f].assign(section.levels.size() - 1, 0);
        const auto &column = slopes.columns[f];
        for (std::size_t i = 0; i + 1 < column.size(); i += 2) {
            for (std::size_t k = slopes.level(column[i]); k < slopes.level(column[i + 1]); ++k) {
                section.filled[f][k] = 1;
            }
        }
    }
    section.height = [kept = slicer.slopes](int face, Vec3 place, std::size_t k) {
        return kept->height(face, place, k);
    };
    return true;
}

} // namespace nmgs::cad
