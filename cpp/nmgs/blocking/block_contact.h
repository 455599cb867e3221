// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of blocks, or edges of patches, that touch without being shared: one that covers two
// others, for example. Their meshes fit where the lattice cells on both sides are the same.
#pragma once

#include "nmgs/blocking/topology.h"

#include <vector>

namespace nmgs {

// Pairs of near blocks or parts that the checks look at; sound models have far fewer.
constexpr std::size_t most_near_boxes(std::size_t count) {
    return 10000 + 200 * count;
}

struct Contact {
    std::size_t block_a, block_b;
    int part_a, part_b;
    double distance; // of the two, at the place
    Vec3 place;      // middle of the first cell that does not fit
    bool overlap;    // patches that lie on each other
};

// The contacts whose cells do not fit, at most one a pair of parts. Edges that lie in the face of
// another block, or in another patch, as a rib on a skin, are among them, once a pair of blocks:
// part_b of such a patch is its inside, and no divisions fit there. Parts that share a corner touch
// when they come within the topology's tolerance, others when within `gap`.
std::vector<Contact> find_bad_contacts(const BlockModel &model, const Topology &topology,
                                       double gap);

} // namespace nmgs
