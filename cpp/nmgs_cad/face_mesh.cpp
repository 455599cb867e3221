// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_mesh.h"

#include "nmgs/element/quad8.h"
#include "nmgs/support/ascending.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace nmgs::cad {

std::int32_t FaceMesh::add(const FaceSurface &surface, Uv p) {
    const auto place = surface.place(p);
    points.push_back(place.point);
    uv.push_back(p);
    normals.push_back(place.normal);
    layout_point.push_back(-1);
    rim.emplace_back();
    return static_cast<std::int32_t>(points.size()) - 1;
}

void FaceMesh::move(const FaceSurface &surface, std::int32_t n, Uv p) {
    const auto i = static_cast<std::size_t>(n);
    const auto place = surface.place(p);
    uv[i] = p;
    points[i] = place.point;
    normals[i] = place.normal;
}

Uv FaceMesh::bend(std::int32_t a, std::int32_t b) const {
    const Rim &from = rim[static_cast<std::size_t>(a)];
    const Rim &to = rim[static_cast<std::size_t>(b)];
    return from.after == b ? from.bend_after : to.after == a ? to.bend_after : Uv{0, 0};
}

void FaceMesh::set_middle(const FaceSurface &surface, std::int32_t a, std::int32_t b, Uv bend) {
    const Uv half =
        0.5 * (uv[static_cast<std::size_t>(a)] + uv[static_cast<std::size_t>(b)]) + bend;
    middles[ascending(a, b)] = surface.at(half);
}

FaceMesh face_mesh_of(const FaceSurface &surface, const std::vector<BoundaryLoop> &boundary,
                      std::vector<std::vector<std::int32_t>> &numbers) {
    FaceMesh mesh;
    numbers.assign(boundary.size(), {});
    const Uv span = surface.high() - surface.low();
    std::multimap<std::int32_t, std::int32_t> of_point;
    for (std::size_t l = 0; l < boundary.size(); ++l) {
        const BoundaryLoop &loop = boundary[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const BoundaryNode &node = loop[i];
            std::int32_t number = -1;
            const auto [begin, end] = of_point.equal_range(node.point);
            for (auto it = begin; it != end; ++it) {
                const Uv d = mesh.uv[static_cast<std::size_t>(it->second)] - node.uv;
                if (std::abs(d.u) <= 1e-9 * span.u && std::abs(d.v) <= 1e-9 * span.v) {
                    number = it->second;
                }
            }
            if (number < 0) {
                number = static_cast<std::int32_t>(mesh.points.size());
                of_point.emplace(node.point, number);
                mesh.points.push_back(node.at);
                mesh.uv.push_back(node.uv);
                mesh.normals.push_back(surface.normal(node.uv));
                mesh.layout_point.push_back(node.point);
                FaceMesh::Rim rim;
                rim.angle = node.angle;
                rim.to_before = -1.0 * node.in;
                rim.to_after = node.out;
                rim.middle_after = node.middle;
                rim.bend_after = node.uv_middle - 0.5 * (node.uv + loop[(i + 1) % loop.size()].uv);
                mesh.rim.push_back(rim);
            } else {
                // Touched once more: what the boundary is there has no single answer.
                auto &rim = mesh.rim[static_cast<std::size_t>(number)];
                rim.angle += node.angle;
                rim.to_before = rim.to_after = {0, 0, 0};
            }
            numbers[l].push_back(number);
        }
        for (std::size_t i = 0; i < loop.size(); ++i) {
            auto &rim = mesh.rim[static_cast<std::size_t>(numbers[l][i])];
            rim.before = numbers[l][(i + loop.size() - 1) % loop.size()];
            rim.after = numbers[l][(i + 1) % loop.size()];
        }
    }
    return mesh;
}

namespace {

// Sine and cosine of the angle at corner c, not scaled; both 0 where it is not defined.
std::array<double, 2> corner(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad,
                             std::size_t c) {
    const auto at = [&](std::int32_t n) { return mesh.points[static_cast<std::size_t>(n)]; };
    const std::int32_t me = quad[c];
    const FaceMesh::Rim &rim = mesh.rim[static_cast<std::size_t>(me)];
    const auto direction = [&](std::int32_t other) {
        if (rim.after >= 0 && mesh.fixed(other)) {
            if (other == rim.after && norm2(rim.to_after) > 0) {
                return rim.to_after;
            }
            if (other == rim.before && norm2(rim.to_before) > 0) {
                return rim.to_before;
            }
        }
        return at(other) - at(me);
    };
    const Vec3 ahead = direction(quad[(c + 1) % 4]);
    const Vec3 back = direction(quad[(c + 3) % 4]);
    Vec3 n = mesh.normals[static_cast<std::size_t>(me)];
    if (norm2(n) == 0) {
        n = cross(at(quad[2]) - at(quad[0]), at(quad[3]) - at(quad[1]));
        const double l = norm(n);
        n = l > 0 ? (1 / l) * n : n;
    }
    // Of their projections onto the tangent plane.
    const double above = dot(ahead, n);
    const double below = dot(back, n);
    const double a2 = norm2(ahead);
    const double b2 = norm2(back);
    // A side that stands on the surface has no direction in it.
    if (!((a2 - above * above) * (b2 - below * below) > 1e-8 * a2 * b2)) {
        return {0, 0};
    }
    return {dot(n, cross(ahead, back)), dot(ahead, back) - above * below};
}

} // namespace

double corner_angle(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad, std::size_t c) {
    const auto [sine, cosine] = corner(mesh, quad, c);
    return std::atan2(sine, cosine);
}

double corner_quality(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad,
                      std::size_t c) {
    const auto [sine, cosine] = corner(mesh, quad, c);
    const double length = std::sqrt(sine * sine + cosine * cosine);
    return length > 0 ? sine / length : -1;
}

double quad_quality(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad) {
    double least = 1;
    for (std::size_t c = 0; c < 4; ++c) {
        least = std::min(least, corner_quality(mesh, quad, c));
    }
    return least;
}

double worst_quality(const FaceMesh &mesh) {
    double least = 1;
    for (const auto &quad : mesh.quads) {
        least = std::min(least, quad_quality(mesh, quad));
    }
    return least;
}

double curved_quality(const FaceMesh &mesh, const FaceSurface &surface) {
    double least = 1;
    for (const auto &quad : mesh.quads) {
        std::array<Vec3, 8> nodes{};
        Vec3 normal{};
        for (std::size_t c = 0; c < 4; ++c) {
            const auto a = static_cast<std::size_t>(quad[c]);
            const auto b = static_cast<std::size_t>(quad[(c + 1) % 4]);
            nodes[c] = mesh.points[a];
            normal += mesh.normals[a];
            const Vec3 straight = 0.5 * (mesh.points[a] + mesh.points[b]);
            const bool poles = norm2(mesh.normals[a]) == 0 || norm2(mesh.normals[b]) == 0;
            const auto follows = [&](std::size_t x, std::size_t y) {
                return mesh.layout_point[x] >= 0 && mesh.layout_point[y] >= 0 &&
                       mesh.rim[x].after == static_cast<std::int32_t>(y);
            };
            const auto given = mesh.middles.find(
                {std::min(quad[c], quad[(c + 1) % 4]), std::max(quad[c], quad[(c + 1) % 4])});
            if (given != mesh.middles.end()) {
                nodes[4 + c] = given->second;
            } else if (follows(a, b)) {
                nodes[4 + c] = mesh.rim[a].middle_after;
            } else if (follows(b, a)) {
                nodes[4 + c] = mesh.rim[b].middle_after;
            } else {
                nodes[4 + c] =
                    poles || surface.plane()
                        ? straight
                        : surface.at(surface.nearest(straight, 0.5 * (mesh.uv[a] + mesh.uv[b])));
            }
        }
        if (norm2(normal) == 0) {
            continue;
        }
        bool tip = false;
        for (std::size_t c = 0; c < 4; ++c) {
            tip = tip || unavoidable(mesh, quad, c);
        }
        if (tip) {
            // It is not divided: its chords count.
            for (std::size_t c = 0; c < 4; ++c) {
                const Vec3 a = nodes[(c + 1) % 4] - nodes[c];
                const Vec3 b = nodes[(c + 3) % 4] - nodes[c];
                const double sine =
                    dot(cross(a, b), normal) / (norm(a) * norm(b) * norm(normal) + 1e-300);
                if (sine <= 0 || !unavoidable(mesh, quad, c)) {
                    least = std::min(least, sine);
                }
            }
            continue;
        }
        // Between the corners only: there the sine of the sharpest corner counts by itself.
        constexpr std::array<double, 3> at{-0.75, 0, 0.75};
        for (const double xi : at) {
            for (const double eta : at) {
                const auto [d_xi, d_eta] = quad8::tangents(nodes, xi, eta);
                const double lengths = norm(d_xi) * norm(d_eta) * norm(normal);
                least =
                    std::min(least, lengths > 0 ? dot(cross(d_xi, d_eta), normal) / lengths : -1.0);
            }
        }
    }
    return least;
}

bool unavoidable(const FaceMesh &mesh, const std::array<std::int32_t, 4> &quad, std::size_t c) {
    constexpr double sharp = 0.35;
    const FaceMesh::Rim &rim = mesh.rim[static_cast<std::size_t>(quad[c])];
    const std::int32_t ahead = quad[(c + 1) % 4];
    const std::int32_t back = quad[(c + 3) % 4];
    // Where the boundary touches itself it has no single direction.
    const bool touched = norm2(rim.to_before) == 0 && norm2(rim.to_after) == 0 &&
                         norm2(mesh.normals[static_cast<std::size_t>(quad[c])]) > 0;
    return mesh.fixed(quad[c]) && rim.angle < sharp &&
           (touched ? mesh.fixed(ahead) && mesh.fixed(back)
                    : ahead == rim.after && back == rim.before);
}

double worst_avoidable(const FaceMesh &mesh, const FaceSurface &surface) {
    double least = curved_quality(mesh, surface);
    for (const auto &quad : mesh.quads) {
        for (std::size_t c = 0; c < 4; ++c) {
            if (!unavoidable(mesh, quad, c)) {
                least = std::min(least, corner_quality(mesh, quad, c));
            }
        }
    }
    return least;
}

void put(const FaceMesh &mesh, int face, Layout &layout) {
    std::vector<std::int32_t> number = mesh.layout_point;
    std::vector<char> used(mesh.points.size(), 0);
    for (const auto &quad : mesh.quads) {
        for (const std::int32_t n : quad) {
            used[static_cast<std::size_t>(n)] = 1;
        }
    }
    for (std::size_t n = 0; n < number.size(); ++n) {
        if (number[n] < 0 && used[n] != 0) {
            number[n] = layout.add_point(mesh.points[n], {2, face});
        }
    }
    for (const auto &[ends, middle] : mesh.middles) {
        const std::int32_t a = number[static_cast<std::size_t>(ends[0])];
        const std::int32_t b = number[static_cast<std::size_t>(ends[1])];
        layout.middles[ascending(a, b)] = middle;
    }
    for (const auto &quad : mesh.quads) {
        Layout::Quad q{{}, face};
        for (std::size_t i = 0; i < 4; ++i) {
            q.points[i] = number[static_cast<std::size_t>(quad[i])];
        }
        layout.quads.push_back(q);
    }
}

} // namespace nmgs::cad
