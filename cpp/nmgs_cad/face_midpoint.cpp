// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_midpoint.h"

#include "nmgs/support/at.h"
#include "nmgs_cad/quad_smoothing.h"

#include <numbers>
#include <set>

namespace nmgs::cad {
namespace {

constexpr double pi = std::numbers::pi;
using Numbers = std::vector<std::int32_t>;

// Each node inside at the mean of its neighbours' parameters.
void relax(FaceMesh &mesh, const FaceSurface &surface) {
    std::vector<std::set<std::int32_t>> neighbours(mesh.points.size());
    for (const auto &quad : mesh.quads) {
        for (std::size_t c = 0; c < 4; ++c) {
            neighbours[at(quad[c])].insert(quad[(c + 1) % 4]);
            neighbours[at(quad[(c + 1) % 4])].insert(quad[c]);
        }
    }
    constexpr int rounds = 200;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t n = 0; n < mesh.points.size(); ++n) {
            if (mesh.layout_point[n] >= 0 || neighbours[n].empty()) {
                continue;
            }
            Uv sum{0, 0};
            for (const std::int32_t m : neighbours[n]) {
                sum = sum + mesh.uv[at(m)];
            }
            mesh.uv[n] = (1.0 / static_cast<double>(neighbours[n].size())) * sum;
        }
    }
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
        if (mesh.layout_point[n] < 0) {
            mesh.move(surface, static_cast<std::int32_t>(n), mesh.uv[n]);
        }
    }
}

// A grid of quads between four lines of nodes: bottom and top run alike, as left and right do.
void fill_block(FaceMesh &mesh, const FaceSurface &surface, const Numbers &bottom,
                const Numbers &right, const Numbers &top, const Numbers &left) {
    const std::size_t m = bottom.size() - 1;
    const std::size_t n = left.size() - 1;
    Numbers below = bottom;
    for (std::size_t j = 1; j <= n; ++j) {
        Numbers row;
        for (std::size_t i = 0; i <= m; ++i) {
            if (j == n) {
                row.push_back(top[i]);
            } else if (i == 0) {
                row.push_back(left[j]);
            } else if (i == m) {
                row.push_back(right[j]);
            } else {
                row.push_back(
                    mesh.add(surface, 0.5 * (mesh.uv[at(bottom[i])] + mesh.uv[at(left[j])])));
            }
        }
        for (std::size_t i = 0; i < m; ++i) {
            mesh.quads.push_back({below[i], below[i + 1], row[i + 1], row[i]});
        }
        below = row;
    }
}

std::optional<FaceMesh> two_rows(const FaceSurface &surface, FaceMesh mesh, const Numbers &a,
                                 const Numbers &b, Refusal &refusal) {
    const std::size_t n = a.size() - 1;
    if (b.size() - 1 != n || n < 2) {
        refusal = {"its two sides have different numbers of segments", {}};
        return std::nullopt;
    }
    // b runs against a. c[i] lies between a[i] and its partner.
    const auto partner = [&](std::size_t i) { return b[n - i]; };
    Numbers c(n, -1);
    for (std::size_t i = 1; i < n; ++i) {
        c[i] = mesh.add(surface, 0.5 * (mesh.uv[at(a[i])] + mesh.uv[at(partner(i))]));
    }
    mesh.quads.push_back({a[0], a[1], c[1], partner(1)});
    for (std::size_t i = 1; i + 1 < n; ++i) {
        mesh.quads.push_back({a[i], a[i + 1], c[i + 1], c[i]});
        mesh.quads.push_back({c[i], c[i + 1], partner(i + 1), partner(i)});
    }
    mesh.quads.push_back({c[n - 1], a[n - 1], a[n], partner(n - 1)});
    smooth_quads(mesh, surface, 3, 20);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        mesh.set_middle(surface, c[i], c[i + 1],
                        0.5 * (mesh.bend(a[i], a[i + 1]) + mesh.bend(partner(i), partner(i + 1))));
    }
    return mesh;
}

} // namespace

std::vector<std::size_t> midpoint_corners(const FaceLoops &loops) {
    if (loops.loops.size() != 1 || !loops.inner.empty() || !loops.points.empty()) {
        return {};
    }
    constexpr double widest_corner = 0.75 * pi;
    constexpr double most_straight = 1.25 * pi;
    std::vector<std::size_t> corners;
    const FaceLoop &loop = loops.loops.front();
    for (std::size_t u = 0; u < loop.size(); ++u) {
        if (loop[u].degenerated || loop[u].seam || loop[u].angle > most_straight) {
            return {};
        }
        if (loop[u].angle < widest_corner) {
            corners.push_back(u);
        }
    }
    return corners.size() == 2 || corners.size() == 3 || corners.size() == 5
               ? corners
               : std::vector<std::size_t>{};
}

std::optional<std::vector<int>> midpoint_lines(const std::vector<int> &n) {
    // lines[i - 1] + lines[i + 1] = n[i]; round an odd number of sides that has one solution.
    const std::size_t count = n.size();
    std::vector<int> lines(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        int sum = 0;
        for (std::size_t k = 0; k < count; ++k) {
            sum += (k % 2 == 0 ? 1 : -1) * n[(i + 1 + 2 * k) % count];
        }
        if (sum < 2 || sum % 2 != 0) {
            return std::nullopt;
        }
        lines[i] = sum / 2;
    }
    return lines;
}

std::optional<FaceMesh> midpoint_quads(const FaceSurface &surface,
                                       const std::vector<std::size_t> &corners,
                                       const std::vector<BoundaryLoop> &boundary,
                                       Refusal &refusal) {
    std::vector<Numbers> numbers;
    FaceMesh mesh = face_mesh_of(surface, boundary, numbers);
    const BoundaryLoop &loop = boundary.front();
    const std::size_t sides = corners.size();
    std::vector<Numbers> side(sides);
    for (std::size_t s = 0; s < sides; ++s) {
        std::size_t i = 0;
        while (i < loop.size() && !(loop[i].vertex && loop[i].use == corners[s])) {
            ++i;
        }
        for (std::size_t k = 0; k <= loop.size(); ++k) {
            const BoundaryNode &node = loop[(i + k) % loop.size()];
            side[s].push_back(numbers[0][(i + k) % loop.size()]);
            if (k > 0 && node.vertex && node.use == corners[(s + 1) % sides]) {
                break;
            }
        }
    }
    if (sides == 2) {
        return two_rows(surface, std::move(mesh), side[0], side[1], refusal);
    }
    std::vector<int> n;
    n.reserve(side.size());
    for (const Numbers &s : side) {
        n.push_back(static_cast<int>(s.size()) - 1);
    }
    const auto lines = midpoint_lines(n);
    if (!lines) {
        refusal = {"the numbers of segments of its sides do not meet in the middle", {}};
        return std::nullopt;
    }
    // The line of side i starts lines[i - 1] segments from its start: the block at its start has
    // that many there, as the line of the side before has.
    Uv middle{0, 0};
    std::vector<std::size_t> split(sides);
    for (std::size_t s = 0; s < sides; ++s) {
        split[s] = static_cast<std::size_t>((*lines)[(s + sides - 1) % sides]);
        middle = middle + (1.0 / static_cast<double>(sides)) * mesh.uv[at(side[s][split[s]])];
    }
    const std::int32_t centre = mesh.add(surface, middle);
    std::vector<Numbers> line(sides); // from the side to the centre
    for (std::size_t s = 0; s < sides; ++s) {
        const int count = (*lines)[s];
        const std::int32_t from = side[s][split[s]];
        line[s].push_back(from);
        for (int k = 1; k < count; ++k) {
            const double t = static_cast<double>(k) / count;
            line[s].push_back(mesh.add(surface, (1 - t) * mesh.uv[at(from)] + t * middle));
        }
        line[s].push_back(centre);
    }
    for (std::size_t s = 0; s < sides; ++s) {
        const std::size_t before = (s + sides - 1) % sides;
        const Numbers bottom(side[s].begin(),
                             side[s].begin() + static_cast<std::ptrdiff_t>(split[s]) + 1);
        // From the corner back along the side before to its line.
        const Numbers left(side[before].rbegin(),
                           side[before].rend() - static_cast<std::ptrdiff_t>(split[before]));
        fill_block(mesh, surface, bottom, line[s], line[before], left);
    }
    relax(mesh, surface);
    constexpr double good = 0.7;
    if (worst_quality(mesh) < good) {
        smooth_quads(mesh, surface, 10, 25);
    }
    return mesh;
}

} // namespace nmgs::cad
