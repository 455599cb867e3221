// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_loops.h"

#include "nmgs_cad/occt_vec.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace nmgs::cad {
namespace {

constexpr double pi = std::numbers::pi;

double length2(Uv a) {
    return a.u * a.u + a.v * a.v;
}

int end_vertex(const CadShape &shape, const EdgeUse &use) {
    const TopoDS_Edge edge = shape.edge(use.edge);
    return shape.vertices.FindIndex(use.forward ? TopExp::LastVertex(edge)
                                                : TopExp::FirstVertex(edge));
}

// Twice the signed area in the plane of the parameters.
double area(const FaceLoop &loop) {
    constexpr int samples = 16;
    double sum = 0;
    const Uv origin = loop.front().begin();
    Uv last = origin;
    for (const EdgeUse &use : loop) {
        for (int i = 1; i <= samples; ++i) {
            const double t = static_cast<double>(i) / samples;
            const double f = use.forward ? t : 1 - t;
            const Uv p = use.at(use.first + f * (use.last - use.first));
            const Uv a = last - origin;
            const Uv b = p - origin;
            sum += a.u * b.v - a.v * b.u;
            last = p;
        }
    }
    return sum;
}

// Chains uses into loops: each begins at the vertex and the parameters where the one before ends.
std::vector<FaceLoop> chain(const CadShape &shape, std::vector<EdgeUse> uses, bool &closed) {
    std::vector<FaceLoop> loops;
    while (!uses.empty()) {
        FaceLoop loop{uses.front()};
        uses.erase(uses.begin());
        for (;;) {
            const int vertex = end_vertex(shape, loop.back());
            const Uv here = loop.back().end();
            const bool can_close = vertex == loop.front().vertex;
            double best = can_close ? length2(loop.front().begin() - here)
                                    : std::numeric_limits<double>::infinity();
            auto next = uses.end();
            for (auto use = uses.begin(); use != uses.end(); ++use) {
                const double d = length2(use->begin() - here);
                if (use->vertex == vertex && d < best) {
                    best = d;
                    next = use;
                }
            }
            if (next == uses.end()) {
                closed = closed && can_close;
                break;
            }
            loop.push_back(*next);
            uses.erase(next);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

// Point at the share s of the way along a use.
Vec3 point_at(const CadShape &shape, const EdgeUse &use, double s) {
    const BRepAdaptor_Curve curve(shape.edge(use.edge));
    const double f = use.forward ? s : 1 - s;
    return vec(
        curve.Value(curve.FirstParameter() + f * (curve.LastParameter() - curve.FirstParameter())));
}

double rough_length(const CadShape &shape, const EdgeUse &use) {
    constexpr int samples = 12;
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
        sum += distance(point_at(shape, use, static_cast<double>(i) / samples),
                        point_at(shape, use, (i + 1.0) / samples));
    }
    return sum;
}

// Signed turn from a to b about the normal.
double turn(Vec3 a, Vec3 b, Vec3 normal) {
    return std::atan2(dot(normal, cross(a, b)), dot(a, b) - dot(a, normal) * dot(b, normal));
}

double interior_angle(const CadShape &shape, const FaceSurface &surface, const EdgeUse &before,
                      const EdgeUse &use) {
    double angle = pi;
    const Vec3 normal = surface.normal(use.begin());
    if (before.degenerated || use.degenerated || norm2(normal) == 0) {
        const auto direction = [](const EdgeUse &e, bool at_end) {
            const double span = (e.last - e.first) * 1e-3;
            const double near = e.forward == at_end ? e.last : e.first;
            const double off = e.forward == at_end ? near - span : near + span;
            const Uv d = at_end ? e.at(near) - e.at(off) : e.at(off) - e.at(near);
            return Vec3{d.u, d.v, 0};
        };
        angle = pi - turn(direction(before, true), direction(use, false),
                          {0, 0, surface.reversed() ? -1.0 : 1.0});
    } else {
        // Chords, longer ones where the curves run back on themselves and only their bend tells
        // on which side the face is.
        double back = 1;
        double ahead = 1;
        for (const double s : {1e-4, 1e-2, 5e-2, 0.2}) {
            // From the curves' own ends: the vertex is near these, maybe not near enough.
            const Vec3 in = point_at(shape, before, 1) - point_at(shape, before, 1 - back * s);
            const Vec3 out = point_at(shape, use, ahead * s) - point_at(shape, use, 0);
            angle = pi - turn(in, out, normal);
            if (angle > 1e-2 && angle < 2 * pi - 1e-2) {
                break;
            }
            // Of the same length, as far as the shares are those of lengths.
            const double one = rough_length(shape, before);
            const double two = rough_length(shape, use);
            back = std::min(1.0, two / one);
            ahead = std::min(1.0, one / two);
        }
    }
    return std::clamp(angle, 1e-6, 2 * pi - 1e-6);
}

} // namespace

Uv EdgeUse::at(double t) const {
    const gp_Pnt2d p = parameters->Value(t);
    return {p.X(), p.Y()};
}

std::optional<FaceLoops> face_loops(const CadShape &shape, int face, Refusal &refusal) {
    const TopoDS_Face original = shape.face(face);
    const auto forward = TopoDS::Face(original.Oriented(TopAbs_FORWARD));
    const bool reversed = original.Orientation() == TopAbs_REVERSED;
    const std::string name = entity_name(2, face);
    FaceLoops result;
    bool closed = true;
    for (TopoDS_Iterator wire(forward); wire.More(); wire.Next()) {
        if (wire.Value().ShapeType() == TopAbs_VERTEX) {
            result.points.push_back(shape.vertices.FindIndex(wire.Value()));
        }
        if (wire.Value().ShapeType() != TopAbs_WIRE) {
            continue;
        }
        std::vector<EdgeUse> uses;
        std::map<int, int> seen;
        for (TopoDS_Iterator it(wire.Value()); it.More(); it.Next()) {
            if (it.Value().ShapeType() != TopAbs_EDGE) {
                continue;
            }
            const TopoDS_Edge &edge = TopoDS::Edge(it.Value());
            EdgeUse use;
            use.edge = shape.edges.FindIndex(edge);
            use.parameters = BRep_Tool::CurveOnSurface(edge, forward, use.first, use.last);
            if (use.parameters.IsNull()) {
                refusal = {name + ": " + entity_name(1, use.edge) + " has no curve on its surface",
                           {name, entity_name(1, use.edge)}};
                return std::nullopt;
            }
            use.degenerated = BRep_Tool::Degenerated(edge);
            // An edge that is used in both senses on one face; a seam has two curves on it.
            use.forward = edge.Orientation() != TopAbs_REVERSED;
            if (edge.Orientation() == TopAbs_INTERNAL || edge.Orientation() == TopAbs_EXTERNAL) {
                use.vertex = shape.vertices.FindIndex(TopExp::FirstVertex(shape.edge(use.edge)));
                use.start = shape.point(use.vertex);
                result.inner.push_back(use);
                continue;
            }
            ++seen[use.edge];
            uses.push_back(use);
        }
        for (EdgeUse &use : uses) {
            use.seam = seen[use.edge] > 1;
            // Against the face's normal a reversed face is seen from the other side.
            use.forward = use.forward != reversed;
            const TopoDS_Edge edge = shape.edge(use.edge);
            use.vertex = shape.vertices.FindIndex(use.forward ? TopExp::FirstVertex(edge)
                                                              : TopExp::LastVertex(edge));
            use.start = shape.point(use.vertex);
        }
        if (reversed) {
            std::reverse(uses.begin(), uses.end());
        }
        for (FaceLoop &loop : chain(shape, std::move(uses), closed)) {
            result.loops.push_back(std::move(loop));
        }
    }
    if (result.loops.empty() || !closed) {
        refusal = {name + (closed ? " has no boundary" : " has a boundary that does not close"),
                   {name}};
        return std::nullopt;
    }
    std::set<int> at_edges;
    const auto note = [&](const EdgeUse &use) {
        at_edges.insert(shape.vertices.FindIndex(TopExp::FirstVertex(shape.edge(use.edge))));
        at_edges.insert(shape.vertices.FindIndex(TopExp::LastVertex(shape.edge(use.edge))));
    };
    std::for_each(result.inner.begin(), result.inner.end(), note);
    for (const FaceLoop &loop : result.loops) {
        std::for_each(loop.begin(), loop.end(), note);
    }
    std::erase_if(result.points, [&](int n) { return at_edges.contains(n); });
    const FaceSurface surface(original);
    std::vector<double> areas;
    for (FaceLoop &loop : result.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            loop[i].angle =
                interior_angle(shape, surface, loop[(i + loop.size() - 1) % loop.size()], loop[i]);
        }
        areas.push_back(std::abs(area(loop)));
    }
    const auto outer = std::max_element(areas.begin(), areas.end()) - areas.begin();
    std::rotate(result.loops.begin(), result.loops.begin() + outer,
                result.loops.begin() + outer + 1);
    return result;
}

void join_touching_loops(const CadShape &shape, int face, FaceLoops &loops) {
    const FaceSurface surface(shape.face(face));
    const Uv span = surface.high() - surface.low();
    const auto same = [&](const EdgeUse &a, const EdgeUse &b) {
        constexpr double near = 1e-6;
        const Uv d = a.begin() - b.begin();
        return a.vertex == b.vertex && std::abs(d.u) <= near * span.u &&
               std::abs(d.v) <= near * span.v;
    };
    const auto join = [&](FaceLoop &one, const FaceLoop &two) {
        for (std::size_t i = 0; i < one.size(); ++i) {
            for (std::size_t k = 0; k < two.size(); ++k) {
                if (!same(one[i], two[k])) {
                    continue;
                }
                FaceLoop turned = two;
                std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(k),
                            turned.end());
                const std::size_t n = turned.size();
                one.insert(one.begin() + static_cast<std::ptrdiff_t>(i), turned.begin(),
                           turned.end());
                for (const std::size_t u : {i, i + n}) {
                    one[u].angle = interior_angle(shape, surface,
                                                  one[(u + one.size() - 1) % one.size()], one[u]);
                }
                return true;
            }
        }
        return false;
    };
    for (std::size_t l = 0; l < loops.loops.size(); ++l) {
        for (std::size_t m = l + 1; m < loops.loops.size();) {
            if (join(loops.loops[l], loops.loops[m])) {
                loops.loops.erase(loops.loops.begin() + static_cast<std::ptrdiff_t>(m));
                m = l + 1;
            } else {
                ++m;
            }
        }
    }
}

} // namespace nmgs::cad
