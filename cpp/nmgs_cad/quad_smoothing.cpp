// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nmgs::cad {
namespace {

using Quad = std::array<std::int32_t, 4>;

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
    [[nodiscard]] double cost(std::size_t n) const {
        constexpr double sharpness = 6;
        double sum = 0;
        for (const std::int32_t q : quads_at[n]) {
            for (std::size_t c = 0; c < 4; ++c) {
                sum += std::exp(-sharpness * corner_quality(mesh, quad(q), c));
            }
        }
        return sum + shortness(n);
    }
    // Sides that are much shorter than the others at the node cost, too: angles alone would let
    // nodes come to lie on the boundary.
    [[nodiscard]] double shortness(std::size_t n) const {
        double sum = 0;
        double count = 0;
        std::vector<double> lengths;
        for (const std::int32_t q : quads_at[n]) {
            for (std::size_t c = 0; c < 4; ++c) {
                const auto a = static_cast<std::size_t>(quad(q)[c]);
                const auto b = static_cast<std::size_t>(quad(q)[(c + 1) % 4]);
                const double l = distance(mesh.points[a], mesh.points[b]);
                sum += l;
                count += 1;
                if (a == n || b == n) {
                    lengths.push_back(l);
                }
            }
        }
        constexpr double sharpness = 6;
        constexpr double enough = 0.5;
        double cost = 0;
        for (const double l : lengths) {
            const double share = std::min(1.0, l * count / (enough * sum));
            cost += std::exp(-sharpness * share) - std::exp(-sharpness);
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
        Vec3 normal = mesh.normals[n];
        if (norm2(normal) == 0) {
            return false;
        }
        const Vec3 axis = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        Vec3 s = cross(normal, axis);
        s = (1 / norm(s)) * s;
        const Vec3 t = cross(normal, s);
        const Vec3 here = mesh.points[n];
        double best = cost(n);
        const double old = best;
        Uv place = start;
        constexpr int directions = 8;
        for (int k = 0; k < directions; ++k) {
            const double a = 2 * std::numbers::pi * k / directions;
            mesh.uv[n] = start;
            mesh.move(surface, id, towards(n, here + step * (std::cos(a) * s + std::sin(a) * t)));
            const double c = cost(n);
            if (c < best) {
                best = c;
                place = mesh.uv[n];
            }
        }
        mesh.move(surface, id, place);
        return best < old * (1 - 1e-6);
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
    for (int round = 0; round < search_rounds; ++round) {
        bool moved = false;
        for (const std::size_t n : free) {
            if (round > 3 && smoother.worst(n) > 0.7) {
                continue;
            }
            if (smoother.search(n, step[n])) {
                moved = true;
            } else {
                step[n] *= 0.5;
            }
        }
        if (!moved && round > 6) {
            break;
        }
    }
}

} // namespace nmgs::cad
