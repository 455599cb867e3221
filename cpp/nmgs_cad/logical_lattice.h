// SPDX-License-Identifier: LGPL-2.1-or-later
// The lattice of cells that a solid made of cubes fills, by the directions of its faces and edges.
#pragma once

#include "nmgs_cad/logical_directions.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace nmgs::cad {

struct LogicalLattice {
    // Of each direction: places of the lattice planes in the model's unit, ascending. Distances
    // between them are the mean lengths of the edges that run from one to the other.
    std::array<std::vector<double>, 3> planes;
    std::map<int, std::array<int, 3>> vertex; // numbers of the planes through each CAD vertex
    std::vector<std::int8_t> filled;          // of each cell, xi fastest
    // Face (place in the boundary, -1 none) between cells along each axis; cells(axis) + 1 of them
    // in that direction.
    std::array<std::vector<std::int32_t>, 3> face;

    [[nodiscard]] int cells(std::size_t axis) const {
        return static_cast<int>(planes[axis].size()) - 1;
    }
    [[nodiscard]] std::size_t cell(std::array<int, 3> at) const {
        const int n = at[0] + cells(0) * (at[1] + cells(1) * at[2]);
        return static_cast<std::size_t>(n);
    }
    [[nodiscard]] bool inside(std::array<int, 3> at) const {
        for (std::size_t d = 0; d < 3; ++d) {
            if (at[d] < 0 || at[d] >= cells(d)) {
                return false;
            }
        }
        return filled[cell(at)] != 0;
    }
    // The face at the low end, along axis, of the cell.
    [[nodiscard]] std::size_t wall(std::size_t axis, std::array<int, 3> at) const {
        const int nx = cells(0) + (axis == 0 ? 1 : 0);
        const int ny = cells(1) + (axis == 1 ? 1 : 0);
        const int n = at[0] + nx * (at[1] + ny * at[2]);
        return static_cast<std::size_t>(n);
    }
};

// merge: how near two planes that nothing tells apart may come, as a part of the shortest edge that
// ends there, to become one; 0: only planes at one place. Nothing, and the refusal, when the faces
// do not enclose cells.
std::optional<LogicalLattice> logical_lattice(const CadShape &shape, const SolidBoundary &boundary,
                                              const LogicalDirections &directions, double merge,
                                              Refusal &refusal);

} // namespace nmgs::cad
