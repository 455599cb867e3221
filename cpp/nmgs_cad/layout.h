// SPDX-License-Identifier: LGPL-2.1-or-later
// A coarse conforming mesh over CAD: what the strategies write, and what becomes curved blocks.
#pragma once

#include "nmgs/support/vec3.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace nmgs::cad {

// Quads over faces and hexahedra in solids that share their points. Points are numbered from 0,
// entities from 1 as in CadShape. What one strategy has laid over an edge or a face is binding for
// the next one that meets it: edges and faces that are laid out already are kept as they are, which
// is how solids and faces come to share nodes.
struct Layout {
    struct Quad {
        std::array<std::int32_t, 4> points; // counter-clockwise about shape.face(face)'s normal
        std::int32_t face;
    };
    struct Hexa {
        std::array<std::int32_t, 8> points; // the thesis's corners 1 to 8, positive volume
        std::int32_t solid;
    };

    std::vector<Vec3> points;
    std::vector<CadEntity> on; // of each point: the entity of least dimension that it lies on
    // Of CAD edge n at n: its points from the start of its curve (as EdgeCurve runs) to the end,
    // both vertices included; a closed edge has its vertex at both ends. Empty: not laid out yet.
    // No loop of the layout has fewer than three points, so that two points name one curve.
    std::vector<std::vector<std::int32_t>> edges;
    std::vector<Quad> quads;
    std::vector<Hexa> hexas;
    // Middles of curves between two points, ascending, that are neither straight nor on a CAD edge.
    // Those on a face and not listed here are put half-way, onto the face.
    std::map<std::array<std::int32_t, 2>, Vec3> middles;

    explicit Layout(const CadShape &shape)
        : edges(static_cast<std::size_t>(shape.edges.Extent()) + 1) {}

    std::int32_t add_point(Vec3 p, CadEntity entity);
    // The point at the CAD's vertex n, made at its first use.
    std::int32_t vertex(const CadShape &shape, int n);
    // Divides CAD edge n at fractions of its length, ascending, ends excluded, unless it is laid
    // out already; its points. A closed edge needs two or more.
    const std::vector<std::int32_t> &divide_edge(const CadShape &shape, int n,
                                                 std::span<const double> fractions);
    // Numbers of the quads on CAD face n.
    [[nodiscard]] std::vector<std::int32_t> quads_of(int face) const;

private:
    std::map<int, std::int32_t> vertices_;
};

// 20-node blocks of the hexahedra (dimension 3) or 8-node patches of the quads (2), mid-side nodes
// on the CAD. Blocks come in the order of the cells. The report is left empty.
CadBlocks blocks_of(const CadShape &shape, const Layout &layout, int dimension);

} // namespace nmgs::cad
