// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_smoothing.h"

#include "nmgs/support/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nmgs::cad {
namespace {

using Quad = std::array<std::int32_t, 4>;

// Like exp(-6 x) for x in [-1, 1], of which it takes a good part of the time.
double steep(double x) {
    double y = 1 - 0.375 * x;
    for (int i = 0; i < 4; ++i) {
        y *= y;
    }
    return y;
}

struct Smoother {
    FaceMesh &mesh;
    const FaceSurface &surface;
    std::vector<std::vector<std::int32_t>> quads_at;

    Smoother(FaceMesh &m, const FaceSurface &s) : mesh(m), surface(s), quads_at(m.points.size()) {
        for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
            for (const std::int32_t n : mesh.quads[q]) {
                quads_at[static_cast<std::size_t>(n)].push_back(static_cast<std::int32_t>(q));
            }
        }
    }
    [[nodiscard]] const Quad &quad(std::int32_t q) const {
        return mesh.quads[static_cast<std::size_t>(q)];
    }
    // The node's parameters after a move towards a place in space, by Gauss-Newton steps.
    [[nodiscard]] Uv towards(std::size_t n, Vec3 target) const {
        Uv p = mesh.uv[n];
        for (int i = 0; i < 2; ++i) {
            const auto d = surface.derivatives(p);
            const Vec3 off = target - d[0];
            const double e = dot(d[1], d[1]);
            const double f = dot(d[1], d[2]);
            const double g = dot(d[2], d[2]);
            const double det = e * g - f * f;
            if (!(det > 1e-10 * e * g) || !(det > 0)) {
                p = surface.nearest(target, p);
                break;
            }
            const double a = dot(off, d[1]);
            const double b = dot(off, d[2]);
            p = p + Uv{(g * a - f * b) / det, (e * b - f * a) / det};
        }
        return {std::clamp(p.u, surface.low().u, surface.high().u),
                std::clamp(p.v, surface.low().v, surface.high().v)};
    }
    // The corner across does not change when the node moves.
    [[nodiscard]] double cost(std::size_t n) const {
        double sum = 0;
        for (const std::int32_t q : quads_at[n]) {
            const Quad &nodes = quad(q);
            for (std::size_t c = 0; c < 4; ++c) {
                if (static_cast<std::size_t>(nodes[(c + 2) % 4]) != n) {
                    sum += steep(corner_quality(mesh, nodes, c));
                }
            }
        }
        return sum + shortness(n);
    }
    // Sides that are much shorter than the others at the node cost, too: angles alone would let
    // nodes come to lie on the boundary.
    [[nodiscard]] double shortness(std::size_t n) const {
        double sum = 0;
        double count = 0;
        constexpr std::size_t most = 24;
        std::array<double, most> lengths{};
        std::size_t own = 0;
        for (const std::int32_t q : quads_at[n]) {
            const Quad &nodes = quad(q);
            for (std::size_t c = 0; c < 4; ++c) {
                const auto a = static_cast<std::size_t>(nodes[c]);
                const auto b = static_cast<std::size_t>(nodes[(c + 1) % 4]);
                const double l = distance(mesh.points[a], mesh.points[b]);
                sum += l;
                count += 1;
                if ((a == n || b == n) && own < most) {
                    lengths[own++] = l;
                }
            }
        }
        constexpr double enough = 0.5;
        double cost = 0;
        for (std::size_t i = 0; i < own; ++i) {
            const double share = lengths[i] * count / (enough * sum);
            if (share < 1) {
                cost += steep(share) - steep(1);
            }
        }
        return cost;
    }
    [[nodiscard]] double worst(std::size_t n) const {
        double least = 1;
        for (const std::int32_t q : quads_at[n]) {
            least = std::min(least, quad_quality(mesh, quad(q)));
        }
        return least;
    }
    [[nodiscard]] double radius(std::size_t n) const {
        double least = std::numeric_limits<double>::infinity();
        for (const std::int32_t q : quads_at[n]) {
            for (std::size_t c = 0; c < 4; ++c) {
                if (static_cast<std::size_t>(quad(q)[c]) == n) {
                    for (const std::size_t o : {(c + 1) % 4, (c + 3) % 4}) {
                        const auto other = static_cast<std::size_t>(quad(q)[o]);
                        least = std::min(least, distance(mesh.points[n], mesh.points[other]));
                    }
                    const auto across = static_cast<std::size_t>(quad(q)[(c + 2) % 4]);
                    least = std::max(least, 0.1 * distance(mesh.points[n], mesh.points[across]));
                }
            }
        }
        return std::isfinite(least) ? least : 0;
    }
    void laplace(std::size_t n) {
        Vec3 sum{};
        double weights = 0;
        for (const std::int32_t q : quads_at[n]) {
            for (std::size_t c = 0; c < 4; ++c) {
                if (static_cast<std::size_t>(quad(q)[c]) == n) {
                    for (const std::size_t o : {(c + 1) % 4, (c + 3) % 4}) {
                        sum += mesh.points[static_cast<std::size_t>(quad(q)[o])];
                        weights += 1;
                    }
                }
            }
        }
        if (weights == 0) {
            return;
        }
        const Uv old = mesh.uv[n];
        const double before = worst(n);
        mesh.move(surface, static_cast<std::int32_t>(n), towards(n, (1 / weights) * sum));
        if (worst(n) < std::min(before, 0.3)) {
            mesh.move(surface, static_cast<std::int32_t>(n), old);
        }
    }
    // True when the node moved.
    bool search(std::size_t n, double step) {
        const auto id = static_cast<std::int32_t>(n);
        const Uv start = mesh.uv[n];
        const Vec3 normal = mesh.normals[n];
        if (norm2(normal) == 0) {
            return false;
        }
        const Vec3 axis = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 s = unit(cross(normal, axis));
        const Vec3 t = cross(normal, s);
        const Vec3 here = mesh.points[n];
        // Steps are short: the tangent plane tells where they lead to.
        const auto d = surface.derivatives(start);
        const double e = dot(d[1], d[1]);
        const double f = dot(d[1], d[2]);
        const double g = dot(d[2], d[2]);
        const double det = e * g - f * f;
        const bool regular = det > 1e-6 * e * g;
        const double best_before = cost(n);
        double best = best_before;
        Uv place = start;
        FaceSurface::Place found{here, normal};
        constexpr int directions = 8;
        for (int k = 0; k < directions; ++k) {
            const double angle = 2 * std::numbers::pi * k / directions;
            const Vec3 off = step * (std::cos(angle) * s + std::sin(angle) * t);
            mesh.uv[n] = start;
            Uv to{};
            if (regular) {
                const double a = dot(off, d[1]);
                const double b = dot(off, d[2]);
                to = start + Uv{(g * a - f * b) / det, (e * b - f * a) / det};
                to = {std::clamp(to.u, surface.low().u, surface.high().u),
                      std::clamp(to.v, surface.low().v, surface.high().v)};
            } else {
                to = towards(n, here + off);
            }
            mesh.move(surface, id, to);
            const double c = cost(n);
            if (c < best) {
                best = c;
                place = to;
                found = {mesh.points[n], mesh.normals[n]};
            }
        }
        mesh.uv[n] = place;
        mesh.points[n] = found.point;
        mesh.normals[n] = found.normal;
        return best < best_before * (1 - 1e-6);
    }
};

} // namespace

void smooth_quads(FaceMesh &mesh, const FaceSurface &surface, int laplace_rounds,
                  int search_rounds) {
    std::vector<std::size_t> all(mesh.points.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    smooth_quads(mesh, surface, laplace_rounds, search_rounds, all);
}

void smooth_quads(FaceMesh &mesh, const FaceSurface &surface, int laplace_rounds, int search_rounds,
                  std::span<const std::size_t> nodes) {
    Smoother smoother(mesh, surface);
    std::vector<std::size_t> free;
    for (const std::size_t n : nodes) {
        if (mesh.layout_point[n] < 0 && !smoother.quads_at[n].empty()) {
            free.push_back(n);
        }
    }
    for (int round = 0; round < laplace_rounds; ++round) {
        for (const std::size_t n : free) {
            smoother.laplace(n);
        }
    }
    std::vector<double> step(mesh.points.size(), 0);
    for (const std::size_t n : free) {
        step[n] = 0.25 * smoother.radius(n);
    }
    // A node rests when short steps lead nowhere, until one beside it moves.
    constexpr int most_halvings = 4;
    std::vector<char> halvings(mesh.points.size(), 0);
    for (int round = 0; round < search_rounds; ++round) {
        bool moved = false;
        for (const std::size_t n : free) {
            if (halvings[n] >= most_halvings) {
                continue;
            }
            constexpr double fine = 0.7;
            constexpr double very_fine = 0.9;
            if (smoother.worst(n) > (round > 1 ? fine : very_fine)) {
                continue;
            }
            if (smoother.search(n, step[n])) {
                moved = true;
                for (const std::int32_t q : smoother.quads_at[n]) {
                    for (const std::int32_t m : smoother.quad(q)) {
                        auto &count = halvings[static_cast<std::size_t>(m)];
                        count = std::min<char>(count, most_halvings - 1);
                    }
                }
            } else {
                step[n] *= 0.5;
                ++halvings[n];
            }
        }
        if (!moved && round > 6) {
            break;
        }
    }
}

} // namespace nmgs::cad
