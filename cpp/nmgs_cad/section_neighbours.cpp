// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/section_neighbours.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/entity_locator.h"
#include "nmgs_cad/face_normals.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <IntTools_Context.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Lin.hxx>

#include <algorithm>
#include <set>

namespace nmgs::cad {
namespace {

// Of the solid, those that are laid out.
std::vector<int> laid_edges(const CadShape &shape, int solid, const Layout &layout) {
    std::set<int> result;
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_EDGE); it.More(); it.Next()) {
        const int e = shape.edges.FindIndex(it.Current());
        if (!layout.edges[at(e)].empty()) {
            result.insert(e);
        }
    }
    return {result.begin(), result.end()};
}

struct Taker {
    const Section &section;
    const Layout &layout;
    Layout &flat;
    Vec3 direction;
    double tolerance;

    [[nodiscard]] Vec3 down(Vec3 p) const {
        return p + (section.base - dot(p, direction)) * direction;
    }
    [[nodiscard]] bool along(const std::vector<std::int32_t> &points) const {
        const Vec3 first = layout.points[at(points.front())];
        return std::all_of(points.begin(), points.end(), [&](std::int32_t p) {
            return norm(cross(layout.points[at(p)] - first, direction)) < tolerance;
        });
    }
    [[nodiscard]] double away(const EdgeCurve &over, Vec3 here) const;
    void edge(const CadShape &shape, int n);
    void quads(int cap, int face);
};

// How far a place of the section is from below an edge.
double Taker::away(const EdgeCurve &over, Vec3 here) const {
    const auto apart = [&](double f) { return distance(down(over.at(f)), here); };
    constexpr int samples = 32;
    double best = 0;
    double least = apart(0);
    for (int i = 1; i <= samples; ++i) {
        const double d = apart(static_cast<double>(i) / samples);
        if (d < least) {
            least = d;
            best = static_cast<double>(i) / samples;
        }
    }
    double low = std::max(0.0, best - 1.0 / samples);
    double high = std::min(1.0, best + 1.0 / samples);
    for (int i = 0; i < 40 && least > tolerance; ++i) {
        const double a = low + (high - low) / 3;
        const double b = high - (high - low) / 3;
        const double at_a = apart(a);
        const double at_b = apart(b);
        (at_a < at_b ? high : low) = at_a < at_b ? b : a;
        least = std::min({least, at_a, at_b});
    }
    return least;
}

void Taker::edge(const CadShape &shape, int n) {
    const auto &points = layout.edges[at(n)];
    const bool closed = points.front() == points.back();
    if (!closed && along(points)) {
        return;
    }
    const EdgeCurve over(shape.edge(n));
    const double level = dot(layout.points[at(points.front())], direction);
    bool across = true;
    Box box;
    for (int i = 0; i <= 16; ++i) {
        const Vec3 p = over.at(i / 16.0);
        across = across && std::abs(dot(p, direction) - level) < 2 * tolerance;
        box.add(down(p));
    }
    const double margin = 0.1 * over.length();
    for (int e = 1; e <= section.cad.edges.Extent(); ++e) {
        if (!flat.edges[at(e)].empty()) {
            continue;
        }
        EdgeCurve curve(section.cad.edge(e));
        const auto on_other = [&](double f) {
            const Vec3 here = curve.at(f);
            if (!across) {
                return here.x > box.low.x - margin && here.x < box.high.x + margin &&
                       here.y > box.low.y - margin && here.y < box.high.y + margin &&
                       here.z > box.low.z - margin && here.z < box.high.z + margin &&
                       away(over, here) < tolerance;
            }
            const Vec3 p = here + (level - section.base) * direction;
            return distance(over.at(over.fraction(p)), p) < tolerance;
        };
        if (!on_other(0.5) || !on_other(0.21) || !on_other(0.83)) {
            continue;
        }
        std::vector<double> fractions;
        for (const auto p : points) {
            const Vec3 place = down(layout.points[at(p)]);
            const double f = curve.fraction(place);
            if (f > 1e-6 && f < 1 - 1e-6 && distance(curve.at(f), place) < tolerance) {
                fractions.push_back(f);
            }
        }
        std::sort(fractions.begin(), fractions.end());
        fractions.erase(std::unique(fractions.begin(), fractions.end(),
                                    [](double a, double b) { return b - a < 1e-9; }),
                        fractions.end());
        flat.divide_edge(section.cad, e, fractions);
    }
}

void Taker::quads(int cap, int face) {
    std::vector<std::int32_t> rim;
    for (TopExp_Explorer it(section.cad.face(face), TopAbs_EDGE); it.More(); it.Next()) {
        const auto &points = flat.edges[at(section.cad.edges.FindIndex(it.Current()))];
        if (points.empty()) {
            return;
        }
        rim.insert(rim.end(), points.begin(), points.end());
    }
    std::map<std::int32_t, std::int32_t> number;
    std::vector<Layout::Quad> found;
    const auto normals = sample_normals(section.cad.face(face));
    if (normals.empty()) {
        return;
    }
    for (const auto q : layout.quads_of(cap)) {
        Layout::Quad quad{layout.quads[at(q)].points, face};
        for (auto &p : quad.points) {
            const auto known = number.find(p);
            if (known != number.end()) {
                p = known->second;
                continue;
            }
            const Vec3 place = down(layout.points[at(p)]);
            std::int32_t here = -1;
            if (layout.on[at(p)].dimension < 2) {
                for (const auto r : rim) {
                    here = distance(flat.points[at(r)], place) < tolerance ? r : here;
                }
                if (here < 0) {
                    return; // the cap is more than this face
                }
            } else {
                here = flat.add_point(place, {2, face});
            }
            number[p] = here;
            p = here;
        }
        const auto at_corner = [&](std::size_t i) { return flat.points[at(quad.points[i])]; };
        if (dot(cross(at_corner(2) - at_corner(0), at_corner(3) - at_corner(1)),
                normals.front().normal) < 0) {
            std::swap(quad.points[1], quad.points[3]);
        }
        found.push_back(quad);
    }
    flat.quads.insert(flat.quads.end(), found.begin(), found.end());
}

Vec3 direction_of(const Section &section) {
    const gp_XYZ d = section.motion.axis.Direction().XYZ();
    return {d.X(), d.Y(), d.Z()};
}

} // namespace

std::vector<double> levels_of_neighbours(const CadShape &shape, int solid, Vec3 direction,
                                         double tolerance, const Layout &layout) {
    std::vector<double> result;
    for (const int n : laid_edges(shape, solid, layout)) {
        const auto &points = layout.edges[at(n)];
        const Vec3 first = layout.points[at(points.front())];
        const bool along = std::all_of(points.begin(), points.end(), [&](std::int32_t p) {
            return norm(cross(layout.points[at(p)] - first, direction)) < tolerance;
        });
        for (std::size_t i = 1; along && i + 1 < points.size(); ++i) {
            result.push_back(dot(layout.points[at(points[i])], direction));
        }
    }
    return result;
}

void take_over(const CadShape &shape, int solid, const Section &section, const Layout &layout,
               Layout &flat) {
    const auto edges = laid_edges(shape, solid, layout);
    if (edges.empty() || section.motion.turn) {
        return;
    }
    const double tolerance = 1e-5 * extent_of(shape.solid(solid));
    Taker taker{section, layout, flat, direction_of(section), tolerance};
    for (const int n : edges) {
        taker.edge(shape, n);
    }
    std::set<int> laid;
    for (const auto &quad : layout.quads) {
        laid.insert(quad.face);
    }
    Handle(IntTools_Context) context = new IntTools_Context;
    const EntityLocator locator(shape, solid, tolerance);
    for (const int cap : locator.faces()) {
        if (!laid.contains(cap)) {
            continue;
        }
        const auto normals = sample_normals(shape.face(cap));
        const bool wall = std::all_of(normals.begin(), normals.end(), [&](const auto &n) {
            return std::abs(dot(n.normal, taker.direction)) < 1e-4;
        });
        if (wall) {
            continue;
        }
        IntCurvesFace_Intersector over(shape.face(cap), tolerance);
        std::vector<int> below;
        for (int f = 1; f <= section.cad.faces.Extent(); ++f) {
            gp_Pnt p;
            gp_Pnt2d uv;
            if (BOPTools_AlgoTools3D::PointInFace(section.cad.face(f), p, uv, context) == 0 &&
                (over.Perform(gp_Lin(p, section.motion.axis.Direction()), -1e100, 1e100),
                 over.IsDone() && over.NbPnt() > 0)) {
                below.push_back(f);
            }
        }
        if (below.size() == 1 && flat.quads_of(below.front()).empty()) {
            taker.quads(cap, below.front());
        }
    }
}

} // namespace nmgs::cad
