// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/profile_core.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nmgs::cad {
namespace {

// A point of the profile: distance from the axis and height along it.
struct Place {
    double r, z;
};

struct HalfPlane {
    Vec3 origin, up, out;

    [[nodiscard]] Place place(Vec3 p) const { return {dot(p - origin, out), dot(p - origin, up)}; }
    [[nodiscard]] Vec3 point(Place p) const { return origin + p.r * out + p.z * up; }
};

constexpr int samples = 64;

// An edge of the profile as a polyline from one of its ends.
std::vector<Place> trace(const TopoDS_Edge &edge, const HalfPlane &plane) {
    const BRepAdaptor_Curve curve(edge);
    const double a = curve.FirstParameter();
    const double b = curve.LastParameter();
    std::vector<Place> result;
    for (int i = 0; i <= samples; ++i) {
        const gp_Pnt p = curve.Value(a + (b - a) * i / samples);
        result.push_back(plane.place({p.X(), p.Y(), p.Z()}));
    }
    return result;
}

// One end of the axis: the edge that leaves it, from there on.
struct End {
    TopoDS_Edge edge;
    std::vector<Place> run;
    double side = 1; // -1 at the low end: heights are measured towards the profile
    [[nodiscard]] bool flat_until(double radius, double slope) const {
        for (std::size_t i = 1; i < run.size(); ++i) {
            const double dr = run[i].r - run[i - 1].r;
            const double inwards = -side * (run[i].z - run[i - 1].z);
            // Away from the profile's inside the rest gets an obtuse corner: never mind.
            if (inwards > slope * dr || -inwards > 3 * slope * dr) {
                return false;
            }
            if (run[i].r >= radius) {
                return true;
            }
        }
        return true;
    }
};

Place at_radius(const TopoDS_Edge &edge, const HalfPlane &plane, bool from_last, double radius) {
    const BRepAdaptor_Curve curve(edge);
    double a = from_last ? curve.LastParameter() : curve.FirstParameter();
    const double whole = (from_last ? curve.FirstParameter() : curve.LastParameter()) - a;
    const auto value = [&](double t) {
        const gp_Pnt p = curve.Value(t);
        return plane.place({p.X(), p.Y(), p.Z()});
    };
    double low = a;
    double high = a + whole;
    for (int i = 1; i <= samples; ++i) { // the first stretch that reaches the radius
        const double t = a + whole * i / samples;
        if (value(t).r >= radius) {
            high = t;
            low = a + whole * (i - 1) / samples;
            break;
        }
    }
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (low + high);
        (value(t).r < radius ? low : high) = t;
    }
    return value(0.5 * (low + high));
}

} // namespace

std::vector<ProfileCore> profile_cores(const TopoDS_Face &profile, const gp_Ax1 &axis,
                                       double tolerance, double scale) {
    const gp_XYZ o = axis.Location().XYZ();
    const gp_XYZ d = axis.Direction().XYZ();
    HalfPlane plane{{o.X(), o.Y(), o.Z()}, {d.X(), d.Y(), d.Z()}, {}};
    for (TopExp_Explorer it(profile, TopAbs_EDGE); it.More(); it.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
        const gp_Pnt m = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
        const Vec3 q = Vec3{m.X(), m.Y(), m.Z()} - plane.origin;
        const Vec3 out = q - dot(q, plane.up) * plane.up;
        if (norm(out) > norm(plane.out)) {
            plane.out = out;
        }
    }
    plane.out = (1 / norm(plane.out)) * plane.out;

    std::vector<TopoDS_Edge> on_axis;
    std::vector<std::pair<TopoDS_Edge, std::vector<Place>>> others;
    for (TopExp_Explorer it(profile, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        const auto run = trace(edge, plane);
        if (std::all_of(run.begin(), run.end(), [&](Place p) { return p.r < tolerance; })) {
            on_axis.push_back(edge);
        } else {
            others.emplace_back(edge, run);
        }
    }
    // Stretches of the axis: the ends of its edges that are not shared with the next one.
    std::vector<double> heights;
    for (const auto &edge : on_axis) {
        const auto run = trace(edge, plane);
        heights.push_back(run.front().z);
        heights.push_back(run.back().z);
    }
    std::sort(heights.begin(), heights.end());
    std::vector<double> ends;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (i + 1 < heights.size() && heights[i + 1] - heights[i] < tolerance && i % 2 == 1) {
            ++i; // where two edges of the axis meet
            continue;
        }
        ends.push_back(heights[i]);
    }
    std::vector<ProfileCore> result;
    for (std::size_t s = 0; s + 1 < ends.size(); s += 2) {
        std::array<End, 2> end;
        for (std::size_t e = 0; e < 2; ++e) {
            end[e].side = e == 0 ? -1 : 1;
            for (const auto &[edge, run] : others) {
                for (const bool from_last : {false, true}) {
                    const Place p = from_last ? run.back() : run.front();
                    if (p.r < tolerance && std::abs(p.z - ends[s + e]) < tolerance) {
                        end[e].edge = edge;
                        end[e].run = run;
                        if (from_last) {
                            std::reverse(end[e].run.begin(), end[e].run.end());
                        }
                    }
                }
            }
            if (end[e].run.empty()) {
                return {};
            }
        }
        // How far the profile is clear of anything but its ends, over the stretch of the axis.
        double clear = std::numeric_limits<double>::infinity();
        for (const auto &[edge, run] : others) {
            const bool is_end = edge.IsSame(end[0].edge) || edge.IsSame(end[1].edge);
            for (std::size_t i = 0; i < run.size(); ++i) {
                if (is_end && i != 0 && i + 1 != run.size()) {
                    continue;
                }
                if (run[i].r > tolerance) {
                    clear = std::min(clear, run[i].r);
                }
            }
        }
        for (const auto &e : end) {
            double widest = 0;
            for (const Place p : e.run) {
                widest = std::max(widest, p.r);
            }
            clear = std::min(clear, widest);
        }
        const double core = scale * clear;
        ProfileCore cut;
        cut.low = end[0].edge;
        cut.high = end[1].edge;
        std::array<std::vector<Place>, 2> line;
        std::array<std::vector<Place>, 2> partner;
        for (std::size_t e = 0; e < 2; ++e) {
            const auto &run = end[e].run;
            const bool from_last = [&] {
                const BRepAdaptor_Curve curve(end[e].edge);
                const gp_Pnt p = curve.Value(curve.LastParameter());
                const Place q = plane.place({p.X(), p.Y(), p.Z()});
                // Of an edge with both ends on the axis it is the height that tells.
                return q.r < tolerance && std::abs(q.z - ends[s + e]) < tolerance;
            }();
            const Place pole{0, ends[s + e]};
            if (end[e].flat_until(1.8 * core, 0.75)) {
                line[e].push_back(at_radius(end[e].edge, plane, from_last, core));
                partner[e].push_back(pole);
                continue;
            }
            if (-end[e].side * (run.back().z - run.front().z) < 0 && run.back().r > tolerance) {
                return {}; // a steep hollow
            }
            // Where the end turns down by more than 45 degrees, or two cores away.
            std::size_t at = 1;
            while (at + 1 < run.size() && run[at].r < 1.6 * core &&
                   std::abs(run[at].z - run[at - 1].z) <
                       0.999 * std::abs(run[at].r - run[at - 1].r)) {
                ++at;
            }
            while (at + 1 < run.size() && run[at].r < 1.6 * core && run[at + 1].r > run[at].r) {
                ++at;
            }
            const Place foot = at_radius(end[e].edge, plane, from_last, run[at].r);
            const double dr = run[at].r - run[at - 1].r;
            const double dz = run[at].z - run[at - 1].z;
            const double length = std::hypot(dr, dz);
            // Into the profile, at a right angle to the end, as far as the core's radius.
            const double inward_r = -std::abs(dz) / length;
            const double inward_z = -end[e].side * dr / length;
            const double far = (foot.r - core) / std::max(-inward_r, 0.1);
            const Place corner{core, foot.z + far * inward_z};
            line[e] = {foot, corner};
            partner[e] = {pole, {0, corner.z}};
        }
        std::reverse(line[1].begin(), line[1].end());
        std::reverse(partner[1].begin(), partner[1].end());
        for (std::size_t e = 0; e < 2; ++e) {
            for (std::size_t i = 0; i < line[e].size(); ++i) {
                cut.line.push_back(plane.point(line[e][i]));
                cut.axis.push_back(plane.point(partner[e][i]));
            }
        }
        result.push_back(std::move(cut));
    }
    return result;
}

} // namespace nmgs::cad
