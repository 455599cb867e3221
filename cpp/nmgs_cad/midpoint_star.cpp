// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/midpoint_star.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/at.h"
#include "nmgs_cad/face_projection.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>

namespace nmgs::cad {
namespace {

using Pair = std::array<std::int32_t, 2>;

struct Triangle {
    std::array<std::int32_t, 3> corners; // counter-clockwise seen from outside
    std::int32_t centre;
};

struct Star {
    const CadShape &shape;
    int solid;
    Layout &layout;
    std::map<Pair, std::int32_t> middles; // of two points
    std::vector<Triangle> triangles;

    [[nodiscard]] Vec3 mean(std::initializer_list<std::int32_t> points) const {
        Vec3 sum{};
        for (const auto p : points) {
            sum += layout.points[at(p)];
        }
        return 1.0 / static_cast<double>(points.size()) * sum;
    }
    void triangle(std::array<std::int32_t, 3> corners, const FaceSides &face,
                  FaceProjection &projection) {
        const auto [a, b, c] = corners;
        const auto centre = layout.add_point(projection.nearest(mean({a, b, c})), {2, face.face});
        for (std::size_t i = 0; i < 3; ++i) {
            const auto here = corners[i];
            Layout::Quad quad{{here, middles.at(ascending(here, corners[(i + 1) % 3])), centre,
                               middles.at(ascending(here, corners[(i + 2) % 3]))},
                              face.face};
            if (face.reversed) {
                std::swap(quad.points[1], quad.points[3]);
            }
            layout.quads.push_back(quad);
        }
        triangles.push_back({corners, centre});
    }
    void cover(const FaceSides &face);
    [[nodiscard]] Vec3 middle() const;
    void fill();
};

void Star::cover(const FaceSides &face) {
    FaceProjection projection(shape.face(face.face));
    const std::size_t n = face.sides.size();
    std::vector<std::int32_t> vertices;
    Vec3 sum{};
    for (const FaceSide &side : face.sides) {
        vertices.push_back(layout.vertex(shape, side.vertex));
        sum += layout.points[at(layout.edges[at(side.edge)][1])];
    }
    if (n == 3) {
        triangle({vertices[0], vertices[1], vertices[2]}, face, projection);
        return;
    }
    const auto centre =
        layout.add_point(projection.nearest(1.0 / static_cast<double>(n) * sum), {2, face.face});
    for (const auto v : vertices) {
        middles[ascending(v, centre)] =
            layout.add_point(projection.nearest(mean({v, centre})), {2, face.face});
    }
    for (std::size_t i = 0; i < n; ++i) {
        triangle({vertices[i], vertices[(i + 1) % n], centre}, face, projection);
    }
}

// A place far from all triangles' planes: from the mean of their centres, away from the nearest
// again and again, by less and less.
Vec3 Star::middle() const {
    Vec3 place{};
    for (const Triangle &t : triangles) {
        place += 1.0 / static_cast<double>(triangles.size()) * layout.points[at(t.centre)];
    }
    double step = 0;
    for (int round = 0; round < 100; ++round) {
        double least = std::numeric_limits<double>::infinity();
        Vec3 inward{};
        for (const Triangle &t : triangles) {
            const Vec3 a = layout.points[at(t.corners[0])];
            const Vec3 n =
                cross(layout.points[at(t.corners[2])] - a, layout.points[at(t.corners[1])] - a);
            if (norm(n) > 0 && dot(place - a, unit(n)) < least) {
                least = dot(place - a, unit(n));
                inward = unit(n);
            }
        }
        step = round == 0 ? 0.5 * std::abs(least) : 0.95 * step;
        place += step * inward;
    }
    return place;
}

void Star::fill() {
    const auto inner = [&](Vec3 p) { return layout.add_point(p, {3, solid}); };
    const auto apex = inner(middle());
    std::map<std::int32_t, std::int32_t> half; // between a corner and the apex
    std::map<Pair, std::int32_t> wall;         // between two corners and the apex
    for (const Triangle &t : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = t.corners[i];
            const auto b = t.corners[(i + 1) % 3];
            if (!half.contains(a)) {
                half[a] = inner(mean({a, apex}));
            }
            if (!wall.contains(ascending(a, b))) {
                wall[ascending(a, b)] = inner(mean({a, b, apex}));
            }
        }
    }
    for (const Triangle &t : triangles) {
        const auto [a, b, c] = t.corners;
        const auto inside = inner(mean({a, b, c, apex}));
        for (std::size_t i = 0; i < 3; ++i) {
            const auto p = t.corners[i];
            const auto q = t.corners[(i + 1) % 3];
            const auto r = t.corners[(i + 2) % 3];
            layout.hexas.push_back(
                {{p, middles.at(ascending(p, r)), t.centre, middles.at(ascending(p, q)), half[p],
                  wall[ascending(p, r)], inside, wall[ascending(p, q)]},
                 solid});
        }
        layout.hexas.push_back({{apex, half[a], wall[ascending(a, b)], half[b], half[c],
                                 wall[ascending(a, c)], inside, wall[ascending(b, c)]},
                                solid});
    }
}

} // namespace

bool fill_star(const CadShape &shape, int solid, const std::vector<FaceSides> &faces,
               Layout &layout, Refusal &refusal) {
    for (const FaceSides &face : faces) {
        const std::string name = entity_name(2, face.face);
        if (face.sides.size() < 3) {
            refusal = {name + " has two sides", {name}};
            return false;
        }
        if (!layout.quads_of(face.face).empty()) {
            refusal = {name + " is laid out already", {name}};
            return false;
        }
    }
    Star star{shape, solid, layout, {}, {}};
    for (const FaceSides &face : faces) {
        for (const FaceSide &side : face.sides) {
            constexpr double half = 0.5;
            const auto points = layout.divide_edge(shape, side.edge, {&half, 1});
            if (points.size() != 3 || points.front() == points.back()) {
                refusal = {entity_name(1, side.edge) + " is not in two parts",
                           {entity_name(1, side.edge)}};
                return false;
            }
            const Pair ends = ascending(points.front(), points.back());
            const auto [known, added] = star.middles.emplace(ends, points[1]);
            if (!added && known->second != points[1]) {
                refusal = {entity_name(1, side.edge) + " has the ends of another edge",
                           {entity_name(1, side.edge)}};
                return false;
            }
        }
    }
    for (const FaceSides &face : faces) {
        star.cover(face);
    }
    star.fill();
    return true;
}

} // namespace nmgs::cad
