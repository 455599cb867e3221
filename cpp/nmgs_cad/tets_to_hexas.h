// SPDX-License-Identifier: LGPL-2.1-or-later
// Hexahedra of the tetrahedra that fill the skin of CAD solids (thesis, 2.4.1).
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/layout.h"
#include "nmgs_cad/skin.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs::cad {

// Tetrahedra of one solid, positive volume. Points below skin.points.size() are the skin's, the
// others are inner[n - skin.points.size()].
struct SolidTets {
    int solid;
    std::vector<Vec3> inner;
    std::vector<std::array<std::int32_t, 4>> tets;
};

struct TetHexas {
    double worst = 1;                       // scaled Jacobian at the corners of the hexahedra
    double inside = 1;                      // the same, at the middles of edges and faces too
    int off_cad = 0;                        // points that had to leave their CAD face
    std::vector<SkinOptions::Limit> folded; // where the skin must be finer, and how fine
};

// Adds four hexahedra a tetrahedron to the layout: points at the middles of edges, the middles of
// faces and of the tetrahedra, those of the skin on the CAD. The tetrahedra are improved before,
// between the same skin (nmgs/quality/tet_improvement.h); split: those are split before that would
// fold on curved faces, which thin walls need. Then points move to where the worst corner around
// them is better. Where hexahedra are still inside out the tetrahedron becomes straight but for the
// CAD's edges, and points leave the CAD's faces (on: the solid). The skin's edges must not be laid
// out in the layout. Raises Cancelled.
TetHexas tets_to_hexas(const CadShape &shape, const Skin &skin, std::span<const SolidTets> solids,
                       Layout &layout, const Progress &progress = {}, bool split = false);

} // namespace nmgs::cad
