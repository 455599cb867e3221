// SPDX-License-Identifier: LGPL-2.1-or-later
// The same blocks over a shape whose dimensions have changed.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

namespace nmgs::cad {

// Moves the blocks that lie on `before` onto `after`, whose entities must be joined as those of
// `before` are, number by number. Nodes on vertices and edges go to the same vertex, and the same
// fraction of the edge; what these moved by spreads over the faces, whose nodes are put onto them,
// and from there into the solids (a discrete harmonic function, each edge weighted by the inverse
// of its length). Divisions, spacing and report are kept, the report's errors measured anew.
// Raises GeometryError that names the first entities that differ, Cancelled.
CadBlocks refit(const CadShape &before, const CadShape &after, const CadBlocks &blocks,
                const Progress &progress = {});

} // namespace nmgs::cad
