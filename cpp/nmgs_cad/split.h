// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts solids by faces, or imprints them on each other, and keeps account of where each piece comes
// from.
#pragma once

#include "nmgs_cad/layout.h"
#include "nmgs_cad/refusal.h"

#include <TopTools_ListOfShape.hxx>

#include <optional>
#include <span>
#include <vector>

namespace nmgs::cad {

// Solids that share their faces, made from solids of another shape. Of each vertex, edge, face and
// solid of `cad`, from 1: the entity of least dimension of the other shape that it lies on.
struct Pieces {
    CadShape cad;
    std::vector<CadEntity> vertex_on, edge_on, face_on, solid_on;
    std::vector<double> volume; // of each solid of `cad`, from 1
};

// The solids cut by all the tools at once (general fuse, so that what touches shares its faces).
// Nothing and the refusal when OpenCASCADE fails, or when its pieces do not make up the solids.
std::optional<Pieces> split(const CadShape &shape, std::span<const int> solids,
                            const TopTools_ListOfShape &tools, Refusal &refusal);

// The pieces of solids of the shape, cut by more tools. What meets face to face already is not
// intersected once more.
std::optional<Pieces> split(const CadShape &shape, const Pieces &pieces,
                            const TopTools_ListOfShape &tools, Refusal &refusal);

// All solids of the shape imprinted on each other: those that touch share their faces from then on.
// What two of them have in common lies on that of the one that comes first.
std::optional<Pieces> imprint(const CadShape &shape, Refusal &refusal);

// Takes what is laid out on the pieces into the layout of the shape that they come from, which has
// nothing yet on the edges and faces of these solids; else false and the refusal.
bool join(const CadShape &shape, const Pieces &pieces, const Layout &of_pieces, Layout &layout,
          Refusal &refusal);

} // namespace nmgs::cad
