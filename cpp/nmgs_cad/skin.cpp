// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/skin.h"

#include "nmgs/plc/check.h"
#include "nmgs/support/at.h"
#include "nmgs/support/box_tree.h"
#include "nmgs_cad/inner_edges.h"
#include "nmgs_cad/skin_mesh.h"
#include "nmgs_cad/skin_start.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <cmath>
#include <set>

namespace nmgs::cad {
namespace {

std::array<Vec3, 3> corners(const SkinMesh &mesh, const SkinMesh::Triangle &t) {
    return {mesh.points[at(t.p[0])].p, mesh.points[at(t.p[1])].p, mesh.points[at(t.p[2])].p};
}

// Distance along the ray to the triangle, or infinity.
double ray(Vec3 from, Vec3 direction, const std::array<Vec3, 3> &t) {
    const Vec3 u = t[1] - t[0];
    const Vec3 v = t[2] - t[0];
    const Vec3 h = cross(direction, v);
    const double det = dot(u, h);
    if (std::abs(det) < 1e-12 * norm(u) * norm(v)) {
        return std::numeric_limits<double>::infinity();
    }
    const Vec3 s = from - t[0];
    const double a = dot(s, h) / det;
    const Vec3 q = cross(s, u);
    const double b = dot(direction, q) / det;
    if (a < 0 || b < 0 || a + b > 1) {
        return std::numeric_limits<double>::infinity();
    }
    return dot(v, q) / det;
}

// Upper bounds of the lengths at points where another face is near, across material or a gap.
std::vector<double> near_bounds(SkinMesh &mesh) {
    std::vector<double> bounds(mesh.points.size(), std::numeric_limits<double>::infinity());
    std::vector<Box> boxes;
    std::vector<std::size_t> numbers;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.triangles[t].face != 0) {
            Box box;
            for (const Vec3 p : corners(mesh, mesh.triangles[t])) {
                box.add(p);
            }
            boxes.push_back(box);
            numbers.push_back(t);
        }
    }
    const BoxTree tree(boxes);
    for (const std::size_t t : numbers) {
        const SkinMesh::Triangle &triangle = mesh.triangles[t];
        const auto c = corners(mesh, triangle);
        const Vec3 n = cross(c[1] - c[0], c[2] - c[0]);
        if (norm(n) == 0) {
            continue;
        }
        const Vec3 middle = (1.0 / 3) * (c[0] + c[1] + c[2]);
        double size = 0;
        for (const std::int32_t p : triangle.p) {
            size = std::max(size, mesh.points[at(p)].size);
        }
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 direction = (sign / norm(n)) * n;
            Box box;
            box.add(middle);
            box.add(middle + 0.5 * size * direction);
            double nearest = 0.5 * size;
            std::int32_t other = 0;
            tree.near(box, 0, [&](std::uint32_t k) {
                const auto &candidate = mesh.triangles[numbers[k]];
                if (numbers[k] == t || candidate.face == triangle.face) {
                    return;
                }
                for (const std::int32_t p : candidate.p) {
                    if (std::find(triangle.p.begin(), triangle.p.end(), p) != triangle.p.end()) {
                        return;
                    }
                }
                const double d = ray(middle, direction, corners(mesh, candidate));
                if (d > 0 && d < nearest) {
                    nearest = d;
                    other = candidate.face;
                }
            });
            if (other != 0) {
                // Flat walls may be far thinner than their triangles are long, curved ones as long
                // as the chords stay inside.
                const bool flat = mesh.face(triangle.face).planar() && mesh.face(other).planar();
                const double least = mesh.diagonal / (flat ? 30 : 150);
                double curvature = 0;
                for (const std::int32_t p : triangle.p) {
                    const SurfaceFrame frame = mesh.corner(triangle.face, p).frame;
                    curvature = std::max(curvature, frame.regular ? std::abs(frame.major) : 0.0);
                }
                const double inside = std::sqrt(2 * nearest / std::max(curvature, 1e-9 / least));
                const double bound = std::max({least, 3 * nearest, std::min(5 * nearest, inside)});
                for (const std::int32_t p : triangle.p) {
                    bounds[at(p)] = std::min(bounds[at(p)], bound);
                }
            }
        }
    }
    return bounds;
}

// The triangles that cross another one of the same solid; faces of no solid belong together.
std::set<std::size_t> crossing(const CadShape &shape, const SkinMesh &mesh,
                               const Progress &progress) {
    std::vector<std::set<int>> solids(at(shape.faces.Extent()) + 1);
    for (int s = 1; s <= shape.solids.Extent(); ++s) {
        for (TopExp_Explorer f(shape.solid(s), TopAbs_FACE); f.More(); f.Next()) {
            solids[at(shape.faces.FindIndex(f.Current()))].insert(s);
        }
    }
    Plc plc;
    std::vector<std::size_t> numbers;
    for (const SkinPoint &p : mesh.points) {
        plc.points.push_back(p.p);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.triangles[t].face != 0) {
            for (const std::int32_t n : mesh.triangles[t].p) {
                plc.polygon_nodes.push_back(n);
            }
            plc.end_polygon();
            plc.end_facet();
            numbers.push_back(t);
        }
    }
    std::set<std::size_t> result;
    for (const PlcProblem &problem : check(plc, {}, progress)) {
        if (problem.fault != PlcFault::crossing_facets) {
            continue;
        }
        const std::size_t a = numbers[at(problem.facets[0])];
        const std::size_t b = numbers[at(problem.facets[1])];
        const auto &of_a = solids[at(mesh.triangles[a].face)];
        const auto &of_b = solids[at(mesh.triangles[b].face)];
        const bool together =
            of_a.empty() || of_b.empty() ||
            std::any_of(of_a.begin(), of_a.end(), [&](int s) { return of_b.contains(s); });
        if (together) {
            result.insert(a);
            result.insert(b);
        }
    }
    return result;
}

Skin output(SkinMesh &mesh, const CadShape &shape) {
    Skin skin;
    std::vector<std::int32_t> number(mesh.points.size(), -1);
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
        const SkinPoint &p = mesh.points[n];
        if (p.alive) {
            number[n] = static_cast<std::int32_t>(skin.points.size());
            skin.points.push_back(p.p);
            skin.on.push_back(p.on);
            skin.source.push_back(p.source);
        }
    }
    for (const auto &t : mesh.triangles) {
        if (t.face != 0) {
            skin.triangles.push_back({number[at(t.p[0])], number[at(t.p[1])], number[at(t.p[2])]});
            skin.faces.push_back(t.face);
            skin.uv.push_back({mesh.corner(t.face, t.p[0]).uv, mesh.corner(t.face, t.p[1]).uv,
                               mesh.corner(t.face, t.p[2]).uv});
        }
    }
    skin.edges.resize(at(shape.edges.Extent()) + 1);
    skin.parameters.resize(skin.edges.size());
    std::vector<std::vector<std::array<std::int32_t, 2>>> of_edge(skin.edges.size());
    for (const auto &[ends, e] : mesh.segments()) {
        of_edge[at(e)].push_back(ends);
    }
    for (std::size_t e = 1; e < of_edge.size(); ++e) {
        const auto edge = static_cast<std::int32_t>(e);
        // By the parameter of each segment's start.
        std::vector<std::pair<double, std::array<std::int32_t, 2>>> order;
        for (auto [a, b] : of_edge[e]) {
            const auto [ta, tb] = mesh.parameters(a, b, edge);
            order.push_back(ta < tb ? std::pair{ta, std::array{a, b}}
                                    : std::pair{tb, std::array{b, a}});
        }
        std::sort(order.begin(), order.end());
        for (const auto &[t, ends] : order) {
            if (skin.edges[e].empty()) {
                skin.edges[e].push_back(number[at(ends[0])]);
                skin.parameters[e].push_back(t);
            }
            skin.edges[e].push_back(number[at(ends[1])]);
            skin.parameters[e].push_back(mesh.parameters(ends[0], ends[1], edge)[1]);
        }
    }
    return skin;
}

} // namespace

namespace {

double area_of(const TopoDS_Face &face) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return std::abs(properties.Mass());
}

} // namespace

SkinBuilder::~SkinBuilder() = default;

SkinBuilder::SkinBuilder(const CadShape &shape, std::span<const int> faces, SkinOptions options,
                         const Progress &progress)
    : shape_(shape), faces_(faces.begin(), faces.end()), options_(std::move(options)),
      mesh_(std::make_unique<SkinMesh>(shape, options_)) {
    start_skin(shape, faces, options_, *mesh_, progress);
    poll(progress, 0.2);
    for (int k = 0; k < 2; ++k) {
        mesh_->find_sizes(bounds_);
        if (options_.proximity) {
            bounds_ = near_bounds(*mesh_);
        }
        passes(1, progress, 0.2 + 0.1 * k, 0.3 + 0.1 * k);
    }
    passes(2, progress, 0.4, 0.6);
    for (int round = 0; round < 3 && find_turns(); ++round) {
        passes(1, progress, 0.6, 0.7);
    }
    finish(progress);
}

// Splits, collapses, flips and smooths.
void SkinBuilder::passes(int count, const Progress &progress, double from, double to) {
    for (int k = 0; k < count; ++k) {
        mesh_->find_sizes(bounds_);
        mesh_->pass(progress, from + k * (to - from) / count, from + (k + 1) * (to - from) / count);
        bounds_.resize(mesh_->points.size(), std::numeric_limits<double>::infinity());
    }
}

// Makes the turn smaller that is allowed along the edges of faces, and of solids, whose area or
// volume the triangles miss. Whether there are any.
bool SkinBuilder::find_turns() {
    constexpr double most_area = 0.05;
    constexpr double most_volume = 0.035;
    // The error falls with the square of the turn.
    const auto factor = [](double error, double most) {
        const double wanted = 0.7 * most;
        return std::abs(error) > most ? std::clamp(std::sqrt(wanted / std::abs(error)), 0.3, 0.9)
                                      : 1.0;
    };
    std::vector<double> area(at(shape_.faces.Extent()) + 1, 0);
    std::vector<double> moment(area.size(), 0); // six times the volume that the face spans
    for (const auto &t : mesh_->triangles) {
        if (t.face != 0) {
            const auto c = corners(*mesh_, t);
            area[at(t.face)] += 0.5 * norm(cross(c[1] - c[0], c[2] - c[0]));
            moment[at(t.face)] += determinant(c[0], c[1], c[2]);
        }
    }
    areas_.resize(area.size(), 0);
    std::vector<double> turn(area.size(), 1);
    for (const int n : faces_) {
        if (areas_[at(n)] == 0) {
            areas_[at(n)] = area_of(shape_.face(n));
        }
        if (areas_[at(n)] > 0) {
            turn[at(n)] = factor(area[at(n)] / areas_[at(n)] - 1, most_area);
        }
    }
    volumes_.resize(at(shape_.solids.Extent()) + 1, 0);
    for (int s = 1; s <= shape_.solids.Extent(); ++s) {
        double sum = 0;
        bool whole = true;
        std::vector<int> own;
        for (TopExp_Explorer f(shape_.solid(s), TopAbs_FACE); f.More(); f.Next()) {
            const int n = shape_.faces.FindIndex(f.Current());
            const bool turned = f.Current().Orientation() != shape_.face(n).Orientation();
            whole = whole && std::find(faces_.begin(), faces_.end(), n) != faces_.end();
            own.push_back(n);
            sum += (turned ? -1 : 1) * moment[at(n)] / 6;
        }
        if (!whole) {
            continue;
        }
        if (volumes_[at(s)] == 0) {
            volumes_[at(s)] = std::abs(volume_of(shape_.solid(s)));
        }
        if (volumes_[at(s)] > 0) {
            for (const int n : own) {
                if (!mesh_->face(n).planar()) {
                    turn[at(n)] = std::min(
                        turn[at(n)], factor(std::abs(sum) / volumes_[at(s)] - 1, most_volume));
                }
            }
        }
    }
    // The number of triangles grows with the square as well.
    constexpr double many = 30'000;
    double expected = 0;
    for (const auto &t : mesh_->triangles) {
        expected += t.face != 0 ? 1 / (turn[at(t.face)] * turn[at(t.face)]) : 0;
    }
    if (expected > many) {
        return false;
    }
    bool any = false;
    std::vector<double> of_edge(at(shape_.edges.Extent()) + 1, 1);
    for (const int n : faces_) {
        if (turn[at(n)] == 1) {
            continue;
        }
        any = true;
        mesh_->face_turn[at(n)] *= turn[at(n)];
        for (TopExp_Explorer e(shape_.face(n), TopAbs_EDGE); e.More(); e.Next()) {
            double &own = of_edge[at(shape_.edges.FindIndex(e.Current()))];
            own = std::min(own, turn[at(n)]);
        }
    }
    for (std::size_t e = 0; e < of_edge.size(); ++e) {
        mesh_->edge_turn[e] *= of_edge[e];
    }
    return any;
}

void SkinBuilder::finish(const Progress &progress) {
    mesh_->drop_flat();
    mesh_->part_twins();
    mesh_->cut_ears();
    mesh_->smooth();
    mesh_->smooth();
    for (int round = 0; round < 5; ++round) {
        const auto crossed = crossing(shape_, *mesh_, progress);
        if (crossed.empty()) {
            break;
        }
        bounds_.resize(mesh_->points.size(), std::numeric_limits<double>::infinity());
        for (const std::size_t t : crossed) {
            const auto &p = mesh_->triangles[t].p;
            double longest = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                longest = std::max(longest, distance(mesh_->points[at(p[i])].p,
                                                     mesh_->points[at(p[(i + 1) % 3])].p));
            }
            for (const std::int32_t n : p) {
                bounds_[at(n)] = std::min(bounds_[at(n)], 0.5 * longest);
            }
        }
        passes(2, progress, 0.7 + 0.05 * round, 0.75 + 0.05 * round);
        mesh_->drop_flat();
        mesh_->part_twins();
        mesh_->cut_ears();
        mesh_->smooth();
    }
    poll(progress, 1);
}

Skin SkinBuilder::skin() const {
    Skin skin = output(*mesh_, shape_);
    const double size = options_.size > 0 ? options_.size : mesh_->diagonal / 6;
    add_inner_edges(shape_, faces_, size, options_.angle, skin);
    return skin;
}

void SkinBuilder::refine(std::span<const SkinOptions::Limit> limits, const Progress &progress) {
    options_.limits.insert(options_.limits.end(), limits.begin(), limits.end());
    passes(2, progress, 0, 0.7);
    finish(progress);
}

Skin make_skin(const CadShape &shape, std::span<const int> faces, const SkinOptions &options,
               const Progress &progress) {
    return SkinBuilder(shape, faces, options, progress).skin();
}

} // namespace nmgs::cad
