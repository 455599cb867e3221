// SPDX-License-Identifier: LGPL-2.1-or-later
// BlockModel: curved elements to be divided. 8-node patches (thesis 2.1.1.1, NMGS-SSMG) or 20-node
// blocks (thesis 2.3.1, NMGS-SVMG), with a number of divisions and a spacing a direction.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace nmgs {

struct BlockModel {
    int dimension = 3; // 2: patches of 8 nodes; 3: blocks of 20 nodes
    // Nodes of element e from e * nodes_per_element() on, ordered as in element/quad8.h, hexa20.h.
    std::vector<Vec3> nodes;
    // Divisions along xi, eta, zeta, each >= 1; of a patch the third is 0.
    std::vector<std::array<std::int32_t, 3>> divisions;
    // Positions in [0, 1] of the lattice planes of element e along direction d, at e * dimension +
    // d: divisions + 1 ascending values from 0 to 1, or none where the spacing is uniform. May be
    // shorter than the number of elements asks for: the rest is uniform.
    std::vector<std::vector<double>> spacing;
    // Points that the corners of element e are, from e * corners_per_element() on: corners are one
    // where their numbers are equal, and only there. Empty: where they are at one place.
    std::vector<std::int32_t> corners;

    [[nodiscard]] std::size_t size() const { return divisions.size(); }
    [[nodiscard]] int nodes_per_element() const { return dimension == 2 ? 8 : 20; }
    [[nodiscard]] int corners_per_element() const { return dimension == 2 ? 4 : 8; }
    [[nodiscard]] std::span<const Vec3> element(std::size_t e) const {
        const auto n = static_cast<std::size_t>(nodes_per_element());
        return {nodes.data() + e * n, n};
    }
};

// Raises ArgumentError that names the element (1-based) and the value when the arrays' lengths
// disagree, a corner's number is negative, a division is not positive, a coordinate is not finite,
// or a spacing does not ascend from 0 to 1.
void validate(const BlockModel &model);

// Natural coordinates in [-1, 1] of the lattice planes of an element along a direction.
std::vector<double> natural_positions(const BlockModel &model, std::size_t element, int direction);

// Number of cells and, before nodes are shared, of nodes; 2^63 - 1 where they do not fit.
std::int64_t cell_count(const BlockModel &model);
std::int64_t lattice_count(const BlockModel &model);

} // namespace nmgs
