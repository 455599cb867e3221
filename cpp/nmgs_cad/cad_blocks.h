// SPDX-License-Identifier: LGPL-2.1-or-later
// A model of blocks together with the CAD that it lies on.
#pragma once

#include "nmgs/blocking/topology.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace nmgs::cad {

// dimension 0 vertex, 1 edge, 2 face, 3 solid; index 1-based as in CadShape.
struct CadEntity {
    std::int32_t dimension, index;
};

// For part p of block b (see nmgs::part), entities offsets[b * part::count + p] up to the next
// offset: what the part lies on, nothing for a part inside a solid. The inside of a block lies on
// its solid, that of a patch on its face.
struct CadBinding {
    std::vector<std::int32_t> offsets{0};
    std::vector<CadEntity> entities;

    [[nodiscard]] std::span<const CadEntity> of(std::size_t block, int code) const {
        const std::size_t at = block * part::count + static_cast<std::size_t>(code);
        if (at + 1 >= offsets.size()) {
            return {};
        }
        return std::span(entities).subspan(static_cast<std::size_t>(offsets[at]),
                                           static_cast<std::size_t>(offsets[at + 1] - offsets[at]));
    }
};

// What became of one face or solid.
struct FitEntry {
    CadEntity entity;
    std::string method;                // empty: no method applies
    std::string reason;                // why none does
    std::vector<std::string> blockers; // the parts that stand in the way
    std::int32_t first_block = 0, blocks = 0;
    double error = 0; // largest distance found between the blocks' faces and the CAD's
    std::array<double, 3> place{0, 0, 0}; // where
    // Of a face: least sine of an angle of the layout, what scaled Jacobians tend to. Of a solid:
    // the worst scaled Jacobian of a mesh made from the layout; 0 where that was not measured.
    double quality = 0;
};

struct CadBlocks {
    BlockModel model;
    CadBinding binding;
    std::vector<FitEntry> report;
};

} // namespace nmgs::cad
