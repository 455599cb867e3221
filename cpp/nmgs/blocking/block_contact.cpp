// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/block_contact.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/inverse_map.h"
#include "nmgs/element/quad8.h"
#include "nmgs/mesh/point_hash.h"
#include "nmgs/support/near_boxes.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace nmgs {
namespace {

// A face as an 8-node patch, or an edge as a flat one: its three nodes along xi, and eta unused.
struct Part {
    std::size_t block;
    int code;
    bool edge;
    std::array<Vec3, 8> nodes;
    std::array<Vec3, 2> out; // a place on it, and one further inside the block
    Box box;
    std::set<std::pair<std::int32_t, int>> corners; // owners
    std::vector<double> u, v;                       // natural positions of the lattice
};

Vec3 map_edge(const Part &part, double t) {
    return 0.5 * t * (t - 1) * part.nodes[0] + (1 - t * t) * part.nodes[1] +
           0.5 * t * (t + 1) * part.nodes[2];
}

Vec3 map(const Part &part, double u, double v) {
    return part.edge ? map_edge(part, u) : quad8::map(part.nodes, u, v);
}

// Nearest place on the part; inside when the foot is a perpendicular one.
Foot foot_on(const Part &part, Vec3 p) {
    if (!part.edge) {
        return find_foot(part.nodes, p);
    }
    double best = 0;
    double best_distance = INFINITY;
    for (int i = 0; i <= 8; ++i) {
        const double t = -1 + 0.25 * i;
        const double d = distance(map_edge(part, t), p);
        if (d < best_distance) {
            best = t;
            best_distance = d;
        }
    }
    double t = best;
    for (int step = 0; step < 20; ++step) {
        const Vec3 tangent =
            (t - 0.5) * part.nodes[0] + (-2 * t) * part.nodes[1] + (t + 0.5) * part.nodes[2];
        const double length = norm2(tangent);
        if (!(length > 0)) {
            break;
        }
        const double change = dot(p - map_edge(part, t), tangent) / length;
        t = std::clamp(t + change, -1.0, 1.0);
        if (std::abs(change) < 1e-12) {
            break;
        }
    }
    const Vec3 tangent =
        (t - 0.5) * part.nodes[0] + (-2 * t) * part.nodes[1] + (t + 0.5) * part.nodes[2];
    const Vec3 r = p - map_edge(part, t);
    const bool inside = std::abs(dot(r, tangent)) <= 1e-6 * norm2(tangent);
    return {t, 0, norm(r), inside};
}

Vec3 block_point(const BlockModel &model, std::size_t b, std::array<double, 3> natural) {
    const auto nodes = model.element(b);
    return model.dimension == 2
               ? quad8::map(nodes.first<8>(), natural[0], natural[1])
               : hexa20::map(nodes.first<20>(), natural[0], natural[1], natural[2]);
}

Part make_part(const BlockModel &model, const Topology &topology, std::size_t b, int code) {
    Part part{b, code, part::dimension(code) == 1, {}, {}, {}, {}, {}, {}};
    const auto digits = part::digits(code);
    const auto axes = part::axes(code);
    std::array<double, 3> natural{digits[0] - 1.0, digits[1] - 1.0,
                                  model.dimension == 3 ? digits[2] - 1.0 : 0.0};
    part.out[0] = block_point(model, b, natural);
    auto inner = natural;
    for (double &t : inner) {
        t *= 0.9;
    }
    part.out[1] = block_point(model, b, inner);
    const auto u = static_cast<std::size_t>(axes.axis[0]);
    const auto v = static_cast<std::size_t>(axes.axis[1]);
    for (std::size_t i = 0; i < (part.edge ? 3U : 8U); ++i) {
        natural[u] = part.edge ? static_cast<double>(i) - 1 : quad8::natural[i][0];
        if (!part.edge) {
            natural[v] = quad8::natural[i][1];
        }
        part.nodes[i] = block_point(model, b, natural);
        part.box.add(part.nodes[i]);
    }
    const Vec3 more = 0.25 * (part.box.high - part.box.low);
    part.box = {part.box.low - more, part.box.high + more};
    for (int corner = 0; corner < (model.dimension == 2 ? 9 : part::count); ++corner) {
        const auto c = part::digits(corner);
        bool on = part::dimension(corner) == 0;
        for (std::size_t d = 0; d < 3; ++d) {
            on = on && (digits[d] == 1 || digits[d] == c[d]);
        }
        if (on) {
            const Owner &owner = topology.of(b, corner);
            part.corners.emplace(owner.block, owner.part);
        }
    }
    part.u = natural_positions(model, b, axes.axis[0]);
    part.v = part.edge ? std::vector<double>{0} : natural_positions(model, b, axes.axis[1]);
    return part;
}

bool opposed(const Part &a, const Part &b) {
    return dot(a.out[0] - a.out[1], b.out[0] - b.out[1]) < 0;
}

// Whether samples of a come near b.
bool touches(const Part &a, const Part &b, double limit) {
    constexpr std::array<double, 5> samples{0, -0.9, 0.9, -0.45, 0.45};
    for (const double u : samples) {
        for (const double v : samples) {
            if (a.edge && v != 0) {
                continue;
            }
            const Vec3 p = map(a, u, v);
            if (!b.box.near(p, limit)) {
                continue;
            }
            const Foot foot = foot_on(b, p);
            if (foot.inside && foot.distance <= limit) {
                return true;
            }
        }
    }
    return false;
}

// The first cell of a whose middle lies on b, and which is no cell of b.
std::optional<Contact> bad_cell(const Part &a, const Part &b, double tolerance, double limit) {
    const std::size_t columns = b.u.size();
    PointHash hash(tolerance);
    for (std::size_t j = 0; j < b.v.size(); ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            hash.insert(map(b, b.u[i], b.v[j]), static_cast<std::int64_t>(j * columns + i));
        }
    }
    const std::size_t rows = a.edge ? 1 : a.v.size() - 1;
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i + 1 < a.u.size(); ++i) {
            const double v = a.edge ? 0 : 0.5 * (a.v[j] + a.v[j + 1]);
            const Vec3 middle = map(a, 0.5 * (a.u[i] + a.u[i + 1]), v);
            const Foot foot = foot_on(b, middle);
            if (!foot.inside || foot.distance > limit || std::abs(foot.xi) > 1 - 1e-9 ||
                (!a.edge && std::abs(foot.eta) > 1 - 1e-9)) {
                continue;
            }
            std::vector<std::int64_t> low;
            bool all = true;
            for (int corner = 0; corner < (a.edge ? 2 : 4); ++corner) {
                const std::size_t ci = i + static_cast<std::size_t>(corner & 1);
                const std::size_t cj = j + static_cast<std::size_t>(corner >> 1);
                const auto found = hash.find(map(a, a.u[ci], a.v[a.edge ? 0 : cj]));
                all = all && found >= 0;
                low.push_back(found);
            }
            if (all) {
                // One cell of b: its nodes span one step along each direction.
                const auto column = [&](std::int64_t n) {
                    return n % static_cast<std::int64_t>(columns);
                };
                const auto row = [&](std::int64_t n) {
                    return n / static_cast<std::int64_t>(columns);
                };
                const auto spread = [&](auto of) {
                    std::int64_t least = of(low[0]);
                    std::int64_t most = least;
                    for (const auto n : low) {
                        least = std::min(least, of(n));
                        most = std::max(most, of(n));
                    }
                    return most - least;
                };
                const std::set<std::int64_t> different(low.begin(), low.end());
                all = different.size() == low.size() && spread(column) <= 1 && spread(row) <= 1 &&
                      (!a.edge || spread(column) + spread(row) == 1); // no diagonal
            }
            if (!all) {
                return Contact{a.block, b.block, a.code, b.code, foot.distance, middle, false};
            }
        }
    }
    return std::nullopt;
}

// The first segment of an edge whose middle lies inside a patch: nothing joins the nodes there,
// even where they coincide.
std::optional<Contact> segment_inside(const Part &edge, const Part &patch, double limit) {
    for (std::size_t i = 0; i + 1 < edge.u.size(); ++i) {
        const Vec3 middle = map(edge, 0.5 * (edge.u[i] + edge.u[i + 1]), 0);
        if (!patch.box.near(middle, limit)) {
            continue;
        }
        const Foot foot = foot_on(patch, middle);
        if (foot.inside && foot.distance <= limit && std::abs(foot.xi) < 1 - 1e-6 &&
            std::abs(foot.eta) < 1 - 1e-6) {
            // Patches that go on in each other's plane overlap; others stand on each other.
            const Vec3 further = edge.out[1] - edge.out[0];
            const auto tangents = quad8::tangents(patch.nodes, foot.xi, foot.eta);
            const Vec3 normal = cross(tangents.xi, tangents.eta);
            const bool flat = std::abs(dot(further, normal)) <= 0.02 * norm(further) * norm(normal);
            return Contact{edge.block,    patch.block, edge.code, patch.code,
                           foot.distance, middle,      flat};
        }
    }
    return std::nullopt;
}

// Whether an edge is one of a face's sides.
bool is_side(int edge, int face) {
    const auto e = part::digits(edge);
    const auto f = part::digits(face);
    bool on = part::dimension(edge) == 1;
    for (std::size_t d = 0; d < 3; ++d) {
        on = on && (f[d] == 1 || f[d] == e[d]);
    }
    return on;
}

// Edges that lie in the faces of other blocks, or in other patches, without being theirs. Only
// faces that no other block shares, and their sides, can have or be such.
std::vector<Contact> edges_in_faces(const BlockModel &model, const Topology &topology) {
    std::vector<Part> parts;
    std::set<std::pair<std::int32_t, int>> sides; // owners
    const int codes = model.dimension == 2 ? 9 : part::count;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int face = 0; face < codes; ++face) {
            const bool outer =
                part::dimension(face) == 2 &&
                (model.dimension == 2 ||
                 topology.uses[b * part::count + static_cast<std::size_t>(face)] == 1);
            if (!outer) {
                continue;
            }
            parts.push_back(make_part(model, topology, b, face));
            for (int edge = 0; edge < codes; ++edge) {
                if (is_side(edge, face)) {
                    const Owner &owner = topology.of(b, edge);
                    sides.emplace(owner.block, owner.part);
                }
            }
        }
    }
    for (const auto &[block, edge] : sides) {
        parts.push_back(make_part(model, topology, static_cast<std::size_t>(block), edge));
    }
    std::vector<Box> boxes;
    boxes.reserve(parts.size());
    for (const Part &part : parts) {
        boxes.push_back(part.box);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const auto &[a, b] :
         near_boxes(boxes, topology.tolerance, 20 * most_near_boxes(parts.size()))) {
        if (parts[a].edge == parts[b].edge || parts[a].block == parts[b].block) {
            continue;
        }
        const auto pair = parts[a].edge ? std::pair{a, b} : std::pair{b, a};
        const auto &ends = parts[pair.first].corners;
        const auto &corners = parts[pair.second].corners;
        // An edge between two corners of the face is the face's own.
        if (!std::all_of(ends.begin(), ends.end(),
                         [&](const auto &end) { return corners.contains(end); })) {
            pairs.push_back(pair);
        }
    }
    std::vector<std::optional<Contact>> found(pairs.size());
    parallel_for(pairs.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Part &edge = parts[pairs[i].first];
            const Part &face = parts[pairs[i].second];
            if (touches(edge, face, topology.tolerance)) {
                found[i] = model.dimension == 2
                               ? segment_inside(edge, face, topology.tolerance)
                               : bad_cell(edge, face, topology.tolerance, topology.tolerance);
            }
        }
    });
    std::vector<Contact> contacts;
    for (const auto &contact : found) {
        if (contact) {
            contacts.push_back(*contact);
        }
    }
    return contacts;
}

} // namespace

std::vector<Contact> find_bad_contacts(const BlockModel &model, const Topology &topology,
                                       double gap) {
    std::vector<Part> parts;
    for (std::size_t b = 0; b < model.size(); ++b) {
        for (int code = 0; code < (model.dimension == 2 ? 9 : part::count); ++code) {
            if (part::dimension(code) == model.dimension - 1 && topology.owns(b, code) &&
                topology.uses[b * part::count + static_cast<std::size_t>(code)] == 1) {
                parts.push_back(make_part(model, topology, b, code));
            }
        }
    }
    std::vector<Box> boxes;
    boxes.reserve(parts.size());
    for (const Part &part : parts) {
        boxes.push_back(part.box);
    }
    const auto pairs = near_boxes(boxes, gap, most_near_boxes(parts.size()));
    std::vector<std::optional<Contact>> found(pairs.size());
    parallel_for(pairs.size(), 8, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Part &a = parts[pairs[i].first];
            const Part &b = parts[pairs[i].second];
            if (a.block == b.block || !opposed(a, b)) {
                continue;
            }
            const bool joined = std::any_of(a.corners.begin(), a.corners.end(),
                                            [&](const auto &c) { return b.corners.contains(c); });
            const double limit = joined ? topology.tolerance : std::max(gap, topology.tolerance);
            if (touches(a, b, limit) || touches(b, a, limit)) {
                found[i] = bad_cell(a, b, topology.tolerance, limit);
                if (!found[i]) {
                    found[i] = bad_cell(b, a, topology.tolerance, limit);
                }
            }
        }
    });
    std::vector<Contact> contacts;
    for (const auto &contact : found) {
        if (contact) {
            contacts.push_back(*contact);
        }
    }
    // Once a pair of blocks: an edge of a face that does not fit does not fit either.
    std::set<std::pair<std::size_t, std::size_t>> told;
    for (const Contact &contact : contacts) {
        told.insert(std::minmax(contact.block_a, contact.block_b));
    }
    for (const Contact &contact : edges_in_faces(model, topology)) {
        if (told.insert(std::minmax(contact.block_a, contact.block_b)).second) {
            contacts.push_back(contact);
        }
    }
    return contacts;
}

} // namespace nmgs
