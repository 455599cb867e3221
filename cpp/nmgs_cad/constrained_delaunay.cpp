// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/constrained_delaunay.h"

#include "nmgs/support/ascending.h"
#include "nmgs/support/predicates.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <set>

namespace nmgs::cad {
namespace {

struct Triangulation {
    struct Triangle {
        std::array<std::int32_t, 3> v;
        std::array<std::int32_t, 3> n; // neighbour across the edge from v[i] to v[i + 1]
    };
    std::vector<Point2> points;
    std::vector<Triangle> triangles;
    std::vector<std::int32_t> at; // a triangle at each point
    std::int32_t last = 0;

    [[nodiscard]] int side(std::int32_t a, std::int32_t b, std::int32_t c) const {
        const auto &p = points[static_cast<std::size_t>(a)];
        const auto &q = points[static_cast<std::size_t>(b)];
        const auto &r = points[static_cast<std::size_t>(c)];
        return orient2d(p[0], p[1], q[0], q[1], r[0], r[1]);
    }
    Triangle &tri(std::int32_t t) { return triangles[static_cast<std::size_t>(t)]; }
    [[nodiscard]] const Triangle &tri(std::int32_t t) const {
        return triangles[static_cast<std::size_t>(t)];
    }
    void replace(std::int32_t t, std::int32_t from, std::int32_t to) {
        if (t >= 0) {
            for (auto &n : tri(t).n) {
                if (n == from) {
                    n = to;
                    return;
                }
            }
        }
    }
    // The place of vertex or neighbour in a triangle.
    [[nodiscard]] std::size_t place(std::int32_t t, std::int32_t v) const {
        const auto &vs = tri(t).v;
        return static_cast<std::size_t>(std::find(vs.begin(), vs.end(), v) - vs.begin());
    }
    void set(std::int32_t t, std::array<std::int32_t, 3> v, std::array<std::int32_t, 3> n) {
        tri(t) = {v, n};
        for (const std::int32_t p : v) {
            at[static_cast<std::size_t>(p)] = t;
        }
    }

    // Flips the edge i of t; the two triangles become (a, d, c) and (d, b, c) of a, b the edge, c
    // the vertex of t that faces it and d that of the neighbour.
    void flip(std::int32_t t, std::size_t i) {
        const std::int32_t o = tri(t).n[i];
        const std::int32_t a = tri(t).v[i];
        const std::int32_t b = tri(t).v[(i + 1) % 3];
        const std::int32_t c = tri(t).v[(i + 2) % 3];
        const std::size_t j = place(o, b);
        const std::int32_t d = tri(o).v[(j + 2) % 3];
        const std::int32_t bc = tri(t).n[(i + 1) % 3];
        const std::int32_t ca = tri(t).n[(i + 2) % 3];
        const std::int32_t ad = tri(o).n[(j + 1) % 3];
        const std::int32_t db = tri(o).n[(j + 2) % 3];
        set(t, {a, d, c}, {ad, o, ca});
        set(o, {d, b, c}, {db, bc, t});
        replace(ad, o, t);
        replace(bc, t, o);
    }
    [[nodiscard]] bool convex(std::int32_t t, std::size_t i) const {
        const std::int32_t o = tri(t).n[i];
        if (o < 0) {
            return false;
        }
        const std::int32_t a = tri(t).v[i];
        const std::int32_t b = tri(t).v[(i + 1) % 3];
        const std::int32_t c = tri(t).v[(i + 2) % 3];
        const std::int32_t d = tri(o).v[(place(o, b) + 2) % 3];
        return side(a, d, c) > 0 && side(d, b, c) > 0;
    }
    // The opposite vertex lies in the circle; approximately, since flips keep the topology in any
    // case.
    [[nodiscard]] bool wants_flip(std::int32_t t, std::size_t i) const {
        const std::int32_t o = tri(t).n[i];
        if (o < 0 || !convex(t, i)) {
            return false;
        }
        const auto &p = [&](std::int32_t v) { return points[static_cast<std::size_t>(v)]; };
        const auto a = p(tri(t).v[0]);
        const auto b = p(tri(t).v[1]);
        const auto c = p(tri(t).v[2]);
        const auto d = p(tri(o).v[(place(o, tri(t).v[(i + 1) % 3]) + 2) % 3]);
        std::array<std::array<double, 3>, 3> m{};
        std::size_t row = 0;
        for (const auto &q : {a, b, c}) {
            const double x = q[0] - d[0];
            const double y = q[1] - d[1];
            m[row++] = {x, y, x * x + y * y};
        }
        double scale = 0;
        double sum = 0;
        for (std::size_t r = 0; r < 3; ++r) {
            const auto &s = m[(r + 1) % 3];
            const auto &u = m[(r + 2) % 3];
            sum += m[r][2] * (s[0] * u[1] - s[1] * u[0]);
            scale += m[r][2] * (std::abs(s[0] * u[1]) + std::abs(s[1] * u[0]));
        }
        return sum > 1e-12 * scale;
    }
    void legalize(std::vector<std::int32_t> stack,
                  const std::set<std::array<std::int32_t, 2>> *kept) {
        std::size_t budget = 200 * (triangles.size() + 10);
        while (!stack.empty() && budget-- > 0) {
            const std::int32_t t = stack.back();
            stack.pop_back();
            for (std::size_t i = 0; i < 3; ++i) {
                const std::int32_t a = tri(t).v[i];
                const std::int32_t b = tri(t).v[(i + 1) % 3];
                if (kept != nullptr && kept->contains(ascending(a, b))) {
                    continue;
                }
                if (wants_flip(t, i)) {
                    const std::int32_t o = tri(t).n[i];
                    flip(t, i);
                    stack.push_back(t);
                    stack.push_back(o);
                    break;
                }
            }
        }
    }
    // False when the point is there already.
    bool insert(std::int32_t p) {
        std::int32_t t = last;
        std::size_t steps = 0;
        for (bool moved = true; moved;) {
            moved = false;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t i = (k + steps) % 3;
                if (side(tri(t).v[i], tri(t).v[(i + 1) % 3], p) < 0) {
                    t = tri(t).n[i];
                    moved = true;
                    break;
                }
            }
            if (t < 0 || ++steps > 4 * triangles.size() + 100) {
                return false;
            }
        }
        last = t;
        for (const std::int32_t v : tri(t).v) {
            if (points[static_cast<std::size_t>(v)] == points[static_cast<std::size_t>(p)]) {
                return false;
            }
        }
        const auto [v, n] = tri(t);
        for (std::size_t i = 0; i < 3; ++i) {
            if (side(v[i], v[(i + 1) % 3], p) == 0) {
                return split_edge(t, i, p);
            }
        }
        const auto t1 = static_cast<std::int32_t>(triangles.size());
        const std::int32_t t2 = t1 + 1;
        triangles.resize(triangles.size() + 2);
        set(t, {v[0], v[1], p}, {n[0], t1, t2});
        set(t1, {v[1], v[2], p}, {n[1], t2, t});
        set(t2, {v[2], v[0], p}, {n[2], t, t1});
        replace(n[1], t, t1);
        replace(n[2], t, t2);
        legalize({t, t1, t2}, nullptr);
        return true;
    }
    bool split_edge(std::int32_t t, std::size_t i, std::int32_t p) {
        const std::int32_t o = tri(t).n[i];
        if (o < 0) {
            return false;
        }
        const std::int32_t a = tri(t).v[i];
        const std::int32_t b = tri(t).v[(i + 1) % 3];
        const std::int32_t c = tri(t).v[(i + 2) % 3];
        const std::size_t j = place(o, b);
        const std::int32_t d = tri(o).v[(j + 2) % 3];
        const std::int32_t bc = tri(t).n[(i + 1) % 3];
        const std::int32_t ca = tri(t).n[(i + 2) % 3];
        const std::int32_t ad = tri(o).n[(j + 1) % 3];
        const std::int32_t db = tri(o).n[(j + 2) % 3];
        const auto t1 = static_cast<std::int32_t>(triangles.size());
        const std::int32_t o1 = t1 + 1;
        triangles.resize(triangles.size() + 2);
        set(t, {a, p, c}, {o1, t1, ca});
        set(t1, {p, b, c}, {o, bc, t});
        set(o, {b, p, d}, {t1, o1, db});
        set(o1, {p, a, d}, {t, ad, o});
        replace(bc, t, t1);
        replace(ad, o, o1);
        legalize({t, t1, o, o1}, nullptr);
        return true;
    }

    // Triangle and edge that go from a to b, if any.
    [[nodiscard]] std::optional<std::pair<std::int32_t, std::size_t>> edge(std::int32_t a,
                                                                           std::int32_t b) const {
        const std::int32_t first = at[static_cast<std::size_t>(a)];
        std::int32_t t = first;
        do {
            const std::size_t i = place(t, a);
            if (tri(t).v[(i + 1) % 3] == b) {
                return std::pair{t, i};
            }
            t = tri(t).n[i];
        } while (t >= 0 && t != first);
        // The box round all points makes every fan of an inner point closed.
        return std::nullopt;
    }

    bool recover(std::int32_t a, std::int32_t b,
                 const std::set<std::array<std::int32_t, 2>> &kept) {
        if (edge(a, b) || edge(b, a)) {
            return true;
        }
        // The edges between a and b, from the fan of a on.
        std::deque<std::array<std::int32_t, 2>> crossing;
        std::int32_t t = at[static_cast<std::size_t>(a)];
        const std::int32_t first = t;
        std::int32_t left = -1;
        std::int32_t right = -1;
        do {
            const std::size_t i = place(t, a);
            const std::int32_t p = tri(t).v[(i + 1) % 3];
            const std::int32_t q = tri(t).v[(i + 2) % 3];
            if (side(a, b, p) < 0 && side(a, b, q) > 0 && side(p, q, b) < 0) {
                right = p;
                left = q;
                break;
            }
            t = tri(t).n[i];
        } while (t >= 0 && t != first);
        if (right < 0) {
            return false; // a point lies on the segment
        }
        for (;;) {
            if (kept.contains({std::min(left, right), std::max(left, right)})) {
                return false; // segments cross
            }
            crossing.push_back({right, left});
            const std::size_t i = place(t, right);
            t = tri(t).n[(i + 0) % 3] >= 0 && tri(t).v[(i + 1) % 3] == left ? tri(t).n[i]
                                                                            : tri(t).n[(i + 2) % 3];
            if (t < 0) {
                return false;
            }
            std::int32_t c = -1;
            for (const std::int32_t v : tri(t).v) {
                c = v != left && v != right ? v : c;
            }
            if (c == b) {
                break;
            }
            const int s = side(a, b, c);
            if (s == 0) {
                return false;
            }
            (s > 0 ? left : right) = c;
        }
        std::size_t budget = 100 * crossing.size() * (crossing.size() + 10);
        while (!crossing.empty() && budget-- > 0) {
            const auto [p, q] = crossing.front();
            crossing.pop_front();
            auto where = edge(p, q);
            if (!where) {
                where = edge(q, p);
            }
            if (!where) {
                return false;
            }
            const auto [tt, i] = *where;
            if (!convex(tt, i)) {
                crossing.push_back({p, q});
                continue;
            }
            const std::int32_t c = tri(tt).v[(i + 2) % 3];
            const std::int32_t o = tri(tt).n[i];
            const std::int32_t d = tri(o).v[(place(o, tri(tt).v[(i + 1) % 3]) + 2) % 3];
            flip(tt, i);
            const bool ends = c == a || c == b || d == a || d == b;
            if (!ends && side(a, b, c) * side(a, b, d) < 0) {
                crossing.push_back({c, d});
            }
        }
        return edge(a, b) || edge(b, a);
    }
};

} // namespace

std::optional<std::vector<std::array<std::int32_t, 3>>>
constrained_delaunay(std::span<const Point2> points, std::span<const Segment> segments) {
    Triangulation mesh;
    mesh.points.assign(points.begin(), points.end());
    Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point2 high{-low[0], -low[1]};
    for (const auto &p : points) {
        for (std::size_t d = 0; d < 2; ++d) {
            low[d] = std::min(low[d], p[d]);
            high[d] = std::max(high[d], p[d]);
        }
    }
    const double size = std::max({high[0] - low[0], high[1] - low[1], 1e-300});
    const auto n = static_cast<std::int32_t>(points.size());
    const Point2 middle{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
    mesh.points.push_back({middle[0] - 40 * size, middle[1] - 30 * size});
    mesh.points.push_back({middle[0] + 40 * size, middle[1] - 30 * size});
    mesh.points.push_back({middle[0], middle[1] + 50 * size});
    mesh.at.assign(mesh.points.size(), 0);
    mesh.triangles.resize(1);
    mesh.set(0, {n, n + 1, n + 2}, {-1, -1, -1});
    for (std::int32_t p = 0; p < n; ++p) {
        if (!mesh.insert(p)) {
            return std::nullopt;
        }
    }
    std::set<std::array<std::int32_t, 2>> kept;
    for (const Segment &s : segments) {
        if (!mesh.recover(s.a, s.b, kept)) {
            return std::nullopt;
        }
        kept.insert({std::min(s.a, s.b), std::max(s.a, s.b)});
    }
    std::vector<std::int32_t> all(mesh.triangles.size());
    for (std::size_t t = 0; t < all.size(); ++t) {
        all[t] = static_cast<std::int32_t>(t);
    }
    mesh.legalize(std::move(all), &kept);

    std::vector<char> inside(mesh.triangles.size(), 0);
    std::vector<std::int32_t> stack;
    for (const Segment &s : segments) {
        if (s.bounds) {
            const auto where = mesh.edge(s.a, s.b);
            if (!where) {
                return std::nullopt;
            }
            if (inside[static_cast<std::size_t>(where->first)] == 0) {
                inside[static_cast<std::size_t>(where->first)] = 1;
                stack.push_back(where->first);
            }
        }
    }
    while (!stack.empty()) {
        const std::int32_t t = stack.back();
        stack.pop_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t a = mesh.tri(t).v[i];
            const std::int32_t b = mesh.tri(t).v[(i + 1) % 3];
            const std::int32_t o = mesh.tri(t).n[i];
            if (o >= 0 && inside[static_cast<std::size_t>(o)] == 0 &&
                !kept.contains(ascending(a, b))) {
                inside[static_cast<std::size_t>(o)] = 1;
                stack.push_back(o);
            }
        }
    }
    std::vector<std::array<std::int32_t, 3>> result;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (inside[t] != 0) {
            const auto &v = mesh.triangles[t].v;
            if (*std::max_element(v.begin(), v.end()) >= n) {
                return std::nullopt; // the domain is not closed
            }
            result.push_back(v);
        }
    }
    return result;
}

} // namespace nmgs::cad
