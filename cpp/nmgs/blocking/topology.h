// SPDX-License-Identifier: LGPL-2.1-or-later
// Which corners, edges and faces of which blocks are the same one (thesis 4.4.1 ii, 4.5.1 ii:
// common nodes). Found from the blocks' own nodes in time linear in the number of blocks.
#pragma once

#include "nmgs/blocking/block_model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nmgs {

// A part of a block: its corners, edges, faces and inside are the cells of a 3 x 3 x 3 lattice.
// Along each direction 0 is the low end, 1 the inside, 2 the high end; the code is a + 3 b + 9 c.
// A patch uses c = 0 only.
namespace part {
constexpr int count = 27;
constexpr std::array<int, 3> digits(int code) {
    return {code % 3, code / 3 % 3, code / 9};
}
constexpr int code(int a, int b, int c) {
    return a + 3 * b + 9 * c;
}
// 0 corner, 1 edge, 2 face, 3 inside.
constexpr int dimension(int code) {
    const auto d = digits(code);
    return (d[0] == 1 ? 1 : 0) + (d[1] == 1 ? 1 : 0) + (d[2] == 1 ? 1 : 0);
}
// The running directions of an edge or face, in ascending order.
struct Axes {
    int count = 0;
    std::array<int, 3> axis{};
};
constexpr Axes axes(int code) {
    Axes result;
    const auto d = digits(code);
    for (int i = 0; i < 3; ++i) {
        if (d[static_cast<std::size_t>(i)] == 1) {
            result.axis[static_cast<std::size_t>(result.count++)] = i;
        }
    }
    return result;
}
// The corner or edge that an element's node n is on, or in the middle of; dimension 2 or 3.
int of_node(int dimension, std::size_t n);
// "corner 3", "edge 1-5", "face 1-2-3-4" in the thesis's node numbers.
std::string name(int code, int dimension);
} // namespace part

// The first use of a part. Lattice indices of this use lead to the owner's: for an edge `flip` bit
// 0 reverses it; for a face bit 0 reverses the owner's first running direction, bit 1 its second,
// and bit 2 swaps the two before that.
struct Owner {
    std::int32_t block = -1;
    std::int8_t part = 0;
    std::int8_t flip = 0;
};

// Two blocks that meet where they should not, or do not where they should.
struct Conflict {
    std::int32_t block_a, part_a, block_b, part_b; // 0-based
    Vec3 place;
    std::string reason;
};

struct Topology {
    double tolerance = 0;
    // Of each part of each block (block * part::count + code); the owner of an owned part is
    // itself.
    std::vector<Owner> owner;
    // Number of blocks' parts that lead to the owner, itself included.
    std::vector<std::int32_t> uses;
    // Divisions or spacings that disagree over a shared edge or face.
    std::vector<Conflict> conflicts;
    // Of each edge part: the number of the edge that it is, from 0, whatever its divisions, and
    // whether it runs against the first block's. -1 for other parts.
    std::vector<std::int32_t> edge;
    std::vector<char> edge_reversed;

    [[nodiscard]] const Owner &of(std::size_t block, int code) const {
        return owner[block * part::count + static_cast<std::size_t>(code)];
    }
    [[nodiscard]] bool owns(std::size_t block, int code) const {
        const Owner &o = of(block, code);
        return o.block == static_cast<std::int32_t>(block) && o.part == code;
    }
};

// Least length of a block's edge (its two chords) over its divisions, as if spaced uniformly.
double smallest_element_edge(const BlockModel &model);
// 1e-4 of it.
double default_tolerance(const BlockModel &model);

// Corners are one where the model gives them one number; without numbers, nodes of blocks closer
// than the tolerance are the same; negative asks for the default.
// The model must be valid (see validate).
Topology find_topology(const BlockModel &model, double tolerance = -1);

} // namespace nmgs
