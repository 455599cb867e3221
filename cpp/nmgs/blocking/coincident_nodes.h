// SPDX-License-Identifier: LGPL-2.1-or-later
// Common nodes where blocks meet without sharing a whole face or edge (thesis 4.4.1 ii, 4.5.1 ii):
// a face that covers two others, for example. Lattice numbering joins what is shared by topology;
// this pass joins the rest by place. Only nodes on faces (of patches: edges) that no other block
// shares are looked at, and of these only such as lie near another block's, in linear time.
#pragma once

#include "nmgs/blocking/lattice.h"
#include "nmgs/mesh/mesh.h"

namespace nmgs {

// points: the nodes of the lattice. Gives, for each node, its number once coincident nodes are one,
// the lowest number counting; empty where nothing coincides. `remaining` is then the number of
// nodes left.
struct Coincidences {
    Array<std::int32_t> number;
    std::int64_t remaining = 0;
};
Coincidences find_coincident_nodes(const BlockModel &model, const Topology &topology,
                                   const Lattice &lattice, std::span<const Vec3> points);

// Drops the nodes that coincide with a lower one and renumbers the cells.
void apply(const Coincidences &coincidences, Mesh &mesh);

} // namespace nmgs
