// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/layout.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"
#include "nmgs/support/ascending.h"
#include "nmgs_cad/cad_geometry.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>

#include <algorithm>

namespace nmgs::cad {
namespace {

using Pair = std::array<std::int32_t, 2>;
using Four = std::array<std::int32_t, 4>;

Four four(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    Four key{a, b, c, d};
    std::sort(key.begin(), key.end());
    return key;
}

// What lies between points: on which entity, and where its middle is.
struct Curves {
    struct Curve {
        CadEntity on;
        Vec3 middle;
    };
    const CadShape &shape;
    const Layout &layout;
    std::map<Pair, Curve> known;
    std::map<Four, int> faces;

    Curves(const CadShape &s, const Layout &l) : shape(s), layout(l) {
        BorrowedGeometry geometry(shape);
        for (std::size_t n = 1; n < layout.edges.size(); ++n) {
            const auto &points = layout.edges[n];
            const auto edge = static_cast<int>(n);
            if (points.size() < 2 || BRep_Tool::Degenerated(shape.edge(edge))) {
                continue;
            }
            const EdgeCurve &curve = geometry->curve(edge);
            std::vector<double> at{0};
            for (std::size_t i = 1; i + 1 < points.size(); ++i) {
                at.push_back(curve.fraction(layout.points[static_cast<std::size_t>(points[i])]));
            }
            at.push_back(1);
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                known[ascending(points[i], points[i + 1])] = {{1, edge},
                                                              curve.at(0.5 * (at[i] + at[i + 1]))};
            }
        }
        for (const auto &quad : layout.quads) {
            const auto &p = quad.points;
            faces[four(p[0], p[1], p[2], p[3])] = quad.face;
            for (std::size_t i = 0; i < 4; ++i) {
                const Pair key = ascending(p[i], p[(i + 1) % 4]);
                if (known.contains(key)) {
                    continue;
                }
                const auto given = layout.middles.find(key);
                Vec3 middle;
                if (given != layout.middles.end()) {
                    middle = given->second;
                } else {
                    FaceProjection &projection = geometry->face(quad.face);
                    projection.start(layout.points[static_cast<std::size_t>(key[0])]);
                    middle = projection.nearest(straight(key));
                }
                known[key] = {{2, quad.face}, middle};
            }
        }
    }
    [[nodiscard]] Vec3 straight(Pair key) const {
        return 0.5 * (layout.points[static_cast<std::size_t>(key[0])] +
                      layout.points[static_cast<std::size_t>(key[1])]);
    }
    [[nodiscard]] Curve of(std::int32_t a, std::int32_t b, int solid) const {
        const Pair key = ascending(a, b);
        const auto found = known.find(key);
        if (found != known.end()) {
            return found->second;
        }
        const auto given = layout.middles.find(key);
        return {{3, solid}, given == layout.middles.end() ? straight(key) : given->second};
    }
};

// The corner of a block at the given ends (0 or 2) of its directions.
std::size_t corner_at(int dimension, std::array<int, 3> digits) {
    const std::size_t count = dimension == 2 ? 4 : 8;
    for (std::size_t n = 0; n < count; ++n) {
        if (part::of_node(dimension, n) == part::code(digits[0], digits[1], digits[2])) {
            return n;
        }
    }
    return count;
}

void append(const Curves &curves, std::span<const std::int32_t> corners, int owner,
            CadBlocks &blocks) {
    const int dimension = blocks.model.dimension;
    const Layout &layout = curves.layout;
    std::array<std::vector<CadEntity>, part::count> on;
    const int codes = dimension == 2 ? 9 : part::count;
    std::array<Vec3, part::count> place{};
    for (int code = 0; code < codes; ++code) {
        const auto c = static_cast<std::size_t>(code);
        // The block's corners that the part touches: one, two, four or all.
        std::vector<std::int32_t> touching;
        const auto digits = part::digits(code);
        for (int k = 0; k < (dimension == 2 ? 1 : 3); k += 2) {
            for (int j = 0; j < 3; j += 2) {
                for (int i = 0; i < 3; i += 2) {
                    const std::array<int, 3> at{i, j, k};
                    bool inside = true;
                    for (std::size_t d = 0; d < 3; ++d) {
                        inside = inside && (digits[d] == 1 || digits[d] == at[d]);
                    }
                    if (inside) {
                        touching.push_back(corners[corner_at(dimension, at)]);
                    }
                }
            }
        }
        if (touching.size() == 1) {
            const auto p = static_cast<std::size_t>(touching[0]);
            on[c] = {layout.on[p]};
            place[c] = layout.points[p];
        } else if (touching.size() == 2) {
            const auto curve = curves.of(touching[0], touching[1], owner);
            on[c] = {dimension == 2 && curve.on.dimension == 3 ? CadEntity{2, owner} : curve.on};
            place[c] = curve.middle;
        } else if (touching.size() == 4 && dimension == 3) {
            const auto face =
                curves.faces.find(four(touching[0], touching[1], touching[2], touching[3]));
            on[c] = {face == curves.faces.end() ? CadEntity{3, owner} : CadEntity{2, face->second}};
        } else {
            on[c] = {{dimension, owner}};
        }
        if (dimension == 3 && on[c][0].dimension == 3 && part::dimension(code) < 3) {
            on[c].clear(); // a part inside a solid lies on nothing
        }
    }
    for (std::size_t n = 0; n < (dimension == 2 ? 8U : 20U); ++n) {
        blocks.model.nodes.push_back(place[static_cast<std::size_t>(part::of_node(dimension, n))]);
    }
    blocks.model.corners.insert(blocks.model.corners.end(), corners.begin(), corners.end());
    blocks.model.divisions.push_back({1, 1, dimension == 3 ? 1 : 0});
    for (const auto &entities : on) {
        blocks.binding.entities.insert(blocks.binding.entities.end(), entities.begin(),
                                       entities.end());
        blocks.binding.offsets.push_back(static_cast<std::int32_t>(blocks.binding.entities.size()));
    }
}

} // namespace

std::int32_t Layout::add_point(Vec3 p, CadEntity entity) {
    points.push_back(p);
    on.push_back(entity);
    return static_cast<std::int32_t>(points.size()) - 1;
}

std::int32_t Layout::vertex(const CadShape &shape, int n) {
    const auto found = vertices_.find(n);
    if (found != vertices_.end()) {
        return found->second;
    }
    return vertices_[n] = add_point(shape.point(n), {0, n});
}

const std::vector<std::int32_t> &Layout::divide_edge(const CadShape &shape, int n,
                                                     std::span<const double> fractions) {
    auto &list = edges[static_cast<std::size_t>(n)];
    if (!list.empty()) {
        return list;
    }
    BorrowedGeometry geometry(shape);
    const EdgeCurve &curve = geometry->curve(n);
    // Without regard to the edge's own orientation: as the curve runs.
    list.push_back(vertex(shape, shape.vertices.FindIndex(TopExp::FirstVertex(shape.edge(n)))));
    for (const double f : fractions) {
        list.push_back(add_point(curve.at(f), {1, n}));
    }
    list.push_back(vertex(shape, shape.vertices.FindIndex(TopExp::LastVertex(shape.edge(n)))));
    return list;
}

std::vector<std::int32_t> Layout::quads_of(int face) const {
    std::vector<std::int32_t> result;
    for (std::size_t q = 0; q < quads.size(); ++q) {
        if (quads[q].face == face) {
            result.push_back(static_cast<std::int32_t>(q));
        }
    }
    return result;
}

CadBlocks blocks_of(const CadShape &shape, const Layout &layout, int dimension) {
    const Curves curves(shape, layout);
    CadBlocks blocks;
    blocks.model.dimension = dimension;
    if (dimension == 2) {
        for (const auto &quad : layout.quads) {
            append(curves, quad.points, quad.face, blocks);
        }
    } else {
        for (const auto &hexa : layout.hexas) {
            append(curves, hexa.points, hexa.solid, blocks);
        }
    }
    return blocks;
}

} // namespace nmgs::cad
