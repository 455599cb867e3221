// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/logical_lattice.h"

#include "nmgs_cad/edge_curve.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

namespace nmgs::cad {
namespace {

struct Difference { // x[high] - x[low] = length
    std::size_t low, high;
    double length;
};

// Vertices that lie in one plane of the lattice, and how far the planes are from one another.
struct Axis {
    std::vector<std::size_t> plane_class; // by vertex
    std::size_t classes = 0;
    std::vector<Difference> hard, soft;
    std::vector<double> place; // by class
};

// Least squares of all differences, relative to their lengths; the soft ones hardly count. Dense:
// there are few classes.
bool solve(Axis &axis) {
    const std::size_t n = axis.classes;
    std::vector<double> a(n * n, 0.0);
    std::vector<double> b(n, 0.0);
    const auto add = [&](const Difference &d, double weight) {
        a[d.low * n + d.low] += weight;
        a[d.high * n + d.high] += weight;
        a[d.low * n + d.high] -= weight;
        a[d.high * n + d.low] -= weight;
        b[d.high] += weight * d.length;
        b[d.low] -= weight * d.length;
    };
    double mean = 0;
    for (const auto &d : axis.hard) {
        mean += d.length / static_cast<double>(axis.hard.size());
    }
    if (!(mean > 0)) {
        return false;
    }
    for (const auto &d : axis.hard) {
        add(d, mean * mean / (d.length * d.length));
    }
    for (const auto &d : axis.soft) {
        add(d, 1e-4);
    }
    for (std::size_t i = 0; i < n; ++i) {
        a[i * n + i] += 1e-10; // what nothing holds stays at 0
    }
    for (std::size_t k = 0; k < n; ++k) { // Gauss: positive definite, no pivoting needed
        for (std::size_t i = k + 1; i < n; ++i) {
            const double f = a[i * n + k] / a[k * n + k];
            if (f == 0) {
                continue;
            }
            for (std::size_t j = k; j < n; ++j) {
                a[i * n + j] -= f * a[k * n + j];
            }
            b[i] -= f * b[k];
        }
    }
    axis.place.assign(n, 0.0);
    for (std::size_t k = n; k-- > 0;) {
        double sum = b[k];
        for (std::size_t j = k + 1; j < n; ++j) {
            sum -= a[k * n + j] * axis.place[j];
        }
        axis.place[k] = sum / a[k * n + k];
    }
    return true;
}

struct Builder {
    const CadShape &shape;
    const SolidBoundary &boundary;
    const LogicalDirections &directions;
    std::vector<int> vertices; // ascending
    std::array<Axis, 3> axes;
    LogicalLattice lattice;

    [[nodiscard]] std::size_t place_of(int vertex) const {
        return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), vertex) -
                                        vertices.begin());
    }
    [[nodiscard]] int end_of(std::size_t coedge) const {
        return boundary.coedges[static_cast<std::size_t>(boundary.coedges[coedge].next)].vertex;
    }
    void classes();
    void relate_loops();
    bool order(double merge);
    bool walls();
    bool fill();
    [[nodiscard]] bool simple() const;
};

void Builder::classes() {
    std::set<int> all;
    for (const auto &c : boundary.coedges) {
        all.insert(c.vertex);
    }
    vertices.assign(all.begin(), all.end());
    for (std::size_t a = 0; a < 3; ++a) {
        std::vector<std::size_t> parent(vertices.size());
        std::iota(parent.begin(), parent.end(), std::size_t{0});
        const std::function<std::size_t(std::size_t)> root = [&](std::size_t n) {
            return parent[n] == n ? n : parent[n] = root(parent[n]);
        };
        const auto join = [&](std::size_t p, std::size_t q) { parent[root(p)] = root(q); };
        for (std::size_t i = 0; i < boundary.coedges.size(); ++i) {
            const std::size_t from = place_of(boundary.coedges[i].vertex);
            if (static_cast<std::size_t>(axis_of(directions.coedge[i])) != a) {
                join(from, place_of(end_of(i)));
            }
            const auto face = static_cast<std::size_t>(boundary.coedges[i].face);
            if (static_cast<std::size_t>(axis_of(directions.face[face])) == a) {
                const int first = boundary.loops[face].front(); // holes of a face are in its plane
                join(from, place_of(boundary.coedges[static_cast<std::size_t>(first)].vertex));
            }
        }
        Axis &axis = axes[a];
        std::map<std::size_t, std::size_t> number;
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            axis.plane_class.push_back(number.try_emplace(root(v), number.size()).first->second);
        }
        axis.classes = number.size();
    }
    for (std::size_t i = 0; i < boundary.coedges.size(); ++i) {
        const Coedge &c = boundary.coedges[i];
        if (!c.forward) {
            continue; // once an edge
        }
        Axis &axis = axes[static_cast<std::size_t>(axis_of(directions.coedge[i]))];
        std::size_t low = axis.plane_class[place_of(c.vertex)];
        std::size_t high = axis.plane_class[place_of(end_of(i))];
        if (sign_of(directions.coedge[i]) < 0) {
            std::swap(low, high);
        }
        axis.hard.push_back({low, high, EdgeCurve(shape.edge(c.edge)).length()});
    }
}

// Where the holes of a face are, by the mean directions in which its edges run.
void Builder::relate_loops() {
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        if (boundary.loops[f].size() < 2) {
            continue;
        }
        std::array<Vec3, 3> along{};
        std::vector<std::vector<int>> loops;
        for (const int start : boundary.loops[f]) {
            loops.emplace_back();
            int at = start;
            do {
                const auto c = static_cast<std::size_t>(at);
                loops.back().push_back(boundary.coedges[c].vertex);
                const Vec3 chord = shape.point(end_of(c)) - shape.point(loops.back().back());
                const auto d = directions.coedge[c];
                along[static_cast<std::size_t>(axis_of(d))] +=
                    static_cast<double>(sign_of(d)) * chord;
                at = boundary.coedges[c].next;
            } while (at != start);
        }
        for (std::size_t a = 0; a < 3; ++a) {
            if (static_cast<std::size_t>(axis_of(directions.face[f])) == a || norm(along[a]) == 0) {
                continue;
            }
            const Vec3 unit = (1 / norm(along[a])) * along[a];
            for (std::size_t l = 1; l < loops.size(); ++l) {
                for (const int v : loops[l]) {
                    for (const int w : loops[0]) {
                        const double d = dot(unit, shape.point(v) - shape.point(w));
                        axes[a].soft.push_back({axes[a].plane_class[place_of(w)],
                                                axes[a].plane_class[place_of(v)], d});
                    }
                }
            }
        }
    }
}

bool Builder::order(double merge) {
    for (std::size_t a = 0; a < 3; ++a) {
        Axis &axis = axes[a];
        if (!solve(axis)) {
            return false;
        }
        std::vector<double> shortest(axis.classes, std::numeric_limits<double>::infinity());
        double extent = 0;
        for (const auto &d : axis.hard) {
            if (!(axis.place[d.high] > axis.place[d.low])) {
                return false;
            }
            shortest[d.low] = std::min(shortest[d.low], d.length);
            shortest[d.high] = std::min(shortest[d.high], d.length);
            extent = std::max(extent, d.length);
        }
        std::vector<std::size_t> sorted(axis.classes);
        std::iota(sorted.begin(), sorted.end(), std::size_t{0});
        std::sort(sorted.begin(), sorted.end(), [&](std::size_t p, std::size_t q) {
            return axis.place[p] != axis.place[q] ? axis.place[p] < axis.place[q] : p < q;
        });
        std::vector<int> plane(axis.classes, -1);
        std::vector<std::size_t> members;
        double limit = 0;
        int count = 0;
        std::vector<double> places;
        for (const std::size_t c : sorted) {
            const double room = std::max(1e-6 * extent, merge * std::min(limit, shortest[c]));
            bool apart = members.empty() || axis.place[c] - axis.place[members.front()] > room;
            for (const auto &d : axis.hard) {
                apart = apart || (d.high == c && std::find(members.begin(), members.end(), d.low) !=
                                                     members.end());
            }
            if (apart) {
                members.clear();
                limit = std::numeric_limits<double>::infinity();
                places.push_back(0);
                ++count;
            }
            members.push_back(c);
            limit = std::min(limit, shortest[c]);
            plane[c] = count - 1;
            places.back() += (axis.place[c] - places.back()) / static_cast<double>(members.size());
        }
        constexpr int most = 200;
        if (count < 2 || count > most) {
            return false;
        }
        lattice.planes[a] = places;
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            lattice.vertex[vertices[v]][a] = plane[axis.plane_class[v]];
        }
    }
    std::set<std::array<int, 3>> taken;
    for (const auto &[v, at] : lattice.vertex) {
        if (!taken.insert(at).second) {
            return false;
        }
    }
    return true;
}

// The unit squares of each face: those round which its loops go once.
bool Builder::walls() {
    for (std::size_t a = 0; a < 3; ++a) {
        std::size_t size = 1;
        for (std::size_t d = 0; d < 3; ++d) {
            size *= static_cast<std::size_t>(lattice.cells(d) + (d == a ? 1 : 0));
        }
        lattice.face[a].assign(size, -1);
    }
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        const auto direction = directions.face[f];
        const auto a = static_cast<std::size_t>(axis_of(direction));
        const std::size_t u = (a + 1) % 3;
        const std::size_t v = (a + 2) % 3;
        struct Segment {
            int u, low, high, sign;
        };
        std::vector<Segment> segments; // along v
        int plane = 0;
        for (const int start : boundary.loops[f]) {
            int at = start;
            do {
                const auto c = static_cast<std::size_t>(at);
                const auto from = lattice.vertex[boundary.coedges[c].vertex];
                const auto to = lattice.vertex[end_of(c)];
                plane = from[a];
                if (from[v] != to[v]) {
                    segments.push_back({from[u], std::min(from[v], to[v]), std::max(from[v], to[v]),
                                        from[v] < to[v] ? 1 : -1});
                }
                at = boundary.coedges[c].next;
            } while (at != start);
        }
        for (int j = 0; j < lattice.cells(v); ++j) {
            for (int i = 0; i < lattice.cells(u); ++i) {
                int winding = 0;
                for (const auto &s : segments) {
                    winding += s.u > i && s.low <= j && j < s.high ? s.sign : 0;
                }
                if (winding == 0) {
                    continue;
                }
                std::array<int, 3> at{};
                at[a] = plane;
                at[u] = i;
                at[v] = j;
                auto &wall = lattice.face[a][lattice.wall(a, at)];
                if (winding != sign_of(direction) || wall >= 0) {
                    return false;
                }
                wall = static_cast<std::int32_t>(f);
            }
        }
    }
    return true;
}

bool Builder::fill() {
    const std::array<int, 3> n{lattice.cells(0), lattice.cells(1), lattice.cells(2)};
    lattice.filled.assign(static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
                              static_cast<std::size_t>(n[2]),
                          0);
    for (int k = 0; k < n[2]; ++k) {
        for (int j = 0; j < n[1]; ++j) {
            bool in = false;
            for (int i = 0; i <= n[0]; ++i) {
                const auto wall = lattice.face[0][lattice.wall(0, {i, j, k})];
                in = wall >= 0 ? !in : in;
                if (i < n[0]) {
                    lattice.filled[lattice.cell({i, j, k})] = in ? 1 : 0;
                } else if (in) {
                    return false;
                }
            }
        }
    }
    // A wall stands just where the inside meets the outside, and looks to the outside.
    for (std::size_t a = 0; a < 3; ++a) {
        std::array<int, 3> at{};
        for (at[2] = 0; at[2] < n[2] + (a == 2 ? 1 : 0); ++at[2]) {
            for (at[1] = 0; at[1] < n[1] + (a == 1 ? 1 : 0); ++at[1]) {
                for (at[0] = 0; at[0] < n[0] + (a == 0 ? 1 : 0); ++at[0]) {
                    auto below = at;
                    --below[a];
                    const int step = (lattice.inside(below) ? 1 : 0) - (lattice.inside(at) ? 1 : 0);
                    const auto wall = lattice.face[a][lattice.wall(a, at)];
                    const int looks =
                        wall < 0 ? 0 : sign_of(directions.face[static_cast<std::size_t>(wall)]);
                    if (step != looks) {
                        return false;
                    }
                }
            }
        }
    }
    return true;
}

// No two cells meet along an edge only.
bool Builder::simple() const {
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t u = (a + 1) % 3;
        const std::size_t v = (a + 2) % 3;
        std::array<int, 3> at{};
        for (at[a] = 0; at[a] < lattice.cells(a); ++at[a]) {
            for (at[u] = 1; at[u] < lattice.cells(u); ++at[u]) {
                for (at[v] = 1; at[v] < lattice.cells(v); ++at[v]) {
                    std::array<int, 3> left = at;
                    std::array<int, 3> down = at;
                    std::array<int, 3> both = at;
                    --left[u];
                    --down[v];
                    --both[u];
                    --both[v];
                    if (lattice.inside(at) == lattice.inside(both) &&
                        lattice.inside(left) == lattice.inside(down) &&
                        lattice.inside(at) != lattice.inside(left)) {
                        return false;
                    }
                }
            }
        }
    }
    return true;
}

} // namespace

std::optional<LogicalLattice> logical_lattice(const CadShape &shape, const SolidBoundary &boundary,
                                              const LogicalDirections &directions, double merge,
                                              Refusal &refusal) {
    Builder builder{shape, boundary, directions, {}, {}, {}};
    const std::string name = entity_name(3, boundary.solid);
    builder.classes();
    builder.relate_loops();
    if (!builder.order(merge)) {
        refusal = {"the edges of " + name + " cannot be put in order along three directions",
                   {name}};
        return std::nullopt;
    }
    if (!builder.walls() || !builder.fill() || !builder.simple()) {
        refusal = {"the faces of " + name + " do not enclose a lattice of cells", {name}};
        return std::nullopt;
    }
    return std::move(builder.lattice);
}

} // namespace nmgs::cad
