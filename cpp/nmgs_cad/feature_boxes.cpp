// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/feature_boxes.h"

#include "nmgs_cad/face_normals.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace nmgs::cad {
namespace {

std::vector<std::set<int>> groups_of(const CadShape &shape, const std::set<int> &faces) {
    std::map<int, std::vector<int>> faces_at;
    for (const int f : faces) {
        for (TopExp_Explorer it(shape.face(f), TopAbs_EDGE); it.More(); it.Next()) {
            faces_at[shape.edges.FindIndex(it.Current())].push_back(f);
        }
    }
    std::vector<std::set<int>> result;
    std::set<int> seen;
    for (const int first : faces) {
        if (!seen.insert(first).second) {
            continue;
        }
        std::vector<int> open{first};
        std::set<int> group{first};
        while (!open.empty()) {
            const int f = open.back();
            open.pop_back();
            for (TopExp_Explorer it(shape.face(f), TopAbs_EDGE); it.More(); it.Next()) {
                for (const int g : faces_at[shape.edges.FindIndex(it.Current())]) {
                    if (seen.insert(g).second) {
                        group.insert(g);
                        open.push_back(g);
                    }
                }
            }
        }
        result.push_back(std::move(group));
    }
    return result;
}

// The line that the faces run along: the axis of a round one, or what all normals are square to.
std::optional<Vec3> axis_of(const CadShape &shape, const std::set<int> &faces) {
    std::vector<Vec3> normals;
    for (const int f : faces) {
        const BRepAdaptor_Surface surface(shape.face(f), Standard_False);
        if (surface.GetType() == GeomAbs_Cone) {
            return vec(surface.Cone().Axis().Direction().XYZ());
        }
        if (surface.GetType() == GeomAbs_Cylinder) {
            return vec(surface.Cylinder().Axis().Direction().XYZ());
        }
        for (const auto &sample : sample_normals(shape.face(f))) {
            normals.push_back(sample.normal);
        }
    }
    for (const Vec3 n : normals) {
        const Vec3 c = cross(normals.front(), n);
        if (norm(c) > 0.2) {
            const Vec3 axis = unit(c);
            const bool all = std::all_of(normals.begin(), normals.end(),
                                         [&](Vec3 m) { return std::abs(dot(m, axis)) < 1e-3; });
            return all ? std::optional<Vec3>(axis) : std::nullopt;
        }
    }
    return std::nullopt;
}

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double t) {
        low = std::min(low, t);
        high = std::max(high, t);
    }
    [[nodiscard]] double size() const { return high - low; }
};

std::array<Range, 3> ranges(const TopoDS_Shape &shape, const std::array<Vec3, 3> &axes) {
    std::array<Range, 3> result;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int e = 1; e <= edges.Extent(); ++e) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(e));
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        for (int i = 0; i <= 16; ++i) {
            const double f = i / 16.0;
            const Vec3 p = vec(
                curve.Value((1 - f) * curve.FirstParameter() + f * curve.LastParameter()).XYZ());
            for (std::size_t k = 0; k < 3; ++k) {
                result[k].add(dot(p, axes[k]));
            }
        }
    }
    return result;
}

// Where a side of the box goes that could be `margin` beyond `end`: into a plane of the solid,
// where there is one near.
double side(double end, double margin, const std::vector<double> &levels) {
    double best = end + margin;
    double least = std::abs(margin);
    for (const double t : levels) {
        const double beyond = (t - end) / margin;
        if (beyond > 0.3 && beyond < 1.8 && std::abs(t - end - margin) < least) {
            least = std::abs(t - end - margin);
            best = t;
        }
    }
    return best;
}

struct Feature {
    std::set<int> faces;
    std::array<Vec3, 3> axes{}; // along the sweep, across, and along the feature
    std::array<Range, 3> box;
};

std::optional<Feature> feature_of(const CadShape &shape, const std::set<int> &faces, Vec3 sweep) {
    const auto axis = axis_of(shape, faces);
    if (!axis || std::abs(dot(*axis, sweep)) > 0.02) {
        return std::nullopt;
    }
    const Vec3 u = unit(sweep - dot(sweep, *axis) * *axis);
    Feature feature{faces, {u, unit(cross(*axis, u)), *axis}, {}};
    for (const int f : faces) {
        const auto of_face = ranges(shape.face(f), feature.axes);
        for (std::size_t k = 0; k < 3; ++k) {
            feature.box[k].add(of_face[k].low);
            feature.box[k].add(of_face[k].high);
        }
    }
    return feature;
}

// Whether one lies behind the other, or in it.
bool in_line(const Feature &a, const Feature &b) {
    if (norm(cross(a.axes[2], b.axes[2])) > 1e-3) {
        return false;
    }
    const double sign = dot(a.axes[1], b.axes[1]) < 0 ? -1 : 1;
    const Range other = sign > 0 ? b.box[1] : Range{-b.box[1].high, -b.box[1].low};
    const auto overlap = [](const Range &p, const Range &q) {
        return std::min(p.high, q.high) - std::max(p.low, q.low) >
               -0.05 * std::min(p.size(), q.size());
    };
    return overlap(a.box[0], b.box[0]) && overlap(a.box[1], other);
}

// The groups, and those that lie in line together first.
std::vector<Feature> features_of(const CadShape &shape, const SweepDirection &direction) {
    std::vector<Feature> single;
    for (const auto &group : groups_of(shape, direction.faces)) {
        if (auto feature = feature_of(shape, group, direction.along)) {
            single.push_back(std::move(*feature));
        }
    }
    std::vector<Feature> result;
    std::vector<char> used(single.size(), 0);
    for (std::size_t i = 0; i < single.size(); ++i) {
        if (used[i] != 0) {
            continue;
        }
        Feature all = single[i];
        for (bool grown = true; grown;) {
            grown = false;
            for (std::size_t j = i + 1; j < single.size(); ++j) {
                if (used[j] == 0 && in_line(all, single[j])) {
                    std::set<int> faces = all.faces;
                    faces.insert(single[j].faces.begin(), single[j].faces.end());
                    if (auto both = feature_of(shape, faces, direction.along)) {
                        all = std::move(*both);
                        used[j] = 1;
                        grown = true;
                    }
                }
            }
        }
        if (all.faces.size() > single[i].faces.size()) {
            result.push_back(std::move(all));
        }
    }
    result.insert(result.end(), single.begin(), single.end());
    return result;
}

} // namespace

bool same(const FeatureBox &a, const FeatureBox &b) {
    const double tolerance = 1e-6 * a.sizes[2];
    double apart = distance(a.middle, b.middle);
    for (std::size_t k = 0; k < 3; ++k) {
        apart = std::max(apart, std::abs(a.sizes[k] - b.sizes[k]));
    }
    return apart < tolerance;
}

std::vector<FeatureBox> feature_boxes(const CadShape &shape, int solid,
                                      const SweepDirection &direction, double share) {
    std::vector<FeatureBox> result;
    for (const Feature &feature : features_of(shape, direction)) {
        const auto &axes = feature.axes;
        auto box = feature.box;
        const auto whole = ranges(shape.solid(solid), axes);
        const double margin = share * std::max(box[0].size(), box[1].size());
        for (std::size_t k = 0; k < 2; ++k) {
            std::vector<double> levels;
            for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
                const auto samples = sample_normals(TopoDS::Face(it.Current()));
                if (!samples.empty() &&
                    std::all_of(samples.begin(), samples.end(), [&](const PointNormal &s) {
                        return norm(cross(s.normal, axes[k])) < 1e-4;
                    })) {
                    levels.push_back(dot(samples.front().point, axes[k]));
                }
            }
            box[k] = {side(box[k].low, -margin, levels), side(box[k].high, margin, levels)};
        }
        const double reach = 0.1 * whole[2].size();
        for (const bool through : {false, true}) {
            const Range length = through ? Range{whole[2].low - reach, whole[2].high + reach}
                                         : Range{box[2].low - margin, box[2].high + margin};
            const Vec3 corner = box[0].low * axes[0] + box[1].low * axes[1] + length.low * axes[2];
            const gp_Ax2 frame(gp_Pnt(corner.x, corner.y, corner.z),
                               gp_Dir(axes[2].x, axes[2].y, axes[2].z),
                               gp_Dir(axes[0].x, axes[0].y, axes[0].z));
            FeatureBox made;
            const std::array<Range, 3> sides{box[0], box[1], length};
            for (std::size_t k = 0; k < 3; ++k) {
                made.middle += 0.5 * (sides[k].low + sides[k].high) * axes[k];
                made.sizes[k] = sides[k].size();
            }
            std::sort(made.sizes.begin(), made.sizes.end());
            made.name = "box round " + entity_name(2, *feature.faces.begin());
            const TopoDS_Shape block =
                BRepPrimAPI_MakeBox(frame, box[0].size(), box[1].size(), length.size()).Shape();
            for (TopExp_Explorer it(block, TopAbs_FACE); it.More(); it.Next()) {
                made.faces.Append(it.Current());
            }
            result.push_back(std::move(made));
            if (length.low <= whole[2].low && length.high >= whole[2].high) {
                break;
            }
        }
    }
    return result;
}

} // namespace nmgs::cad
