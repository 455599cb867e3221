// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/refit.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/mesh/point_hash.h"
#include "nmgs/support/error.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/face_projection.h"
#include "nmgs_cad/refine.h"

#include <TopExp.hxx>

#include <algorithm>
#include <map>
#include <set>

namespace nmgs::cad {
namespace {

// Numbers of the entities one dimension down that bound an entity.
std::multiset<int> bounds(const CadShape &shape, int dimension, int n) {
    TopTools_IndexedMapOfShape parts;
    std::multiset<int> numbers;
    if (dimension == 1) {
        numbers.insert(shape.vertices.FindIndex(TopExp::FirstVertex(shape.edge(n))));
        numbers.insert(shape.vertices.FindIndex(TopExp::LastVertex(shape.edge(n))));
        return numbers;
    }
    TopExp::MapShapes(dimension == 2 ? shape.faces(n) : shape.solids(n),
                      dimension == 2 ? TopAbs_EDGE : TopAbs_FACE, parts);
    for (int i = 1; i <= parts.Extent(); ++i) {
        numbers.insert((dimension == 2 ? shape.edges : shape.faces).FindIndex(parts(i)));
    }
    return numbers;
}

void require_same_topology(const CadShape &before, const CadShape &after) {
    const auto count = [](const CadShape &s, int d) {
        const std::array counts{s.vertices.Extent(), s.edges.Extent(), s.faces.Extent(),
                                s.solids.Extent()};
        return counts[static_cast<std::size_t>(d)];
    };
    constexpr const char *names[] = {"vertices", "edges", "faces", "solids"};
    for (int d = 0; d < 4; ++d) {
        if (count(before, d) != count(after, d)) {
            throw GeometryError("shape: the blocks were made for " +
                                    std::to_string(count(before, d)) + " " + names[d] +
                                    ", the shape now has " + std::to_string(count(after, d)),
                                {});
        }
    }
    for (int d = 1; d < 4; ++d) {
        for (int n = 1; n <= count(before, d); ++n) {
            if (bounds(before, d, n) != bounds(after, d, n)) {
                throw GeometryError("shape: " + entity_name(d, n) +
                                        " is no longer bounded by the same " + names[d - 1] +
                                        " as when the blocks were made",
                                    {entity_name(d, n)});
            }
        }
    }
}

// The blocks' nodes, each place once, joined along the halves of the blocks' edges.
struct Graph {
    std::vector<std::size_t> number; // of each node of each block
    std::vector<Vec3> points;
    std::vector<CadEntity> on;
    std::vector<std::set<std::size_t>> neighbours;

    Graph(const CadBlocks &blocks, double tolerance) {
        const bool solid = blocks.model.dimension == 3;
        const std::size_t per = solid ? 20 : 8;
        PointHash hash(tolerance);
        for (std::size_t b = 0; b < blocks.model.size(); ++b) {
            const auto nodes = blocks.model.element(b);
            for (std::size_t n = 0; n < per; ++n) {
                const std::array<double, 3> at =
                    solid ? hexa20::natural[n]
                          : std::array{quad8::natural[n][0], quad8::natural[n][1], -1.0};
                const auto digit = [&](std::size_t d) { return static_cast<int>(at[d]) + 1; };
                const auto entities =
                    blocks.binding.of(b, part::code(digit(0), digit(1), digit(2)));
                const CadEntity entity = entities.empty() ? CadEntity{3, 0} : entities[0];
                std::int64_t found = hash.find(nodes[n]);
                if (found < 0) {
                    found = static_cast<std::int64_t>(points.size());
                    hash.insert(nodes[n], found);
                    points.push_back(nodes[n]);
                    on.push_back(entity);
                    neighbours.emplace_back();
                }
                const auto id = static_cast<std::size_t>(found);
                if (entity.dimension < on[id].dimension) {
                    on[id] = entity;
                }
                number.push_back(id);
            }
            constexpr std::array<std::array<std::size_t, 3>, 12> edges{{{0, 8, 1},
                                                                        {1, 9, 2},
                                                                        {2, 10, 3},
                                                                        {3, 11, 0},
                                                                        {4, 12, 5},
                                                                        {5, 13, 6},
                                                                        {6, 14, 7},
                                                                        {7, 15, 4},
                                                                        {0, 16, 4},
                                                                        {1, 17, 5},
                                                                        {2, 18, 6},
                                                                        {3, 19, 7}}};
            constexpr std::array<std::array<std::size_t, 3>, 4> sides{
                {{0, 4, 1}, {1, 5, 2}, {2, 6, 3}, {3, 7, 0}}};
            const auto join = [&](const std::array<std::size_t, 3> &e) {
                for (std::size_t h = 0; h < 2; ++h) {
                    const std::size_t a = number[b * per + e[h]];
                    const std::size_t c = number[b * per + e[h + 1]];
                    if (a != c) {
                        neighbours[a].insert(c);
                        neighbours[c].insert(a);
                    }
                }
            };
            if (solid) {
                std::for_each(edges.begin(), edges.end(), join);
            } else {
                std::for_each(sides.begin(), sides.end(), join);
            }
        }
    }
};

// Spreads the moves of the nodes that are known to the others of `nodes`, by Gauss and Seidel's
// iteration. Only neighbours for which `counts` holds take part.
template <class Counts>
void spread(const Graph &graph, const std::vector<std::size_t> &nodes, std::vector<Vec3> &move,
            double size, const Counts &counts) {
    constexpr int most = 2000;
    for (int round = 0; round < most; ++round) {
        double change = 0;
        for (const std::size_t n : nodes) {
            Vec3 sum{};
            double weights = 0;
            for (const std::size_t m : graph.neighbours[n]) {
                if (counts(n, m)) {
                    const double weight =
                        1 / std::max(distance(graph.points[n], graph.points[m]), 1e-12 * size);
                    sum += weight * move[m];
                    weights += weight;
                }
            }
            if (weights > 0) {
                const Vec3 next = 1 / weights * sum;
                change = std::max(change, distance(next, move[n]));
                move[n] = next;
            }
        }
        if (change < 1e-9 * size) {
            break;
        }
    }
}

} // namespace

CadBlocks refit(const CadShape &before, const CadShape &after, const CadBlocks &blocks,
                const Progress &progress) {
    require_same_topology(before, after);
    const double size = before.diagonal();
    const Graph graph(blocks, std::min(default_tolerance(blocks.model), 1e-6 * size));
    std::vector<Vec3> move(graph.points.size());
    std::map<int, std::vector<std::size_t>> of_face;
    std::map<int, std::vector<std::size_t>> of_edge;
    std::vector<std::size_t> inner;
    for (std::size_t n = 0; n < graph.points.size(); ++n) {
        const CadEntity &entity = graph.on[n];
        if (entity.dimension == 0) {
            move[n] = after.point(entity.index) - graph.points[n];
        } else if (entity.dimension == 1) {
            of_edge[entity.index].push_back(n);
        } else if (entity.dimension == 2) {
            of_face[entity.index].push_back(n);
        } else {
            inner.push_back(n);
        }
    }
    poll(progress, 0.1);
    for (const auto &[edge, nodes] : of_edge) {
        const EdgeCurve from(before.edge(edge));
        const EdgeCurve to(after.edge(edge));
        for (const std::size_t n : nodes) {
            move[n] = to.at(from.fraction(graph.points[n])) - graph.points[n];
        }
    }
    poll(progress, 0.2);
    const double changed = std::max(size, after.diagonal());
    for (const auto &[face, nodes] : of_face) {
        spread(graph, nodes, move, changed, [&, face = face](std::size_t, std::size_t m) {
            const CadEntity &other = graph.on[m];
            return other.dimension < 2 || (other.dimension == 2 && other.index == face);
        });
        FaceProjection projection(after.face(face));
        for (const std::size_t n : nodes) {
            move[n] = projection.nearest(graph.points[n] + move[n]) - graph.points[n];
        }
    }
    poll(progress, 0.5);
    spread(graph, inner, move, changed, [](std::size_t, std::size_t) { return true; });
    CadBlocks result = blocks;
    for (std::size_t n = 0; n < graph.number.size(); ++n) {
        const std::size_t id = graph.number[n];
        result.model.nodes[n] = graph.points[id] + move[id];
    }
    poll(progress, 0.8);
    measure_report(after, result);
    return result;
}

} // namespace nmgs::cad
