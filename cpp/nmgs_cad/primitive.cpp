// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/primitive.h"

#include "nmgs/support/ascending.h"
#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/fill_finer.h"
#include "nmgs_cad/occt_vec.h"
#include "nmgs_cad/profile_core.h"
#include "nmgs_cad/revolution_axis.h"
#include "nmgs_cad/section.h"
#include "nmgs_cad/section_layout.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GProp_PrincipalProps.hxx>
#include <TopExp.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_GTrsf.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace nmgs::cad {
namespace {

constexpr double full = 2 * std::numbers::pi;

// Where the layout's half-planes stand: through all the given angles, `least` in number or more, an
// even number between two given ones if `even`.
std::vector<double> spread(const std::vector<double> &given, std::size_t least, bool even) {
    const std::size_t unit = even ? 2 : 1;
    std::vector<std::size_t> pieces(given.size(), unit);
    const auto gap = [&](std::size_t i) {
        return (i + 1 < given.size() ? given[i + 1] : given[0] + full) - given[i];
    };
    std::size_t sum = unit * given.size();
    while (sum < least) {
        std::size_t widest = 0;
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (gap(i) * static_cast<double>(pieces[widest]) >
                1.000001 * gap(widest) * static_cast<double>(pieces[i])) {
                widest = i;
            }
        }
        pieces[widest] += unit;
        sum += unit;
    }
    std::vector<double> result;
    for (std::size_t i = 0; i < given.size(); ++i) {
        for (std::size_t k = 0; k < pieces[i]; ++k) {
            result.push_back(given[i] +
                             gap(i) * static_cast<double>(k) / static_cast<double>(pieces[i]));
        }
    }
    return result;
}

// Largest by smallest gap between angles.
double unevenness(const std::vector<double> &angles) {
    double low = full;
    double high = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double gap = (i + 1 < angles.size() ? angles[i + 1] : angles[0] + full) - angles[i];
        low = std::min(low, gap);
        high = std::max(high, gap);
    }
    return high / low;
}

// The solid's section with the half-plane at an angle.
TopoDS_Shape half_section(const TopoDS_Solid &solid, const gp_Ax2 &frame, double angle) {
    Bnd_Box box;
    BRepBndLib::Add(solid, box, Standard_False);
    const double far = 2 * std::sqrt(box.SquareExtent()) +
                       frame.Location().Distance(box.CornerMin()) +
                       frame.Location().Distance(box.CornerMax());
    const gp_XYZ out =
        std::cos(angle) * frame.XDirection().XYZ() + std::sin(angle) * frame.YDirection().XYZ();
    const gp_XYZ up = frame.Direction().XYZ();
    const gp_XYZ o = frame.Location().XYZ();
    BRepBuilderAPI_MakePolygon rectangle(gp_Pnt(o - far * up), gp_Pnt(o - far * up + far * out),
                                         gp_Pnt(o + far * up + far * out), gp_Pnt(o + far * up),
                                         Standard_True);
    const BRepBuilderAPI_MakeFace face(rectangle.Wire(), Standard_True);
    BRepAlgoAPI_Common common(face.Face(), solid);
    return common.IsDone() && !common.HasErrors() ? common.Shape() : TopoDS_Shape();
}

struct Turned {
    const CadShape &shape;
    int solid;
    RevolutionAxis axis;
    double tolerance;
    Section section;
    std::vector<ProfileCore> cores;
    // Numbers in section.cad of the edges between each core and the rest, along the core.
    std::vector<std::vector<int>> lines;

    bool cut(const TopoDS_Shape &profile, double scale, Refusal &refusal);
    bool find_lines(Refusal &refusal);
    void fill_core(std::size_t c, const Layout &flat, Carried &carried) const;
    [[nodiscard]] Vec3 turn(Vec3 p, std::size_t k) const {
        return section.motion.move(p, section.levels[k % section.levels.size()] - section.base);
    }
};

// Divides the profile along the cores' lines; what touches the axis is left out of the section.
bool Turned::cut(const TopoDS_Shape &profile, double scale, Refusal &refusal) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(profile, TopAbs_FACE, faces);
    TopTools_ListOfShape arguments;
    cores.clear();
    for (int f = 1; f <= faces.Extent(); ++f) {
        arguments.Append(faces(f));
        for (auto &core :
             profile_cores(TopoDS::Face(faces(f)), section.motion.axis, tolerance, scale)) {
            for (std::size_t i = 0; i + 1 < core.line.size(); ++i) {
                if (distance(core.line[i], core.line[i + 1]) < 10 * tolerance) {
                    refusal = {"no room for a core along the axis", {entity_name(3, solid)}};
                    return false;
                }
                arguments.Append(
                    BRepBuilderAPI_MakeEdge(pnt(core.line[i]), pnt(core.line[i + 1])).Edge());
            }
            cores.push_back(std::move(core));
        }
    }
    TopoDS_Shape arrangement = profile;
    if (!cores.empty()) {
        BRepAlgoAPI_BuilderAlgo fuse;
        fuse.SetArguments(arguments);
        fuse.SetNonDestructive(Standard_True);
        fuse.SetFuzzyValue(0.1 * tolerance);
        fuse.Build();
        if (!fuse.IsDone() || fuse.HasErrors()) {
            refusal = {"the profile could not be divided", {entity_name(3, solid)}};
            return false;
        }
        arrangement = fuse.Shape();
    }
    TopoDS_Compound rest;
    const BRep_Builder builder;
    builder.MakeCompound(rest);
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(arrangement, TopAbs_FACE, parts);
    const gp_Vec direction(section.motion.axis.Direction());
    std::size_t strips = 0;
    for (int f = 1; f <= parts.Extent(); ++f) {
        bool touches = false;
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(parts(f), TopAbs_EDGE, edges);
        for (int e = 1; e <= edges.Extent(); ++e) {
            const BRepAdaptor_Curve curve(TopoDS::Edge(edges(e)));
            const gp_Pnt m = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
            const gp_Vec to(section.motion.axis.Location(), m);
            touches = touches || to.Crossed(direction).Magnitude() < tolerance;
        }
        if (touches) {
            ++strips;
        } else {
            builder.Add(rest, parts(f));
        }
    }
    if (strips != cores.size()) {
        refusal = {"no core along the axis could be cut off the profile", {entity_name(3, solid)}};
        return false;
    }
    section.cad = make_shape(rest);
    if (section.cad.faces.IsEmpty()) {
        refusal = {"its profile is empty", {entity_name(3, solid)}};
        return false;
    }
    const std::size_t intervals = section.levels.size();
    section.filled.assign(static_cast<std::size_t>(section.cad.faces.Extent()) + 1,
                          std::vector<char>(intervals, 1));
    return find_lines(refusal);
}

bool Turned::find_lines(Refusal &refusal) {
    lines.clear();
    for (const auto &core : cores) {
        lines.emplace_back();
        for (std::size_t i = 0; i + 1 < core.line.size(); ++i) {
            int found = 0;
            for (int e = 1; e <= section.cad.edges.Extent(); ++e) {
                const TopoDS_Edge edge = section.cad.edge(e);
                const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
                const gp_Pnt b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
                const gp_Pnt p = pnt(core.line[i]);
                const gp_Pnt q = pnt(core.line[i + 1]);
                const BRepAdaptor_Curve curve(edge);
                const bool ends = std::max(a.Distance(p), b.Distance(q)) < 10 * tolerance ||
                                  std::max(a.Distance(q), b.Distance(p)) < 10 * tolerance;
                const gp_Pnt m =
                    curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
                const gp_Pnt middle(0.5 * (p.XYZ() + q.XYZ()));
                if (ends && m.Distance(middle) < 10 * tolerance) {
                    found = e;
                }
            }
            if (found == 0) {
                refusal = {"no core along the axis could be cut off the profile",
                           {entity_name(3, solid)}};
                return false;
            }
            lines.back().push_back(found);
        }
    }
    return true;
}

// Discs of quads round the axis, between two levels of the core's line after the other.
void Turned::fill_core(std::size_t c, const Layout &flat, Carried &carried) const {
    const ProfileCore &core = cores[c];
    std::vector<std::int32_t> rim;
    std::vector<Vec3> axis_points;
    for (std::size_t i = 0; i < lines[c].size(); ++i) {
        auto points = flat.edges[static_cast<std::size_t>(lines[c][i])];
        const auto place = [&](std::int32_t p) { return flat.points[static_cast<std::size_t>(p)]; };
        if (distance(place(points.front()), core.line[i]) >
            distance(place(points.back()), core.line[i])) {
            std::reverse(points.begin(), points.end());
        }
        const double length = distance(core.line[i], core.line[i + 1]);
        for (std::size_t k = i == 0 ? 0 : 1; k < points.size(); ++k) {
            const double f = distance(place(points[k]), core.line[i]) / length;
            rim.push_back(points[k]);
            axis_points.push_back((1 - f) * core.axis[i] + f * core.axis[i + 1]);
        }
    }
    HexaMesh &mesh = carried.mesh;
    const std::size_t around = section.levels.size();
    std::vector<std::int32_t> centre;
    for (const Vec3 p : axis_points) {
        centre.push_back(static_cast<std::int32_t>(mesh.points.size()));
        mesh.points.push_back(p);
    }
    const auto ring = [&](std::size_t i, std::size_t k) {
        return carried.points[k % around][static_cast<std::size_t>(rim[i])];
    };
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const bool end = i == 0 || i + 1 == rim.size();
        // On a curved end the chords between the half-planes are lifted onto it.
        const auto on_end = [&](Vec3 chord) {
            const TopoDS_Edge edge = i == 0 ? core.low : core.high;
            const gp_XYZ o = section.motion.axis.Location().XYZ();
            const gp_XYZ d = section.motion.axis.Direction().XYZ();
            const Vec3 origin{o.X(), o.Y(), o.Z()};
            const Vec3 up{d.X(), d.Y(), d.Z()};
            const Vec3 q = chord - origin;
            const Vec3 out = q - dot(q, up) * up;
            const double r = norm(out);
            const BRepAdaptor_Curve curve(edge);
            Vec3 best = chord;
            double nearest = std::numeric_limits<double>::infinity();
            const double a = curve.FirstParameter();
            const double b = curve.LastParameter();
            const auto error = [&](double t) {
                const gp_Pnt p = curve.Value(t);
                const Vec3 v = Vec3{p.X(), p.Y(), p.Z()} - origin;
                const double z = dot(v, up);
                const double pr = norm(v - z * up);
                // The branch on this side of the solid, then the radius.
                return std::pair{std::hypot(pr - r, 1e-3 * (z - dot(q, up))),
                                 origin + z * up + (pr / r) * out};
            };
            double t0 = a;
            for (int n = 0; n <= 256; ++n) {
                const double t = a + (b - a) * n / 256;
                const auto [e, p] = error(t);
                if (e < nearest) {
                    nearest = e;
                    best = p;
                    t0 = t;
                }
            }
            double step = (b - a) / 256;
            for (int n = 0; n < 60; ++n, step *= 0.6) {
                for (const double t : {t0 - step, t0 + step}) {
                    const auto [e, p] = error(std::clamp(t, a, b));
                    if (e < nearest) {
                        nearest = e;
                        best = p;
                        t0 = std::clamp(t, a, b);
                    }
                }
            }
            return best;
        };
        for (std::size_t k = 0; k < around; ++k) {
            const auto a = ring(i, k);
            const auto b = ring(i, k + 1);
            const Vec3 pa = mesh.points[static_cast<std::size_t>(a)];
            const Vec3 pb = mesh.points[static_cast<std::size_t>(b)];
            mesh.middles.erase(ascending(a, b));
            if (end) {
                mesh.middles[ascending(a, b)] = on_end(0.5 * (pa + pb));
                if (k % 2 == 0) {
                    mesh.middles[ascending(centre[i], a)] = on_end(0.5 * (axis_points[i] + pa));
                }
            }
        }
        if (i == 0) {
            continue;
        }
        for (std::size_t k = 0; k < around; k += 2) {
            mesh.hexas.push_back({centre[i - 1], ring(i - 1, k), ring(i - 1, k + 1),
                                  ring(i - 1, k + 2), centre[i], ring(i, k), ring(i, k + 1),
                                  ring(i, k + 2)});
        }
    }
}

// Hexahedra of a turned solid.
std::optional<HexaMesh> turn(const CadShape &shape, int solid, const LayoutOptions &options,
                             Refusal &refusal, const Progress &progress) {
    const auto axis = revolution_axis(shape, solid, refusal);
    if (!axis) {
        return std::nullopt;
    }
    Turned turned{shape, solid, *axis, 1e-6 * extent_of(shape.solid(solid)), {}, {}, {}};
    // The profile is taken away from all that lies on half-planes of the axis.
    std::size_t widest = 0;
    const auto &angles = axis->angles;
    const auto gap = [&](std::size_t i) {
        return (i + 1 < angles.size() ? angles[i + 1] : angles[0] + full) - angles[i];
    };
    for (std::size_t i = 0; i < angles.size(); ++i) {
        widest = gap(i) > gap(widest) ? i : widest;
    }
    Section &section = turned.section;
    section.motion = {axis->frame.Axis(), true};
    section.base = angles[widest] + 0.43 * gap(widest);
    section.closed = true;
    const TopoDS_Shape profile = half_section(shape.solid(solid), axis->frame, section.base);
    if (profile.IsNull()) {
        refusal = {"its profile could not be found", {entity_name(3, solid)}};
        return std::nullopt;
    }
    for (const double scale : {0.5, 0.35, 0.65}) {
        poll(progress, 0.0);
        const auto least = static_cast<std::size_t>(std::ceil(full / options.angle - 0.01));
        section.levels = spread(angles, std::max<std::size_t>(least, 4), false);
        if (!turned.cut(profile, scale, refusal)) {
            continue;
        }
        if (!turned.cores.empty()) {
            // Discs of three to six quads.
            for (const std::size_t count : {8U, 6U, 10U, 12U}) {
                auto levels = spread(angles, count, true);
                if (count == 8 || unevenness(levels) < 0.8 * unevenness(section.levels)) {
                    section.levels = std::move(levels);
                }
            }
            for (auto &filled : section.filled) {
                filled.assign(section.levels.size(), 1);
            }
        }
        Layout flat(section.cad);
        if (!layout_section(section.cad, flat, options, refusal, progress)) {
            continue;
        }
        Carried carried = carry_section(section, flat);
        for (std::size_t c = 0; c < turned.cores.size(); ++c) {
            turned.fill_core(c, flat, carried);
        }
        return std::move(carried.mesh);
    }
    return std::nullopt;
}

// The map that makes the solid's inertia the same about all axes, and back: it turns ellipsoids
// into balls, and cylinders and cones over ellipses into round ones.
std::array<gp_GTrsf, 2> rounding(const TopoDS_Solid &solid) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, 1e-8, Standard_False, Standard_False);
    const GProp_PrincipalProps principal = properties.PrincipalProperties();
    double ix = 0;
    double iy = 0;
    double iz = 0;
    principal.Moments(ix, iy, iz);
    // Of a solid with moments I: the second moments of its mass along the axes.
    const std::array<double, 3> second{0.5 * (iy + iz - ix), 0.5 * (iz + ix - iy),
                                       0.5 * (ix + iy - iz)};
    const std::array<gp_Vec, 3> axes{principal.FirstAxisOfInertia(),
                                     principal.SecondAxisOfInertia(),
                                     principal.ThirdAxisOfInertia()};
    const double least = *std::min_element(second.begin(), second.end());
    gp_Mat out(0, 0, 0, 0, 0, 0, 0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i) {
        const gp_XYZ a = axes[i].XYZ();
        gp_Mat one;
        one.SetCols(a.X() * a, a.Y() * a, a.Z() * a);
        out += one * std::sqrt(least / second[i]);
    }
    const gp_XYZ centre = properties.CentreOfMass().XYZ();
    return {gp_GTrsf(out, centre - out * centre),
            gp_GTrsf(out.Inverted(), centre - out.Inverted() * centre)};
}

void transform(HexaMesh &mesh, const gp_GTrsf &by) {
    const auto move = [&](Vec3 &p) {
        gp_XYZ q(p.x, p.y, p.z);
        by.Transforms(q);
        p = {q.X(), q.Y(), q.Z()};
    };
    std::for_each(mesh.points.begin(), mesh.points.end(), move);
    for (auto &[key, middle] : mesh.middles) {
        move(middle);
    }
}

} // namespace

bool fill_primitive(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                    Refusal &refusal, const Progress &progress) {
    const auto fill_turned = [&](Layout &trial, const LayoutOptions &finer, Refusal &why) {
        const auto mesh = turn(shape, solid, finer, why, progress);
        return mesh && add_hexas(shape, solid, *mesh, trial, why);
    };
    if (fill_finer(shape, solid, layout, options, refusal, progress, fill_turned)) {
        return true;
    }
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape.solid(solid), TopAbs_FACE, faces);
    if (faces.Extent() > 8) {
        return false; // nothing that is turned but for a stretch
    }
    const auto maps = rounding(shape.solid(solid));
    BRepBuilderAPI_GTransform round(shape.solid(solid), maps[0], Standard_True);
    const CadShape rounded = make_shape(round.Shape());
    if (rounded.solids.Extent() != 1) {
        return false;
    }
    return fill_finer(shape, solid, layout, options, refusal, progress,
                      [&](Layout &trial, const LayoutOptions &finer, Refusal &why) {
                          auto mesh = turn(rounded, 1, finer, why, progress);
                          if (!mesh) {
                              why.blockers = {entity_name(3, solid)};
                              return false;
                          }
                          transform(*mesh, maps[1]);
                          return add_hexas(shape, solid, *mesh, trial, why);
                      })
        .has_value();
}

} // namespace nmgs::cad
