// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/skin_mesh.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs/support/vec3.h"
#include "nmgs_cad/occt_vec.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <set>

namespace nmgs::cad {
namespace {

using Pair = std::array<std::int32_t, 2>;

std::uint64_t key_of(std::int32_t a, std::int32_t b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U |
           static_cast<std::uint64_t>(std::max(a, b));
}

constexpr double long_edge = 1.4;
constexpr double short_edge = 0.7;
constexpr double least_normal = 0.5; // cosine of a triangle's normal and the surface's
constexpr std::size_t most_triangles = 120000;

} // namespace

EdgeGeometry::EdgeGeometry(const TopoDS_Edge &edge)
    : first(0), last(0), degenerated(BRep_Tool::Degenerated(edge)) {
    if (!degenerated) {
        curve.Initialize(edge);
        first = curve.FirstParameter();
        last = curve.LastParameter();
    }
}

SkinMesh::SkinMesh(const CadShape &shape, const SkinOptions &options)
    : bound(at(shape.edges.Extent()) + 1, 0), inner(at(shape.edges.Extent()) + 1, 0),
      face_turn(at(shape.faces.Extent()) + 1, 1), edge_turn(at(shape.edges.Extent()) + 1, 1),
      diagonal(shape.diagonal()), shape_(shape), options_(options),
      faces_(at(shape.faces.Extent()) + 1), edges_(at(shape.edges.Extent()) + 1),
      face_scale_(at(shape.faces.Extent()) + 1, diagonal),
      edge_scale_(at(shape.edges.Extent()) + 1, diagonal) {
    for (int n = 1; n <= shape.solids.Extent(); ++n) {
        Bnd_Box box;
        BRepBndLib::Add(shape.solid(n), box, Standard_False);
        const double scale = box.IsVoid() ? diagonal : std::sqrt(box.SquareExtent());
        for (TopExp_Explorer f(shape.solid(n), TopAbs_FACE); f.More(); f.Next()) {
            double &known = face_scale_[at(shape.faces.FindIndex(f.Current()))];
            known = std::min(known, scale);
        }
        for (TopExp_Explorer e(shape.solid(n), TopAbs_EDGE); e.More(); e.Next()) {
            double &known = edge_scale_[at(shape.edges.FindIndex(e.Current()))];
            known = std::min(known, scale);
        }
    }
}

const FaceGeometry &SkinMesh::face(std::int32_t n) const {
    auto &geometry = faces_[at(n)];
    if (!geometry) {
        geometry = std::make_unique<FaceGeometry>(shape_.face(n));
    }
    return *geometry;
}

const EdgeGeometry &SkinMesh::edge(std::int32_t n) const {
    auto &geometry = edges_[at(n)];
    if (!geometry) {
        geometry = std::make_unique<EdgeGeometry>(shape_.edge(n));
    }
    return *geometry;
}

bool SkinMesh::closed(std::int32_t n) const {
    return TopExp::FirstVertex(shape_.edge(n)).IsSame(TopExp::LastVertex(shape_.edge(n)));
}

void SkinMesh::add_triangle(std::array<std::int32_t, 3> p, std::int32_t face) {
    around.resize(points.size());
    const auto number = static_cast<std::int32_t>(triangles.size());
    triangles.push_back({p, face});
    for (const std::int32_t n : p) {
        around[at(n)].push_back(number);
    }
}

void SkinMesh::add_segment(std::int32_t a, std::int32_t b, std::int32_t edge) {
    segments_[ascending(a, b)] = edge;
}

std::int32_t SkinMesh::segment(std::int32_t a, std::int32_t b) const {
    if (points[at(a)].on.dimension == 2 || points[at(b)].on.dimension == 2) {
        return 0;
    }
    const auto found = segments_.find(ascending(a, b));
    return found == segments_.end() ? 0 : found->second;
}

std::array<double, 2> SkinMesh::parameters(std::int32_t a, std::int32_t b,
                                           std::int32_t edge) const {
    const EdgeGeometry &geometry = this->edge(edge);
    const auto is_on = [&](std::int32_t n) { return points[at(n)].on.dimension == 1; };
    if (is_on(a) && is_on(b)) {
        return {points[at(a)].t, points[at(b)].t};
    }
    if (is_on(a)) {
        return {points[at(a)].t, points[at(a)].previous == b ? geometry.first : geometry.last};
    }
    if (is_on(b)) {
        return {points[at(b)].previous == a ? geometry.first : geometry.last, points[at(b)].t};
    }
    const auto start = shape_.vertices.FindIndex(TopExp::FirstVertex(shape_.edge(edge)));
    return points[at(a)].on.index == start ? std::array{geometry.first, geometry.last}
                                           : std::array{geometry.last, geometry.first};
}

const SkinMesh::Corner &SkinMesh::corner(std::int32_t face, std::int32_t point) {
    if (corners_.size() < points.size()) {
        corners_.resize(points.size() + points.size() / 2);
    }
    auto &known = corners_[at(point)];
    for (const auto &[f, c] : known) {
        if (f == face) {
            return c;
        }
    }
    const SkinPoint &p = points[at(point)];
    const FaceGeometry &geometry = this->face(face);
    Corner corner;
    bool pole = false;
    if (p.on.dimension == 2) {
        corner.uv = p.uv;
    } else if (p.on.dimension == 1) {
        auto [curve, fresh] = pcurves_.try_emplace({face, p.on.index});
        if (fresh) {
            double first = 0;
            double last = 0;
            curve->second = BRep_Tool::CurveOnSurface(TopoDS::Edge(shape_.edge(p.on.index)),
                                                      shape_.face(face), first, last);
        }
        if (curve->second.IsNull()) {
            corner.uv = geometry.nearest(p.p, {});
        } else {
            const gp_Pnt2d uv = curve->second->Value(p.t);
            corner.uv = {uv.X(), uv.Y()};
        }
    } else {
        bool found = false;
        for (TopExp_Explorer e(shape_.face(face), TopAbs_EDGE); e.More() && !pole; e.Next()) {
            const TopoDS_Edge &side = TopoDS::Edge(e.Current());
            for (const TopoDS_Vertex &v : {TopExp::FirstVertex(side), TopExp::LastVertex(side)}) {
                if (v.IsNull() || shape_.vertices.FindIndex(v) != p.on.index) {
                    continue;
                }
                pole = pole || BRep_Tool::Degenerated(side);
                if (!found) {
                    try {
                        const gp_Pnt2d uv = BRep_Tool::Parameters(v, shape_.face(face));
                        corner.uv = {uv.X(), uv.Y()};
                        found = true;
                    } catch (const Standard_Failure &) {
                        found = false;
                    }
                }
            }
        }
        if (!found) {
            corner.uv = geometry.nearest(p.p, {});
        }
    }
    if (!pole) {
        corner.frame = geometry.frame(corner.uv);
    }
    known.emplace_back(face, corner);
    return known.back().second;
}

std::vector<std::int32_t> SkinMesh::between(std::int32_t a, std::int32_t b,
                                            std::int32_t face) const {
    std::vector<std::int32_t> result;
    for (const std::int32_t t : around[at(a)]) {
        const Triangle &triangle = triangles[at(t)];
        if ((face == 0 || triangle.face == face) &&
            std::find(triangle.p.begin(), triangle.p.end(), b) != triangle.p.end()) {
            result.push_back(t);
        }
    }
    return result;
}

double SkinMesh::turn_allowed(double curvature, double scale) const {
    // Features under a twentieth of the solid matter less and less: down to a hundredth.
    const double radius = 1 / std::max(curvature * scale, 1e-9);
    const double share = std::clamp(std::log(0.05 / radius) / std::log(5.0), 0.0, 1.0);
    return std::min(options_.angle * (1 + share), std::numbers::pi / 3);
}

Vec3 SkinMesh::tangent(std::int32_t edge, double t) const {
    gp_Pnt p;
    gp_Vec d;
    this->edge(edge).curve.D1(t, p, d);
    const double l = d.Magnitude();
    return l > 0 ? (1 / l) * vec(d.XYZ()) : Vec3{0, 0, 0};
}

double SkinMesh::turn_along(std::int32_t a, std::int32_t b, std::int32_t edge) {
    const EdgeGeometry &geometry = this->edge(edge);
    if (geometry.curve.GetType() == GeomAbs_Line) {
        return 0;
    }
    const auto [known, fresh] = turns_.try_emplace(key_of(a, b), 0);
    if (!fresh) {
        return known->second;
    }
    const auto [ta, tb] = parameters(a, b, edge);
    const double middle = 0.5 * (ta + tb);
    const Vec3 m = tangent(edge, middle);
    return known->second =
               angle_between(tangent(edge, ta), m) + angle_between(m, tangent(edge, tb));
}

double SkinMesh::length(std::int32_t a, std::int32_t b, std::int32_t face) {
    return length(a, b, face, 2 / (1 / points[at(a)].size + 1 / points[at(b)].size));
}

double SkinMesh::length(std::int32_t a, std::int32_t b, std::int32_t face, double size) {
    const double d = distance(points[at(a)].p, points[at(b)].p);
    const double plain = d / size;
    double turn = 0;
    double share = 1; // what is curved both ways loses twice the volume
    const std::int32_t edge = segment(a, b);
    if (edge != 0) {
        turn = turn_along(a, b, edge);
    } else if (!this->face(face).planar()) {
        const SurfaceFrame fa = corner(face, a).frame;
        const SurfaceFrame fb = corner(face, b).frame;
        const Vec3 along = points[at(b)].p - points[at(a)].p;
        if (fa.regular && fb.regular) {
            turn = std::max(angle_between(fa.normal, fb.normal),
                            0.5 * d * (fa.along(along) + fb.along(along)));
            const bool both = std::abs(fa.minor) > 0.4 * std::abs(fa.major) &&
                              std::abs(fb.minor) > 0.4 * std::abs(fb.major);
            share = both ? 0.75 : 1;
        } else if (fa.regular || fb.regular) {
            turn = d * (fa.regular ? fa : fb).along(along);
        }
    }
    const double scale = edge != 0 ? edge_scale_[at(edge)] : face_scale_[at(face)];
    share *= edge != 0 ? edge_turn[at(edge)] : face_turn[at(face)];
    return d > 0 ? std::max(plain, turn / (share * turn_allowed(turn / d, scale))) : 0;
}

SkinMesh::Score SkinMesh::score(std::int32_t face, const std::array<std::int32_t, 3> &p) {
    const std::array<Vec3, 3> where{points[at(p[0])].p, points[at(p[1])].p, points[at(p[2])].p};
    const std::array<SurfaceFrame, 3> frames{corner(face, p[0]).frame, corner(face, p[1]).frame,
                                             corner(face, p[2]).frame};
    Score result{normal_of(where, frames), 0};
    std::array<double, 3> l{};
    // One wanted length for all three sides: theirs would not make a triangle.
    double size = 0;
    for (const std::int32_t n : p) {
        size += points[at(n)].size / 3;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        l[i] = length(p[i], p[(i + 1) % 3], face, size);
    }
    const double s = 0.5 * (l[0] + l[1] + l[2]);
    const double area2 = s * (s - l[0]) * (s - l[1]) * (s - l[2]);
    const double metric = area2 > 0 ? 4 * std::numbers::sqrt3 * std::sqrt(area2) /
                                          (l[0] * l[0] + l[1] * l[1] + l[2] * l[2])
                                    : 0;
    const double area = 0.5 * norm(cross(where[1] - where[0], where[2] - where[0]));
    const double sides =
        norm2(where[1] - where[0]) + norm2(where[2] - where[1]) + norm2(where[0] - where[2]);
    const double plain = sides > 0 ? 4 * std::numbers::sqrt3 * area / sides : 0;
    // The metric may not excuse what is flat in space.
    result.quality = std::min(std::max(metric, 0.3 * plain), 4 * plain);
    return result;
}

double SkinMesh::normal_of(const std::array<Vec3, 3> &where,
                           const std::array<SurfaceFrame, 3> &frames) const {
    const Vec3 n = cross(where[1] - where[0], where[2] - where[0]);
    const double l = norm(n);
    double worst = 1;
    for (const SurfaceFrame &frame : frames) {
        if (frame.regular) {
            worst = std::min(worst, l > 0 ? dot(n, frame.normal) / l : -1.0);
        }
    }
    return worst;
}

namespace {

// One number to raise: quality, less where the triangle leaves the surface's direction.
double worth(double normal, double quality) {
    return normal <= 0 ? normal - 1 : quality * std::min(1.0, normal / 0.7);
}

} // namespace

std::int32_t SkinMesh::new_point(const SkinPoint &point) {
    points.push_back(point);
    around.emplace_back();
    return static_cast<std::int32_t>(points.size()) - 1;
}

void SkinMesh::remove(std::int32_t triangle) {
    for (const std::int32_t n : triangles[at(triangle)].p) {
        std::erase(around[at(n)], triangle);
    }
    triangles[at(triangle)].face = 0;
}

void SkinMesh::replace(std::int32_t triangle, std::int32_t from, std::int32_t to) {
    auto &p = triangles[at(triangle)].p;
    std::replace(p.begin(), p.end(), from, to);
    std::erase(around[at(from)], triangle);
    around[at(to)].push_back(triangle);
}

std::vector<std::array<std::int32_t, 3>> SkinMesh::edges() const {
    std::vector<std::array<std::int32_t, 3>> found;
    found.reserve(3 * triangles.size());
    for (const Triangle &triangle : triangles) {
        for (std::size_t i = 0; i < 3 && triangle.face != 0; ++i) {
            const Pair key = ascending(triangle.p[i], triangle.p[(i + 1) % 3]);
            found.push_back({key[0], key[1], triangle.face});
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (auto &e : found) {
        e[2] = segment(e[0], e[1]) != 0 ? 0 : e[2];
    }
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

bool SkinMesh::split(std::int32_t a, std::int32_t b, std::int32_t face, bool force, double share) {
    const std::int32_t edge = face == 0 ? segment(a, b) : 0;
    SkinPoint m;
    m.size = 0.5 * (points[at(a)].size + points[at(b)].size);
    if (edge != 0) {
        const EdgeGeometry &geometry = this->edge(edge);
        const auto [ta, tb] = parameters(a, b, edge);
        m.on = {1, edge};
        m.t = 0.5 * (ta + tb);
        if (geometry.curve.GetType() != GeomAbs_Line &&
            geometry.curve.GetType() != GeomAbs_Circle) {
            const double length = GCPnts_AbscissaPoint::Length(geometry.curve, std::min(ta, tb),
                                                               std::max(ta, tb), 1e-6 * diagonal);
            const GCPnts_AbscissaPoint half(geometry.curve, 0.5 * length, std::min(ta, tb));
            if (half.IsDone() && (half.Parameter() - ta) * (half.Parameter() - tb) < 0) {
                m.t = half.Parameter();
            }
        }
        if (m.t == ta || m.t == tb) {
            return false;
        }
        m.p = vec(geometry.curve.Value(m.t).XYZ());
        m.previous = ta < tb ? a : b;
        m.next = ta < tb ? b : a;
    } else {
        const Vec3 middle = 0.5 * (points[at(a)].p + points[at(b)].p);
        const double l = distance(points[at(a)].p, points[at(b)].p);
        const FaceGeometry &geometry = this->face(face);
        m.on = {2, face};
        m.uv = geometry.nearest(middle, corner(face, a).uv);
        m.p = geometry.at(m.uv);
        if (distance(m.p, middle) > 0.3 * l && !geometry.elementary()) {
            const Uv other = geometry.nearest(middle, corner(face, b).uv);
            if (distance(geometry.at(other), middle) < distance(m.p, middle)) {
                m.uv = other;
                m.p = geometry.at(other);
            }
        }
        if (distance(m.p, middle) > 0.5 * l) {
            return false;
        }
    }
    const auto touched = between(a, b, face);
    if (touched.empty()) {
        return false;
    }
    const std::int32_t n = new_point(m);
    if (!force) {
        for (const std::int32_t t : touched) {
            const Triangle triangle = triangles[at(t)];
            const Score before = score(triangle.face, triangle.p);
            for (const std::int32_t old : {a, b}) {
                auto p = triangle.p;
                std::replace(p.begin(), p.end(), old, n);
                const Score after = score(triangle.face, p);
                if (after.normal < share * std::min(least_normal, before.normal) ||
                    after.quality < share * std::min(0.1, 0.3 * before.quality)) {
                    points.pop_back();
                    around.pop_back();
                    corners_[at(n)].clear();
                    return false;
                }
            }
        }
    }
    for (const std::int32_t t : touched) {
        auto p = triangles[at(t)].p;
        replace(t, b, n);
        std::replace(p.begin(), p.end(), a, n);
        add_triangle(p, triangles[at(t)].face);
    }
    if (edge != 0) {
        segments_.erase(ascending(a, b));
        add_segment(a, n, edge);
        add_segment(n, b, edge);
        for (const std::int32_t end : {m.previous, m.next}) {
            if (points[at(end)].on.dimension == 1) {
                (end == m.previous ? points[at(end)].next : points[at(end)].previous) = n;
            }
        }
        ++inner[at(edge)];
    }
    return true;
}

bool SkinMesh::collapse(std::int32_t from, std::int32_t to, bool force) {
    const SkinPoint &gone = points[at(from)];
    if (gone.kept || gone.on.dimension == 0) {
        return false;
    }
    const std::int32_t edge = segment(from, to);
    std::int32_t beyond = -1;
    if (gone.on.dimension == 1) {
        if (edge != gone.on.index || (gone.previous != to && gone.next != to)) {
            return false;
        }
        beyond = gone.previous == to ? gone.next : gone.previous;
        if (beyond == to || beyond < 0 || !between(beyond, to).empty()) {
            return false;
        }
        if (closed(edge) && inner[at(edge)] < 3) {
            return false;
        }
    }
    std::set<std::int32_t> near_to;
    for (const std::int32_t t : around[at(to)]) {
        near_to.insert(triangles[at(t)].p.begin(), triangles[at(t)].p.end());
    }
    std::set<std::int32_t> common;
    std::set<std::int32_t> opposite;
    double worst_before = 1;
    double quality_before = 1;
    for (const std::int32_t t : around[at(from)]) {
        const auto &p = triangles[at(t)].p;
        const bool both = std::find(p.begin(), p.end(), to) != p.end();
        for (const std::int32_t n : p) {
            if (n != from && n != to) {
                if (near_to.contains(n)) {
                    common.insert(n);
                }
                if (both) {
                    opposite.insert(n);
                }
            }
        }
        const Score s = score(triangles[at(t)].face, p);
        worst_before = std::min(worst_before, s.normal);
        quality_before = std::min(quality_before, s.quality);
    }
    if (common != opposite || opposite.empty()) {
        return false;
    }
    std::set<std::array<std::int32_t, 3>> sets;
    for (const std::int32_t t : around[at(to)]) {
        auto p = triangles[at(t)].p;
        std::sort(p.begin(), p.end());
        sets.insert(p);
    }
    for (const std::int32_t t : around[at(from)]) {
        auto p = triangles[at(t)].p;
        const std::int32_t face = triangles[at(t)].face;
        if (std::find(p.begin(), p.end(), to) != p.end()) {
            continue;
        }
        std::replace(p.begin(), p.end(), from, to);
        auto sorted = p;
        std::sort(sorted.begin(), sorted.end());
        if (!sets.insert(sorted).second) {
            return false;
        }
        const Score s = score(face, p);
        const double floor = force ? 0.1 : least_normal;
        if (s.normal < std::min(floor, worst_before) ||
            s.quality < std::min(force ? 1e-3 : 0.2, quality_before)) {
            return false;
        }
        for (const std::int32_t n : p) {
            const bool fresh = n != to && segment(from, n) == 0;
            if (!force && fresh && length(to, n, face) > long_edge) {
                return false;
            }
        }
    }
    if (!force && beyond >= 0) {
        // The new segment's own turn, measured as if it were there.
        add_segment(to, beyond, edge);
        SkinPoint saved_to = points[at(to)];
        SkinPoint saved_beyond = points[at(beyond)];
        const bool back = gone.previous == to;
        if (saved_to.on.dimension == 1) {
            (back ? points[at(to)].next : points[at(to)].previous) = beyond;
        }
        if (saved_beyond.on.dimension == 1) {
            (back ? points[at(beyond)].previous : points[at(beyond)].next) = to;
        }
        const bool too_long = length(to, beyond, 0) > long_edge;
        points[at(to)] = saved_to;
        points[at(beyond)] = saved_beyond;
        segments_.erase(ascending(to, beyond));
        if (too_long) {
            return false;
        }
    }
    const auto old = around[at(from)];
    for (const std::int32_t t : old) {
        const auto &p = triangles[at(t)].p;
        if (std::find(p.begin(), p.end(), to) != p.end()) {
            remove(t);
        } else {
            replace(t, from, to);
        }
    }
    if (beyond >= 0) {
        segments_.erase(ascending(from, to));
        segments_.erase(ascending(from, beyond));
        add_segment(to, beyond, edge);
        const bool back = gone.previous == to;
        if (points[at(to)].on.dimension == 1) {
            (back ? points[at(to)].next : points[at(to)].previous) = beyond;
        }
        if (points[at(beyond)].on.dimension == 1) {
            (back ? points[at(beyond)].previous : points[at(beyond)].next) = to;
        }
        --inner[at(edge)];
    }
    points[at(from)].alive = false;
    return true;
}

bool SkinMesh::flip(std::int32_t a, std::int32_t b) {
    if (segment(a, b) != 0) {
        return false;
    }
    const auto both = between(a, b);
    if (both.size() != 2 || triangles[at(both[0])].face != triangles[at(both[1])].face) {
        return false;
    }
    const std::int32_t face = triangles[at(both[0])].face;
    const auto third = [&](std::int32_t t) {
        for (const std::int32_t n : triangles[at(t)].p) {
            if (n != a && n != b) {
                return n;
            }
        }
        return a;
    };
    // The first triangle runs from a to b.
    std::size_t one = 0;
    const auto &p = triangles[at(both[0])].p;
    for (std::size_t i = 0; i < 3; ++i) {
        if (p[i] == b && p[(i + 1) % 3] == a) {
            one = 1;
        }
    }
    const std::int32_t c = third(both[one]);
    const std::int32_t d = third(both[1 - one]);
    if (c == d || !between(c, d).empty()) {
        return false;
    }
    const std::array<std::int32_t, 3> first{a, d, c};
    const std::array<std::int32_t, 3> second{d, b, c};
    double before = 2;
    for (const std::int32_t t : both) {
        const Score s = score(face, triangles[at(t)].p);
        before = std::min(before, worth(s.normal, s.quality));
    }
    double after = 2;
    for (const auto &t : {first, second}) {
        const Score s = score(face, t);
        after = std::min(after, worth(s.normal, s.quality));
    }
    if (after <= before + 1e-4) {
        return false;
    }
    remove(both[0]);
    remove(both[1]);
    add_triangle(first, face);
    add_triangle(second, face);
    return true;
}

void SkinMesh::split_long() {
    // Only the longest edge of a triangle is split, and the triangles are flipped before the next
    // sweep: else thin triangles have thin children.
    for (int sweep = 0; sweep < 24; ++sweep) {
        std::vector<std::pair<double, std::array<std::int32_t, 3>>> wanted;
        for (const auto &e : edges()) {
            const std::int32_t edge = e[2] == 0 ? segment(e[0], e[1]) : 0;
            if (edge != 0 && bound[at(edge)] != 0) {
                continue;
            }
            const double l = length(e[0], e[1], e[2]);
            if (l > long_edge) {
                wanted.emplace_back(-l, e);
            }
        }
        std::sort(wanted.begin(), wanted.end());
        int done = 0;
        const std::size_t old_points = points.size();
        std::vector<char> touched(triangles.size(), 0);
        for (const auto &[l, e] : wanted) {
            if (triangles.size() > 4 * most_triangles) {
                break;
            }
            const auto own = between(e[0], e[1], e[2]);
            const bool taken = std::any_of(own.begin(), own.end(), [&](std::int32_t t) {
                return at(t) >= touched.size() || touched[at(t)] != 0;
            });
            // Much too long edges of the CAD stand in the way of all others.
            constexpr double much = 2;
            const double share = e[2] == 0 && -l > much ? 0.1 : 1;
            if (!taken && split(e[0], e[1], e[2], false, share)) {
                ++done;
                for (const std::int32_t t : own) {
                    touched[at(t)] = 1;
                }
            }
        }
        if (done == 0) {
            break;
        }
        std::set<Pair> fresh;
        for (std::size_t n = old_points; n < points.size(); ++n) {
            for (const std::int32_t t : around[n]) {
                const auto &p = triangles[at(t)].p;
                for (std::size_t i = 0; i < 3; ++i) {
                    fresh.insert(ascending(p[i], p[(i + 1) % 3]));
                }
            }
        }
        flip({fresh.begin(), fresh.end()});
    }
}

void SkinMesh::collapse_short() {
    for (int sweep = 0; sweep < 6; ++sweep) {
        std::vector<std::pair<double, std::array<std::int32_t, 3>>> wanted;
        for (const auto &e : edges()) {
            const double l = length(e[0], e[1], e[2]);
            bool must = false;
            for (const std::int32_t n : {e[0], e[1]}) {
                const SkinPoint &p = points[at(n)];
                must = must ||
                       (e[2] == 0 && p.on.dimension == 1 && !p.kept && bound[at(p.on.index)] != 0);
            }
            if (l < short_edge || must) {
                wanted.emplace_back(must ? 0 : l, e);
            }
        }
        std::sort(wanted.begin(), wanted.end());
        int done = 0;
        for (const auto &[l, e] : wanted) {
            std::int32_t from = e[0];
            std::int32_t to = e[1];
            if (!points[at(from)].alive || !points[at(to)].alive || between(from, to).empty()) {
                continue;
            }
            if (points[at(from)].on.dimension < points[at(to)].on.dimension) {
                std::swap(from, to);
            }
            const bool force = l == 0;
            if (collapse(from, to, force) || collapse(to, from, force)) {
                ++done;
            }
        }
        if (done == 0) {
            break;
        }
    }
}

void SkinMesh::flip() {
    std::vector<std::array<std::int32_t, 2>> work;
    for (const auto &e : edges()) {
        if (e[2] != 0) {
            work.push_back({e[0], e[1]});
        }
    }
    flip(std::move(work));
}

void SkinMesh::flip(std::vector<std::array<std::int32_t, 2>> work) {
    // What a flip changed is looked at again in the next round.
    for (int round = 0; round < 4 && !work.empty(); ++round) {
        std::set<Pair> after;
        for (const auto &e : work) {
            const std::size_t count = triangles.size();
            if (!flip(e[0], e[1])) {
                continue;
            }
            for (std::size_t t = count; t < triangles.size(); ++t) {
                for (std::size_t i = 0; i < 3; ++i) {
                    after.insert(ascending(triangles[t].p[i], triangles[t].p[(i + 1) % 3]));
                }
            }
        }
        work.assign(after.begin(), after.end());
    }
}

void SkinMesh::forget(std::int32_t n) {
    corners_[at(n)].clear();
    if (points[at(n)].on.dimension == 1) {
        turns_.erase(key_of(n, points[at(n)].previous));
        turns_.erase(key_of(n, points[at(n)].next));
    }
}

bool SkinMesh::smooth_point(std::int32_t n) {
    const SkinPoint old = points[at(n)];
    if (!old.alive || old.kept || old.on.dimension == 0 || around[at(n)].empty()) {
        return false;
    }
    const auto worths = [&] {
        double least = 2;
        double sum = 0;
        for (const std::int32_t t : around[at(n)]) {
            const Score s = score(triangles[at(t)].face, triangles[at(t)].p);
            least = std::min(least, worth(s.normal, s.quality));
            sum += worth(s.normal, s.quality);
        }
        return std::array{least, sum};
    };
    const auto before = worths();
    Vec3 target{0, 0, 0};
    double t_target = 0;
    if (old.on.dimension == 2) {
        double weights = 0;
        std::set<std::int32_t> near;
        for (const std::int32_t t : around[at(n)]) {
            near.insert(triangles[at(t)].p.begin(), triangles[at(t)].p.end());
        }
        near.erase(n);
        for (const std::int32_t m : near) {
            const double l = length(n, m, old.on.index);
            const double w = std::max(l * l, 1e-3);
            target += w * points[at(m)].p;
            weights += w;
        }
        target = (1 / weights) * target;
    } else {
        const double lp = length(old.previous, n, 0);
        const double ln = length(n, old.next, 0);
        const double tp = parameters(n, old.previous, old.on.index)[1];
        const double tn = parameters(n, old.next, old.on.index)[1];
        t_target = ln > lp ? old.t + (tn - old.t) * 0.5 * (ln - lp) / ln
                           : old.t + (tp - old.t) * 0.5 * (lp - ln) / lp;
    }
    for (double step = 1; step > 0.2; step *= 0.5) {
        SkinPoint &p = points[at(n)];
        if (old.on.dimension == 2) {
            const FaceGeometry &geometry = this->face(old.on.index);
            const Vec3 wanted = old.p + step * (target - old.p);
            p.uv = geometry.nearest(wanted, old.uv);
            p.p = geometry.at(p.uv);
            if (distance(p.p, wanted) > 0.5 * p.size) {
                p = old;
                continue;
            }
        } else {
            p.t = old.t + step * (t_target - old.t);
            p.p = vec(edge(old.on.index).curve.Value(p.t).XYZ());
        }
        forget(n);
        const auto after = worths();
        if (after[0] > before[0] + 1e-6 || (after[0] > 0.4 && after[1] > before[1])) {
            return true;
        }
        p = old;
        forget(n);
    }
    return false;
}

void SkinMesh::smooth() {
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(points.size()); ++n) {
        smooth_point(n);
    }
}

void SkinMesh::find_sizes(const std::vector<double> &also) {
    const double longest = options_.size > 0 ? options_.size : diagonal / 6;
    const double tiny = diagonal / 400;
    using Item = std::pair<double, std::int32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    const auto count = static_cast<std::int32_t>(points.size());
    for (std::int32_t n = 0; n < count; ++n) {
        SkinPoint &p = points[at(n)];
        if (!p.alive) {
            continue;
        }
        double h = longest;
        std::set<std::int32_t> faces;
        for (const std::int32_t t : around[at(n)]) {
            faces.insert(triangles[at(t)].face);
        }
        for (const std::int32_t f : faces) {
            if (face(f).planar()) {
                continue;
            }
            const SurfaceFrame frame = corner(f, n).frame;
            const double k = std::max(std::abs(frame.major), 1e-12 / diagonal);
            if (frame.regular) {
                h = std::min(h, std::max(tiny, options_.stretch * face_turn[at(f)] *
                                                   turn_allowed(k, face_scale_[at(f)]) / k));
            }
        }
        if (p.on.dimension == 1 && edge(p.on.index).curve.GetType() != GeomAbs_Line) {
            gp_Pnt q;
            gp_Vec d1;
            gp_Vec d2;
            edge(p.on.index).curve.D2(p.t, q, d1, d2);
            const double l = d1.Magnitude();
            const double k = l > 0 ? d1.Crossed(d2).Magnitude() / (l * l * l) : 0;
            if (k > 0) {
                h = std::min(h,
                             std::max(tiny, edge_turn[at(p.on.index)] *
                                                turn_allowed(k, edge_scale_[at(p.on.index)]) / k));
            }
        }
        if (at(n) < also.size()) {
            h = std::min(h, also[at(n)]);
        }
        for (const auto &limit : options_.limits) {
            if (norm2(limit.place - p.p) < limit.radius * limit.radius) {
                h = std::min(h, limit.size);
            }
        }
        p.size = h;
    }
    // Edges that cannot be longer.
    for (const auto &[ends, edge] : segments_) {
        const bool given = bound[at(edge)] != 0;
        const double l = distance(points[at(ends[0])].p, points[at(ends[1])].p);
        if (given ||
            (points[at(ends[0])].on.dimension == 0 && points[at(ends[1])].on.dimension == 0)) {
            for (const std::int32_t n : ends) {
                points[at(n)].size = std::min(points[at(n)].size, 1.2 * l);
            }
        }
    }
    for (std::int32_t n = 0; n < count; ++n) {
        if (points[at(n)].alive) {
            queue.emplace(points[at(n)].size, n);
        }
    }
    while (!queue.empty()) {
        const auto [h, n] = queue.top();
        queue.pop();
        if (h > points[at(n)].size) {
            continue;
        }
        for (const std::int32_t t : around[at(n)]) {
            for (const std::int32_t m : triangles[at(t)].p) {
                const double bound_here =
                    h + options_.grading * distance(points[at(n)].p, points[at(m)].p);
                if (bound_here < points[at(m)].size) {
                    points[at(m)].size = bound_here;
                    queue.emplace(bound_here, m);
                }
            }
        }
    }
}

void SkinMesh::pass(const Progress &progress, double from, double to) {
    split_long();
    poll(progress, from + 0.3 * (to - from));
    collapse_short();
    poll(progress, from + 0.6 * (to - from));
    flip();
    smooth();
    poll(progress, to);
}

double SkinMesh::corner_angle(std::int32_t b, std::int32_t a, std::int32_t c) {
    const auto away = [&](std::int32_t n) {
        const std::int32_t e = segment(b, n);
        const auto [tb, tn] = parameters(b, n, e);
        const Vec3 d = tangent(e, tb);
        return tn > tb ? d : -1.0 * d;
    };
    return angle_between(away(a), away(c));
}

void SkinMesh::part_twins() {
    std::map<Pair, std::set<std::int32_t>> faces;
    for (const Triangle &t : triangles) {
        for (std::size_t i = 0; i < 3 && t.face != 0; ++i) {
            faces[ascending(t.p[i], t.p[(i + 1) % 3])].insert(t.face);
        }
    }
    for (const auto &[ends, on] : faces) {
        const std::int32_t edge = segment(ends[0], ends[1]);
        bool first = edge == 0;
        for (const std::int32_t f : on) {
            bool own = false;
            for (TopExp_Explorer e(shape_.face(f), TopAbs_EDGE); edge != 0 && e.More(); e.Next()) {
                own = own || shape_.edges.FindIndex(e.Current()) == edge;
            }
            if (!own && !first) {
                split(ends[0], ends[1], f, true);
            }
            first = false;
        }
    }
}

void SkinMesh::drop_flat() {
    constexpr double flat = 0.01; // height by the longest side
    for (int round = 0; round < 3; ++round) {
        bool any = false;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const Triangle triangle = triangles[t];
            if (triangle.face == 0) {
                continue;
            }
            std::size_t longest = 0; // the side after this corner
            std::array<double, 3> l{};
            for (std::size_t i = 0; i < 3; ++i) {
                l[i] = distance(points[at(triangle.p[i])].p, points[at(triangle.p[(i + 1) % 3])].p);
                longest = l[i] > l[longest] ? i : longest;
            }
            const std::int32_t a = triangle.p[longest];
            const std::int32_t b = triangle.p[(longest + 1) % 3];
            const std::int32_t apex = triangle.p[(longest + 2) % 3];
            const Vec3 o = points[at(a)].p;
            const double doubled = norm(cross(points[at(b)].p - o, points[at(apex)].p - o));
            if (doubled > flat * l[longest] * l[longest]) {
                continue;
            }
            // The point between goes, or another edge parts the two triangles, or the long side
            // gets a point on the CAD there.
            if (flip(a, b)) {
                any = true;
                continue;
            }
            std::vector<std::int32_t> near;
            for (const std::int32_t s : around[at(apex)]) {
                for (const std::int32_t n : triangles[at(s)].p) {
                    if (n != apex && std::find(near.begin(), near.end(), n) == near.end()) {
                        near.push_back(n);
                    }
                }
            }
            std::sort(near.begin(), near.end(), [&](std::int32_t m, std::int32_t n) {
                return distance(points[at(m)].p, points[at(apex)].p) <
                       distance(points[at(n)].p, points[at(apex)].p);
            });
            const bool gone = points[at(apex)].on.dimension == 2 &&
                              std::any_of(near.begin(), near.end(),
                                          [&](std::int32_t n) { return collapse(apex, n, true); });
            any = gone || split(a, b, segment(a, b) != 0 ? 0 : triangle.face, true) || any;
        }
        if (!any) {
            break;
        }
    }
}

void SkinMesh::cut_ears() {
    constexpr double flat = 2.5; // radians
    const auto ear = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        return segment(a, b) != 0 && segment(b, c) != 0 && corner_angle(b, a, c) > flat;
    };
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle triangle = triangles[t];
        if (triangle.face == 0) {
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t b = triangle.p[i];
            const std::int32_t c = triangle.p[(i + 1) % 3];
            const std::int32_t a = triangle.p[(i + 2) % 3];
            if (!ear(a, b, c)) {
                continue;
            }
            if (segment(a, c) != 0) {
                SkinPoint m;
                const Vec3 middle =
                    (1.0 / 3) * (points[at(a)].p + points[at(b)].p + points[at(c)].p);
                const FaceGeometry &geometry = face(triangle.face);
                m.on = {2, triangle.face};
                m.uv = geometry.nearest(middle, corner(triangle.face, a).uv);
                m.p = geometry.at(m.uv);
                m.size = points[at(b)].size;
                const std::int32_t n = new_point(m);
                remove(static_cast<std::int32_t>(t));
                for (std::size_t k = 0; k < 3; ++k) {
                    add_triangle({triangle.p[k], triangle.p[(k + 1) % 3], n}, triangle.face);
                }
                break;
            }
            // A new edge from b: to the point across the opposite edge, or to that edge's middle.
            const auto both = between(a, c, triangle.face);
            bool good = false;
            if (both.size() == 2 && between(a, c).size() == 2) {
                std::int32_t d = -1;
                for (const std::int32_t s : both) {
                    for (const std::int32_t n : triangles[at(s)].p) {
                        if (n != a && n != c && n != b) {
                            d = n;
                        }
                    }
                }
                if (d >= 0 && between(b, d).empty() && !ear(b, c, d) && !ear(b, a, d)) {
                    const Score one = score(triangle.face, {b, c, d});
                    const Score two = score(triangle.face, {b, d, a});
                    good = std::min(one.normal, two.normal) > least_normal &&
                           std::min(one.quality, two.quality) > 0.25;
                    if (good) {
                        remove(both[0]);
                        remove(both[1]);
                        add_triangle({b, c, d}, triangle.face);
                        add_triangle({b, d, a}, triangle.face);
                    }
                }
            }
            if (!good) {
                split(a, c, triangle.face, true);
            }
            break;
        }
    }
}

} // namespace nmgs::cad
