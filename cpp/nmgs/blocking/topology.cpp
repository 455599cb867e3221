// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/topology.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/mesh/point_hash.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace nmgs {

int part::of_node(int dimension, std::size_t n) {
    const auto digit = [](double natural) { return static_cast<int>(natural) + 1; };
    return dimension == 2 ? code(digit(quad8::natural[n][0]), digit(quad8::natural[n][1]), 0)
                          : code(digit(hexa20::natural[n][0]), digit(hexa20::natural[n][1]),
                                 digit(hexa20::natural[n][2]));
}

namespace {

using Digits = std::array<int, 3>;

// Node number of the corner or mid-edge part (code) in the element's own order, -1 for the rest.
std::array<int, part::count> make_node_of_part(int dimension) {
    std::array<int, part::count> table{};
    table.fill(-1);
    for (int n = 0; n < (dimension == 2 ? 8 : 20); ++n) {
        table[static_cast<std::size_t>(part::of_node(dimension, static_cast<std::size_t>(n)))] = n;
    }
    return table;
}

const std::array<int, part::count> &node_of_part(int dimension) {
    static const auto patches = make_node_of_part(2);
    static const auto blocks = make_node_of_part(3);
    return dimension == 2 ? patches : blocks;
}

// Corners at the ends of an edge part, low end first.
std::array<int, 2> ends(int code) {
    const int axis = part::axes(code).axis[0];
    const int step = axis == 0 ? 1 : axis == 1 ? 3 : 9;
    return {code - step, code + step};
}

struct Finder {
    const BlockModel &model;
    Topology &topology;
    double tolerance;

    [[nodiscard]] Vec3 node(std::size_t block, int code) const {
        const int n = node_of_part(model.dimension)[static_cast<std::size_t>(code)];
        return model.element(block)[static_cast<std::size_t>(n)];
    }
    // The number of a corner part; only where the model has numbers.
    [[nodiscard]] std::int32_t number(std::size_t block, int code) const {
        const int n = node_of_part(model.dimension)[static_cast<std::size_t>(code)];
        return model.corners[block * static_cast<std::size_t>(model.corners_per_element()) +
                             static_cast<std::size_t>(n)];
    }
    // Whether two edge parts between the same corners are one.
    [[nodiscard]] bool same_edge(std::size_t a, int code_a, std::size_t b, int code_b) const {
        const Vec3 p = node(a, code_a);
        const Vec3 q = node(b, code_b);
        if (model.corners.empty()) {
            return same(p, q);
        }
        // Only a loop of two edges has two curves between its corners.
        const auto [low, high] = ends(code_a);
        return norm(p - q) <= 1e-3 * (distance(node(a, low), p) + distance(p, node(a, high)));
    }
    [[nodiscard]] bool same(Vec3 a, Vec3 b) const { return norm2(a - b) <= tolerance * tolerance; }

    void own(std::size_t block, int code) {
        topology.owner[block * part::count + static_cast<std::size_t>(code)] = {
            static_cast<std::int32_t>(block), static_cast<std::int8_t>(code), 0};
    }
    void share(std::size_t block, int code, Owner owner) {
        topology.owner[block * part::count + static_cast<std::size_t>(code)] = owner;
    }
    void conflict(std::size_t block, int code, const Owner &other, std::string reason) {
        const int at = part::dimension(code) == 2 ? -1 : code;
        Vec3 place{0, 0, 0};
        if (at >= 0) {
            place = node(block, at);
        }
        topology.conflicts.push_back({static_cast<std::int32_t>(block), code, other.block,
                                      other.part, place, std::move(reason)});
    }

    [[nodiscard]] int count(std::size_t block, int axis) const {
        return model.divisions[block][static_cast<std::size_t>(axis)];
    }
    [[nodiscard]] const std::vector<double> *spacing(std::size_t block, int axis) const {
        const std::size_t at =
            block * static_cast<std::size_t>(model.dimension) + static_cast<std::size_t>(axis);
        return at < model.spacing.size() && !model.spacing[at].empty() ? &model.spacing[at]
                                                                       : nullptr;
    }
    // Whether the lattice planes of the two directions are at the same positions.
    [[nodiscard]] bool spacing_agrees(std::size_t a, int axis_a, std::size_t b, int axis_b,
                                      bool reversed) const {
        const auto *sa = spacing(a, axis_a);
        const auto *sb = spacing(b, axis_b);
        if (sa == nullptr && sb == nullptr) {
            return true;
        }
        const int n = count(a, axis_a);
        for (int i = 0; i <= n; ++i) {
            const double uniform = static_cast<double>(i) / n;
            const int m = reversed ? n - i : i;
            const double ta = sa != nullptr ? (*sa)[static_cast<std::size_t>(i)] : uniform;
            double tb =
                sb != nullptr ? (*sb)[static_cast<std::size_t>(m)] : static_cast<double>(m) / n;
            if (reversed) {
                tb = 1 - tb;
            }
            if (std::abs(ta - tb) > 1e-9) {
                return false;
            }
        }
        return true;
    }

    void find_vertices(std::vector<std::int32_t> &vertex);
    void find_edges(const std::vector<std::int32_t> &vertex, std::vector<std::int32_t> &edge);
    void find_faces(const std::vector<std::int32_t> &vertex, const std::vector<std::int32_t> &edge);
};

void Finder::find_vertices(std::vector<std::int32_t> &vertex) {
    PointHash hash(tolerance);
    std::unordered_map<std::int32_t, std::int64_t> by_number;
    const bool numbered = !model.corners.empty();
    std::vector<Owner> first;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < part::count; ++code) {
            if (part::dimension(code) != 0 || (model.dimension == 2 && code >= 9)) {
                continue;
            }
            const Vec3 p = node(b, code);
            std::int64_t found = -1;
            if (numbered) {
                const auto known = by_number.find(number(b, code));
                found = known == by_number.end() ? -1 : known->second;
            } else {
                found = hash.find(p);
            }
            if (found < 0) {
                found = static_cast<std::int64_t>(first.size());
                if (numbered) {
                    by_number[number(b, code)] = found;
                } else {
                    hash.insert(p, found);
                }
                own(b, code);
                first.push_back(topology.of(b, code));
            } else {
                share(b, code, first[static_cast<std::size_t>(found)]);
            }
            vertex[b * part::count + static_cast<std::size_t>(code)] =
                static_cast<std::int32_t>(found);
        }
    }
}

void Finder::find_edges(const std::vector<std::int32_t> &vertex, std::vector<std::int32_t> &edge) {
    struct Known {
        Owner owner;
        std::int32_t index;
    };
    std::map<std::array<std::int32_t, 2>, std::vector<Known>> known;
    std::int32_t next = 0;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < part::count; ++code) {
            if (part::dimension(code) != 1 || (model.dimension == 2 && code >= 9)) {
                continue;
            }
            const auto [low, high] = ends(code);
            const std::int32_t v0 = vertex[b * part::count + static_cast<std::size_t>(low)];
            const std::int32_t v1 = vertex[b * part::count + static_cast<std::size_t>(high)];
            const int axis = part::axes(code).axis[0];
            own(b, code);
            std::int32_t &index = edge[b * part::count + static_cast<std::size_t>(code)];
            index = -1;
            // An edge whose ends are one point has no direction to compare; it stays its block's
            // own.
            if (v0 == v1) {
                index = next++;
                continue;
            }
            auto &candidates = known[{std::min(v0, v1), std::max(v0, v1)}];
            for (const Known &candidate : candidates) {
                const auto ob = static_cast<std::size_t>(candidate.owner.block);
                if (!same_edge(b, code, ob, candidate.owner.part)) {
                    continue;
                }
                const int other_low = ends(candidate.owner.part)[0];
                const bool reversed =
                    vertex[ob * part::count + static_cast<std::size_t>(other_low)] != v0;
                const int other_axis = part::axes(candidate.owner.part).axis[0];
                index = candidate.index;
                topology.edge_reversed[b * part::count + static_cast<std::size_t>(code)] =
                    reversed ? 1 : 0;
                const int mine = count(b, axis);
                const int theirs = count(ob, other_axis);
                if (mine != theirs) {
                    conflict(b, code, candidate.owner,
                             "divided into " + std::to_string(mine) + " here and into " +
                                 std::to_string(theirs) + " there");
                } else if (!spacing_agrees(b, axis, ob, other_axis, reversed)) {
                    conflict(b, code, candidate.owner, "spaced differently");
                } else {
                    Owner owner = candidate.owner;
                    owner.flip = reversed ? 1 : 0;
                    share(b, code, owner);
                }
                break;
            }
            if (index < 0) {
                index = next++;
                candidates.push_back({topology.of(b, code), index});
            }
        }
    }
}

// Code of the corner or mid-edge part at (u, v) in {0, 1, 2}^2 of a face part.
int on_face(int face, int u, int v) {
    Digits d = part::digits(face);
    const auto a = part::axes(face);
    d[static_cast<std::size_t>(a.axis[0])] = u;
    d[static_cast<std::size_t>(a.axis[1])] = v;
    return part::code(d[0], d[1], d[2]);
}

void Finder::find_faces(const std::vector<std::int32_t> &vertex,
                        const std::vector<std::int32_t> &edge) {
    // What a corner or mid-edge part is, the same in all blocks.
    const auto identity = [&](std::size_t block, int code) {
        return (part::dimension(code) == 0
                    ? vertex
                    : edge)[block * part::count + static_cast<std::size_t>(code)];
    };
    constexpr std::array<std::array<int, 2>, 8> rim{
        {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}};
    std::map<std::array<std::int32_t, 4>, std::vector<Owner>> known;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < part::count; ++code) {
            if (part::dimension(code) != 2) {
                continue;
            }
            own(b, code);
            std::array<std::int32_t, 4> key{};
            constexpr std::array<std::array<int, 2>, 4> middles{{{1, 0}, {0, 1}, {2, 1}, {1, 2}}};
            for (std::size_t m = 0; m < 4; ++m) {
                key[m] = edge[b * part::count + static_cast<std::size_t>(
                                                    on_face(code, middles[m][0], middles[m][1]))];
            }
            std::sort(key.begin(), key.end());
            auto &candidates = known[key];
            bool found = false;
            for (const Owner &candidate : candidates) {
                const auto ob = static_cast<std::size_t>(candidate.block);
                for (int flip = 0; flip < 8 && !found; ++flip) {
                    found = std::all_of(rim.begin(), rim.end(), [&](const auto &at) {
                        int u = at[0];
                        int v = at[1];
                        if ((flip & 4) != 0) {
                            std::swap(u, v);
                        }
                        u = (flip & 1) != 0 ? 2 - u : u;
                        v = (flip & 2) != 0 ? 2 - v : v;
                        return identity(b, on_face(code, at[0], at[1])) ==
                               identity(ob, on_face(candidate.part, u, v));
                    });
                    if (!found) {
                        continue;
                    }
                    const auto mine = part::axes(code);
                    const auto theirs = part::axes(candidate.part);
                    const bool swap = (flip & 4) != 0;
                    bool agrees = true;
                    for (std::size_t d = 0; d < 2; ++d) {
                        const std::size_t e = swap ? 1 - d : d;
                        const bool reversed = (flip & (e == 0 ? 1 : 2)) != 0;
                        agrees = agrees && count(b, mine.axis[d]) == count(ob, theirs.axis[e]) &&
                                 spacing_agrees(b, mine.axis[d], ob, theirs.axis[e], reversed);
                    }
                    // Where they do not agree, the edges have said so already.
                    if (agrees) {
                        share(b, code,
                              {candidate.block, candidate.part, static_cast<std::int8_t>(flip)});
                    }
                }
                if (found) {
                    break;
                }
            }
            if (!found) {
                candidates.push_back(topology.of(b, code));
            }
        }
    }
}

} // namespace

std::string part::name(int code, int dimension) {
    const auto &table = node_of_part(dimension);
    const auto number = [&](int c) {
        return std::to_string(table[static_cast<std::size_t>(c)] + 1);
    };
    switch (part::dimension(code)) {
    case 0:
        return "corner " + number(code);
    case 1: {
        const auto e = ends(code);
        return "edge " + number(e[0]) + "-" + number(e[1]);
    }
    case 2:
        return "face " + number(on_face(code, 0, 0)) + "-" + number(on_face(code, 2, 0)) + "-" +
               number(on_face(code, 2, 2)) + "-" + number(on_face(code, 0, 2));
    default:
        return "inside";
    }
}

double smallest_element_edge(const BlockModel &model) {
    double smallest = std::numeric_limits<double>::infinity();
    const auto &table = node_of_part(model.dimension);
    for (std::size_t b = 0; b < model.size(); ++b) {
        const auto nodes = model.element(b);
        for (int code = 0; code < (model.dimension == 2 ? 9 : part::count); ++code) {
            if (part::dimension(code) != 1) {
                continue;
            }
            const auto [low, high] = ends(code);
            const auto at = [&](int c) {
                return nodes[static_cast<std::size_t>(table[static_cast<std::size_t>(c)])];
            };
            const double length = distance(at(low), at(code)) + distance(at(code), at(high));
            const int n = model.divisions[b][static_cast<std::size_t>(part::axes(code).axis[0])];
            if (length > 0) {
                smallest = std::min(smallest, length / n);
            }
        }
    }
    return std::isfinite(smallest) ? smallest : 0.0;
}

double default_tolerance(const BlockModel &model) {
    return 1e-4 * smallest_element_edge(model);
}

Topology find_topology(const BlockModel &model, double tolerance) {
    Topology topology;
    topology.tolerance = tolerance < 0 ? default_tolerance(model) : tolerance;
    topology.owner.resize(model.size() * part::count);
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < part::count; ++code) {
            topology.owner[b * part::count + static_cast<std::size_t>(code)] = {
                static_cast<std::int32_t>(b), static_cast<std::int8_t>(code), 0};
        }
    }
    std::vector<std::int32_t> vertex(model.size() * part::count, -1);
    topology.edge.assign(model.size() * part::count, -1);
    topology.edge_reversed.assign(model.size() * part::count, 0);
    Finder finder{model, topology, topology.tolerance};
    finder.find_vertices(vertex);
    finder.find_edges(vertex, topology.edge);
    if (model.dimension == 3) {
        finder.find_faces(vertex, topology.edge);
    }
    topology.uses.assign(topology.owner.size(), 0);
    for (const Owner &o : topology.owner) {
        ++topology.uses[static_cast<std::size_t>(o.block) * part::count +
                        static_cast<std::size_t>(o.part)];
    }
    return topology;
}

} // namespace nmgs
