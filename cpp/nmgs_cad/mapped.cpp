// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/mapped.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/support/ascending.h"
#include "nmgs_cad/edge_curve.h"
#include "nmgs_cad/four_sides.h"

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace nmgs::cad {
namespace {

// The corners, edges and faces of a block as numbers of the shape, by part code.
using BlockParts = std::array<int, part::count>;

struct SolidSides {
    std::map<int, FourSides> of_face;
    // Edge between two corners, and face with two edges, of the solid.
    std::map<std::array<int, 2>, int> edge;
};

// The block that stands on the given face with its corner 1 at the start-th corner. A solid that is
// stored inside out needs the bottom's corners the other way round.
bool make_parts(const SolidSides &sides, int bottom, std::size_t start, bool inside_out,
                BlockParts &parts) {
    parts.fill(0);
    // Seen from inside, the bottom's corners run the other way round.
    std::array<int, 8> corner{};
    const FourSides &base = sides.of_face.at(bottom);
    for (std::size_t i = 0; i < 4; ++i) {
        corner[i] = base.corner[(inside_out ? start + i : start + 4 - i) % 4];
    }
    const std::set<int> base_edges(base.edge.begin(), base.edge.end());
    for (std::size_t i = 0; i < 4; ++i) {
        for (const auto &[ends, edge] : sides.edge) {
            if (!base_edges.contains(edge) && (ends[0] == corner[i] || ends[1] == corner[i])) {
                corner[4 + i] = ends[0] == corner[i] ? ends[1] : ends[0];
            }
        }
    }
    for (std::size_t n = 0; n < 8; ++n) {
        parts[static_cast<std::size_t>(part::of_node(3, n))] = corner[n];
    }
    constexpr std::array<std::array<std::size_t, 2>, 12> ends{{{0, 1},
                                                               {1, 2},
                                                               {2, 3},
                                                               {3, 0},
                                                               {4, 5},
                                                               {5, 6},
                                                               {6, 7},
                                                               {7, 4},
                                                               {0, 4},
                                                               {1, 5},
                                                               {2, 6},
                                                               {3, 7}}};
    for (std::size_t e = 0; e < 12; ++e) {
        const auto found = sides.edge.find(ascending(corner[ends[e][0]], corner[ends[e][1]]));
        if (found == sides.edge.end()) {
            return false;
        }
        parts[static_cast<std::size_t>(part::of_node(3, 8 + e))] = found->second;
    }
    // A face is the one that has all four edges of the block's face.
    for (int code = 0; code < part::count; ++code) {
        if (part::dimension(code) != 2) {
            continue;
        }
        const auto axes = part::axes(code);
        std::set<int> wanted;
        for (int d = 0; d < 2; ++d) {
            for (const int end : {-1, 1}) {
                auto digits = part::digits(code);
                digits[static_cast<std::size_t>(axes.axis[static_cast<std::size_t>(d)])] += end;
                wanted.insert(
                    parts[static_cast<std::size_t>(part::code(digits[0], digits[1], digits[2]))]);
            }
        }
        for (const auto &[face, four] : sides.of_face) {
            if (std::set<int>(four.edge.begin(), four.edge.end()) == wanted) {
                parts[static_cast<std::size_t>(code)] = face;
            }
        }
        if (parts[static_cast<std::size_t>(code)] == 0) {
            return false;
        }
    }
    return true;
}

// How well xi, eta, zeta run along x, y, z: the sum of the three cosines.
double alignment(std::span<const Vec3, 20> nodes) {
    const auto centre = [&](std::array<std::size_t, 4> of) {
        return 0.25 * (nodes[of[0]] + nodes[of[1]] + nodes[of[2]] + nodes[of[3]]);
    };
    const Vec3 xi = centre({1, 2, 5, 6}) - centre({0, 3, 4, 7});
    const Vec3 eta = centre({2, 3, 6, 7}) - centre({0, 1, 4, 5});
    const Vec3 zeta = centre({4, 5, 6, 7}) - centre({0, 1, 2, 3});
    const auto cosine = [](double along, Vec3 v) { return norm(v) > 0 ? along / norm(v) : 0.0; };
    return cosine(xi.x, xi) + cosine(eta.y, eta) + cosine(zeta.z, zeta);
}

std::array<Vec3, 20> nodes_of(const CadShape &shape, const BlockParts &parts) {
    std::array<Vec3, 20> nodes{};
    for (std::size_t n = 0; n < 20; ++n) {
        const int index = parts[static_cast<std::size_t>(part::of_node(3, n))];
        nodes[n] = n < 8 ? shape.point(index) : EdgeCurve(shape.edge(index)).at(0.5);
    }
    return nodes;
}

// The block's corners, its quads on the CAD's faces, and itself.
bool add_block(const CadShape &shape, int solid, const SolidSides &sides, const BlockParts &parts,
               Layout &layout, Refusal &refusal) {
    Layout::Hexa hexa{{}, solid};
    for (std::size_t n = 0; n < 8; ++n) {
        hexa.points[n] = layout.vertex(shape, parts[static_cast<std::size_t>(part::of_node(3, n))]);
    }
    for (const auto &[ends, edge] : sides.edge) {
        if (layout.divide_edge(shape, edge, {}).size() != 2) {
            refusal = {entity_name(1, edge) + " is divided already", {entity_name(1, edge)}};
            return false;
        }
    }
    for (const auto &[face, four] : sides.of_face) {
        const auto there = layout.quads_of(face).size();
        if (there > 1) {
            refusal = {entity_name(2, face) + " is divided already", {entity_name(2, face)}};
            return false;
        }
        if (there == 0) {
            // four_sides() runs about the normal that the face has in the shape.
            Refusal none;
            const auto corners = four_sides(shape, face, none)->corner;
            Layout::Quad quad{{}, face};
            for (std::size_t i = 0; i < 4; ++i) {
                quad.points[i] = layout.vertex(shape, corners[i]);
            }
            layout.quads.push_back(quad);
        }
    }
    layout.hexas.push_back(hexa);
    return true;
}

} // namespace

bool fill_mapped(const CadShape &shape, int solid, Layout &layout, const LayoutOptions & /*o*/,
                 Refusal &refusal, const Progress & /*progress*/) {
    const std::string name = entity_name(3, solid);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape.solid(solid), TopAbs_FACE, faces);
    if (faces.Extent() != 6) {
        refusal = {name + " has " + std::to_string(faces.Extent()) +
                       " faces; six with four sides each are needed",
                   {name}};
        return false;
    }
    SolidSides sides;
    std::set<int> corners;
    // The orientation of a face inside this solid, not that of its first use in the shape.
    for (TopExp_Explorer it(shape.solid(solid), TopAbs_FACE); it.More(); it.Next()) {
        const int face = shape.faces.FindIndex(it.Current());
        auto four = four_sides(shape, face, refusal);
        if (!four) {
            return false;
        }
        if (shape.face(face).Orientation() != it.Current().Orientation()) {
            const FourSides other = *four;
            for (std::size_t i = 0; i < 4; ++i) {
                four->corner[i] = other.corner[3 - i];
                four->edge[i] = other.edge[(6 - i) % 4];
            }
        }
        for (std::size_t i = 0; i < 4; ++i) {
            corners.insert(four->corner[i]);
            sides.edge[ascending(four->corner[i], four->corner[(i + 1) % 4])] = four->edge[i];
        }
        sides.of_face[face] = *four;
    }
    if (corners.size() != 8 || sides.edge.size() != 12) {
        refusal = {name + " has six four-sided faces, but " + std::to_string(corners.size()) +
                       " corners and " + std::to_string(sides.edge.size()) +
                       " edges; a block has 8 and 12",
                   {name}};
        return false;
    }

    BlockParts best{};
    double best_alignment = -4;
    for (const auto &[face, four] : sides.of_face) {
        for (std::size_t start = 0; start < 8; ++start) {
            BlockParts parts{};
            if (!make_parts(sides, face, start % 4, start >= 4, parts)) {
                continue;
            }
            const auto candidate = nodes_of(shape, parts);
            const double a = alignment(candidate);
            if (a > best_alignment + 1e-9 && hexa20::jacobian(candidate, 0, 0, 0) > 0) {
                best_alignment = a;
                best = parts;
            }
        }
    }
    if (best_alignment == -4) {
        refusal = {name + " has six four-sided faces that do not join as a block's do", {name}};
        return false;
    }

    return add_block(shape, solid, sides, best, layout, refusal);
}

} // namespace nmgs::cad
