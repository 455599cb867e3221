// SPDX-License-Identifier: LGPL-2.1-or-later
// Mid-side nodes on the mapping of the blocks that a mesh came from, not on straight edges.
#pragma once

#include "nmgs/blocking/block_model.h"
#include "nmgs/convert/raise_order.h"

#include <cstdint>
#include <optional>
#include <span>

namespace nmgs {

// A rule for raise_order for a mesh that was generated from the model, or that and split: blocks of
// quads or hexahedra with as many cells as the model has, block by block, xi fastest; triangles of
// these quads, two each, or tetrahedra of these hexahedra, twelve each, as split_quads and
// split_hexahedra list them. Edges of other blocks of cells get straight middles.
//
// A mid-side node lies at the image of the mean of its ends' natural coordinates (of the element
// that first names the edge), moved by the mean of what the ends themselves were moved off their
// images: nothing for a mesh as generated, the snap where nodes were put onto CAD. Where an end is
// off by more than half the edge, the mesh is not the model's any more and the middle is straight.
//
// None when no block of cells fits the model. Keeps references to model, points and cells.
std::optional<PlaceOnEdge> mid_sides_on_model(const BlockModel &model, std::span<const Vec3> points,
                                              std::span<const CellView> cells);

} // namespace nmgs
