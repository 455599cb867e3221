// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/inner_points.h"

#include "nmgs/support/error.h"
#include "nmgs/support/predicates.h"

#include <BRepClass3d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace nmgs::cad {
namespace {

using Numbers = std::vector<std::size_t>; // of triangles

struct Rays {
    const Tessellation &mesh;
    double far; // beyond everything

    [[nodiscard]] std::array<Vec3, 3> corners(std::size_t t) const {
        const auto &n = mesh.triangles[t];
        return {mesh.points[static_cast<std::size_t>(n[0])],
                mesh.points[static_cast<std::size_t>(n[1])],
                mesh.points[static_cast<std::size_t>(n[2])]};
    }

    // Distance to the plane along the ray where it goes through the triangle, exact in the answer
    // whether it does; nothing where it meets an edge, too.
    [[nodiscard]] std::optional<double> hit(std::size_t t, Vec3 from, Vec3 direction) const {
        const auto [a, b, c] = corners(t);
        const Vec3 to = from + far * direction;
        const int above = orient3d(a, b, c, from);
        if (above == 0 || above == orient3d(a, b, c, to)) {
            return std::nullopt;
        }
        const int ab = orient3d(from, to, a, b);
        const int bc = orient3d(from, to, b, c);
        const int ca = orient3d(from, to, c, a);
        if (ab == 0 || ab != bc || bc != ca) {
            return std::nullopt;
        }
        const Vec3 n = cross(b - a, c - a);
        return dot(n, a - from) / dot(n, direction);
    }

    // Odd number of triangles to the outside, in most of several directions.
    [[nodiscard]] bool inside(const Numbers &triangles, Vec3 point) const {
        constexpr std::array<Vec3, 5> directions{{{0.9321, 0.2417, 0.2703},
                                                  {-0.9127, 0.3313, -0.2391},
                                                  {0.2179, 0.9471, -0.2353},
                                                  {-0.2897, -0.9283, 0.2333},
                                                  {0.3137, -0.2239, 0.9227}}};
        int odd = 0;
        for (const Vec3 direction : directions) {
            int hits = 0;
            for (const std::size_t t : triangles) {
                hits += hit(t, point, direction) ? 1 : 0;
            }
            odd += hits % 2;
        }
        return odd >= 3;
    }
};

double area(const Rays &rays, std::size_t t) {
    const auto [a, b, c] = rays.corners(t);
    return norm(cross(b - a, c - a));
}

// A point beside one of the `from` triangles for which `good` holds, midway to the next of `all`.
template <class Good>
std::optional<Vec3> point_beside(const Rays &rays, Numbers from, const Numbers &all,
                                 const Good &good) {
    constexpr std::size_t tries = 24;
    const std::size_t count = std::min(tries, from.size());
    std::partial_sort(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count), from.end(),
                      [&](std::size_t s, std::size_t t) {
                          const double x = area(rays, s);
                          const double y = area(rays, t);
                          return x != y ? x > y : s < t;
                      });
    for (std::size_t i = 0; i < count; ++i) {
        const auto [a, b, c] = rays.corners(from[i]);
        const Vec3 n = cross(b - a, c - a);
        if (norm(n) == 0) {
            continue;
        }
        // Off the centroid: in a regular shape its normal meets a corner or an edge.
        const Vec3 middle = 0.41 * a + 0.34 * b + 0.25 * c;
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 direction = (sign / norm(n)) * n;
            double next = std::numeric_limits<double>::infinity();
            for (const std::size_t t : all) {
                if (t != from[i]) {
                    const auto distance = rays.hit(t, middle, direction);
                    next = distance && *distance > 0 ? std::min(next, *distance) : next;
                }
            }
            if (std::isfinite(next) && good(middle + 0.5 * next * direction)) {
                return middle + 0.5 * next * direction;
            }
        }
    }
    return std::nullopt;
}

Numbers triangles_of(const CadShape &shape, const Tessellation &mesh, const TopoDS_Shape &part) {
    std::set<std::int32_t> faces;
    for (TopExp_Explorer at(part, TopAbs_FACE); at.More(); at.Next()) {
        // A face with both orientations lies inside the solid and bounds nothing.
        const auto number = static_cast<std::int32_t>(shape.faces.FindIndex(at.Current()));
        if (!faces.insert(number).second) {
            faces.erase(number);
        }
    }
    Numbers numbers;
    for (std::size_t t = 0; t < mesh.faces.size(); ++t) {
        if (faces.contains(mesh.faces[t])) {
            numbers.push_back(t);
        }
    }
    return numbers;
}

} // namespace

void add_inner_points(const CadShape &shape, Tessellation &result, const Progress &progress) {
    Box box;
    for (const Vec3 p : result.points) {
        box.add(p);
    }
    const Rays rays{result, 3 * box.diagonal()};
    Numbers all(result.triangles.size());
    for (std::size_t t = 0; t < all.size(); ++t) {
        all[t] = t;
    }
    std::vector<Numbers> solids;
    const int count = shape.solids.Extent();
    for (int n = 1; n <= count; ++n) {
        solids.push_back(triangles_of(shape, result, shape.solid(n)));
        const auto point = point_beside(rays, solids.back(), all,
                                        [&](Vec3 p) { return rays.inside(solids.back(), p); });
        if (!point) {
            throw GeometryError(entity_name(3, n) + " encloses no volume", {entity_name(3, n)});
        }
        result.solid_points.push_back(*point);
        poll(progress, 0.8 + 0.1 * n / count);
    }
    for (int n = 1; n <= count; ++n) {
        const TopoDS_Shell outer = BRepClass3d::OuterShell(shape.solid(n));
        for (TopExp_Explorer at(shape.solid(n), TopAbs_SHELL); at.More(); at.Next()) {
            if (at.Current().IsSame(outer)) {
                continue;
            }
            const Numbers shell = triangles_of(shape, result, at.Current());
            const auto empty = [&](Vec3 p) {
                return rays.inside(shell, p) &&
                       std::none_of(solids.begin(), solids.end(),
                                    [&](const Numbers &solid) { return rays.inside(solid, p); });
            };
            if (const auto point = point_beside(rays, shell, all, empty)) {
                result.void_points.push_back(*point);
            }
        }
        poll(progress, 0.9 + 0.1 * n / count);
    }
}

} // namespace nmgs::cad
