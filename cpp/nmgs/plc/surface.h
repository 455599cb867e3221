// SPDX-License-Identifier: LGPL-2.1-or-later
// Facets joined at their edges: which surfaces close, how they are oriented, what they enclose.
#pragma once

#include "nmgs/plc/problem.h"
#include "nmgs/plc/welded.h"
#include "nmgs/support/box_tree.h"

namespace nmgs {

// Facets that hang together by edges of exactly two sides form a surface.
struct Surfaces {
    std::vector<std::int32_t> of_facet; // number of the surface
    std::vector<bool> flipped;          // a facet oriented against most of its surface
    std::vector<bool> closed;           // of a surface: no edge with one side only
    std::vector<bool> oriented;         // of a surface: it can be oriented at all
    std::vector<double> volume;         // of a surface, with the flipped facets turned
    [[nodiscard]] std::size_t size() const { return closed.size(); }
};

Surfaces surfaces_of(const Welded &welded);

// Facets that a straight way from the point to the outside goes through, without those of one
// surface (-1: all count). The fewest of several ways.
int facets_to_outside(const Welded &welded, const BoxTree &tree, Vec3 point,
                      const Surfaces &surfaces, std::int32_t without = -1);

// Open edges, flipped facets, surfaces inside out, holes and regions outside.
std::vector<PlcProblem> surface_problems(const Welded &welded, const BoxTree &tree,
                                         std::size_t limit);

// Surfaces whose normals point into them, by number: those that no other surface encloses must
// have a positive volume, those in one other a negative one, and so on.
std::vector<bool> inside_out(const Welded &welded, const BoxTree &tree, const Surfaces &surfaces);

} // namespace nmgs
