// SPDX-License-Identifier: LGPL-2.1-or-later
// Quads of a layout over CAD faces.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/layout.h"
#include "nmgs_cad/layout_options.h"
#include "nmgs_cad/refusal.h"

#include <span>
#include <string>
#include <vector>

namespace nmgs::cad {

// Covers a face with quads unless it has some already. Edges that are laid out keep their segments;
// the others are divided here. Refuses, and leaves the layout as it was but for edges, when the
// face has no closed boundary, or what is on its edges makes an odd number of segments.
bool layout_face(const CadShape &shape, int face, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress = {});

// Divides an edge into equal segments, as many as somebody asked for, before its faces are laid
// out. Raises ArgumentError for an edge that the shape does not have or that has no length, and for
// a count that is too small: 1, for a closed edge 3.
void divide_evenly(const CadShape &shape, int edge, int count, Layout &layout);

// Covers several faces: numbers of segments are chosen for all of them first, so that as many faces
// as possible are one grid. An entry a face is added to the report: the strategy ("mapped",
// "general", ...), the first of its quads in the layout and how many there are. method: only this
// strategy, "auto" for the best.
void layout_faces(const CadShape &shape, std::span<const int> faces, Layout &layout,
                  const LayoutOptions &options, std::vector<FitEntry> &report,
                  const Progress &progress = {}, const std::string &method = "auto");

} // namespace nmgs::cad
