// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/section.h"

#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/occt_vec.h"
#include "nmgs_cad/section_neighbours.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IntTools_Context.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {

constexpr double angular = 1e-4; // sine of the angle by which real CAD is off

// Where a solid's faces and edges stand along a direction.
struct Prism {
    const CadShape &shape;
    int solid;
    Vec3 direction;
    double tolerance;
    std::vector<TopoDS_Face> caps;
    std::vector<double> cap_level;
    std::size_t walls = 0;
    std::vector<double> levels;

    [[nodiscard]] double level(Vec3 p) const {
        const double t = dot(p, direction);
        for (const double l : levels) {
            if (std::abs(l - t) <= tolerance) {
                return l;
            }
        }
        return t;
    }
    bool classify(const Layout &layout, Refusal &refusal);
    bool check_edges(Refusal &refusal) const;
    [[nodiscard]] bool across(const TopoDS_Edge &edge) const;
};

bool Prism::classify(const Layout &layout, Refusal &refusal) {
    levels = levels_of_neighbours(shape, solid, direction, tolerance, layout);
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_VERTEX); it.More(); it.Next()) {
        levels.push_back(dot(vec(BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).XYZ()), direction));
    }
    std::sort(levels.begin(), levels.end());
    std::vector<double> merged;
    for (const double t : levels) {
        if (merged.empty() || t - merged.back() > tolerance) {
            merged.push_back(t);
        }
    }
    levels = merged;
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        bool wall = true;
        bool cap = true;
        double t = 0;
        for (const auto &[point, normal] : sample_normals(face)) {
            const double along = dot(normal, direction);
            wall = wall && std::abs(along) < angular;
            cap = cap && norm(cross(normal, direction)) < angular;
            t = dot(point, direction);
        }
        if (wall == cap) {
            const int n = shape.faces.FindIndex(face);
            refusal = {entity_name(2, n) + " is neither along the sweep nor across it",
                       {entity_name(2, n)}};
            return false;
        }
        if (cap) {
            caps.push_back(face);
            cap_level.push_back(level(t * direction));
        } else {
            ++walls;
        }
    }
    return check_edges(refusal);
}

bool Prism::across(const TopoDS_Edge &edge) const {
    const BRepAdaptor_Curve curve(edge);
    const double a = curve.FirstParameter();
    const double b = curve.LastParameter();
    const double t = dot(vec(curve.Value(a).XYZ()), direction);
    bool result = true;
    for (int i = 1; i <= 4; ++i) {
        const Vec3 p = vec(curve.Value(a + (b - a) * i / 4).XYZ());
        result = result && std::abs(dot(p, direction) - t) <= 2 * tolerance;
    }
    return result;
}

bool Prism::check_edges(Refusal &refusal) const {
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        const double a = curve.FirstParameter();
        const double b = curve.LastParameter();
        bool along = true;
        const Vec3 start = vec(curve.Value(a).XYZ());
        for (int i = 1; i <= 4; ++i) {
            const Vec3 p = vec(curve.Value(a + (b - a) * i / 4).XYZ());
            along = along && norm(cross(p - start, direction)) <= 2 * tolerance;
        }
        if (!along && !across(edge)) {
            const int n = shape.edges.FindIndex(edge);
            refusal = {entity_name(1, n) + " runs askew to the sweep", {entity_name(1, n)}};
            return false;
        }
    }
    return true;
}

int count(const TopoDS_Shape &shape, TopAbs_ShapeEnum type) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, type, map);
    return map.Extent();
}

// The arrangement of the faces, which lie in one plane.
TopoDS_Shape arrange(const TopTools_ListOfShape &faces, double tolerance) {
    BRepAlgoAPI_BuilderAlgo fuse;
    fuse.SetArguments(faces);
    fuse.SetNonDestructive(Standard_True);
    fuse.SetFuzzyValue(tolerance);
    fuse.SetToFillHistory(Standard_False);
    fuse.Build();
    return fuse.IsDone() && !fuse.HasErrors() ? fuse.Shape() : TopoDS_Shape();
}

} // namespace

Vec3 Motion::move(Vec3 p, double by) const {
    gp_Pnt q(p.x, p.y, p.z);
    if (turn) {
        q.Rotate(axis, by);
    } else {
        q.Translate(gp_Vec(axis.Direction()) * by);
    }
    return {q.X(), q.Y(), q.Z()};
}

TopoDS_Shape Motion::move(const TopoDS_Shape &shape, double by) const {
    gp_Trsf trsf;
    if (turn) {
        trsf.SetRotation(axis, by);
    } else {
        trsf.SetTranslation(gp_Vec(axis.Direction()) * by);
    }
    return shape.Moved(TopLoc_Location(trsf));
}

void fill_columns(const TopoDS_Solid &solid, const TopoDS_Shape &arrangement, Section &section) {
    BRepClass3d_SolidClassifier inside(solid);
    Handle(IntTools_Context) context = new IntTools_Context;
    TopoDS_Compound kept;
    const BRep_Builder builder;
    builder.MakeCompound(kept);
    section.filled.assign(1, {});
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(arrangement, TopAbs_FACE, faces);
    const std::size_t intervals = section.levels.size() - (section.closed ? 0 : 1);
    for (int f = 1; f <= faces.Extent(); ++f) {
        gp_Pnt p;
        gp_Pnt2d uv;
        if (BOPTools_AlgoTools3D::PointInFace(TopoDS::Face(faces(f)), p, uv, context) != 0) {
            continue; // a sliver without an inside
        }
        std::vector<char> filled(intervals, 0);
        bool any = false;
        for (std::size_t k = 0; k < intervals; ++k) {
            const double next = k + 1 < section.levels.size()
                                    ? section.levels[k + 1]
                                    : section.levels.front() + 2 * std::numbers::pi;
            const double by = 0.5 * (section.levels[k] + next) - section.base;
            const Vec3 q = section.motion.move({p.X(), p.Y(), p.Z()}, by);
            inside.Perform({q.x, q.y, q.z}, 1e-7);
            filled[k] = inside.State() == TopAbs_IN ? 1 : 0;
            any = any || filled[k] != 0;
        }
        if (any) {
            builder.Add(kept, faces(f));
            section.filled.push_back(std::move(filled));
        }
    }
    section.cad = make_shape(kept);
}

bool section_along(const CadShape &shape, int solid, const gp_Dir &direction, const Layout &layout,
                   Section &section, Refusal &refusal) {
    Prism prism{shape, solid, vec(direction.XYZ()), 1e-5 * extent_of(shape.solid(solid)), {}, {},
                0,     {}};
    if (!prism.classify(layout, refusal)) {
        return false;
    }
    if (prism.caps.size() < 2) {
        refusal = {"it has no two plane faces across the sweep", {entity_name(3, solid)}};
        return false;
    }
    section = {};
    section.motion = {gp_Ax1(gp::Origin(), direction), false};
    section.levels = prism.levels;
    section.base = prism.cap_level[0];
    TopoDS_Shape arrangement;
    if (prism.caps.size() == 2 &&
        static_cast<std::size_t>(count(prism.caps[0], TopAbs_EDGE)) == prism.walls &&
        static_cast<std::size_t>(count(prism.caps[1], TopAbs_EDGE)) == prism.walls) {
        arrangement = prism.caps[0];
    } else {
        TopTools_ListOfShape faces;
        for (std::size_t i = 0; i < prism.caps.size(); ++i) {
            faces.Append(section.motion.move(prism.caps[i], section.base - prism.cap_level[i]));
        }
        // What lies on walls or inside caps alone has to be met as well.
        TopTools_IndexedMapOfShape met;
        for (const auto &cap : prism.caps) {
            for (TopExp_Explorer it(cap, TopAbs_EDGE); it.More(); it.Next()) {
                if (it.Current().Orientation() == TopAbs_FORWARD ||
                    it.Current().Orientation() == TopAbs_REVERSED) {
                    TopExp::MapShapes(it.Current(), TopAbs_EDGE, met);
                    TopExp::MapShapes(it.Current(), TopAbs_VERTEX, met);
                }
            }
        }
        for (const auto type : {TopAbs_EDGE, TopAbs_VERTEX}) {
            TopTools_IndexedMapOfShape all;
            TopExp::MapShapes(shape.solid(solid), type, all);
            for (int i = 1; i <= all.Extent(); ++i) {
                if (met.Contains(all(i))) {
                    continue;
                }
                const gp_Pnt p =
                    BRep_Tool::Pnt(type == TopAbs_EDGE ? TopExp::FirstVertex(TopoDS::Edge(all(i)))
                                                       : TopoDS::Vertex(all(i)));
                if (type == TopAbs_VERTEX || prism.across(TopoDS::Edge(all(i)))) {
                    faces.Append(
                        section.motion.move(all(i), section.base - prism.level(vec(p.XYZ()))));
                }
            }
        }
        arrangement = arrange(faces, prism.tolerance);
        if (arrangement.IsNull()) {
            refusal = {"the faces across the sweep could not be laid over each other",
                       {entity_name(3, solid)}};
            return false;
        }
    }
    fill_columns(shape.solid(solid), arrangement, section);
    if (section.cad.faces.IsEmpty()) {
        refusal = {"the section is empty", {entity_name(3, solid)}};
        return false;
    }
    return true;
}

} // namespace nmgs::cad
