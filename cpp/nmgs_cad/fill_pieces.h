// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills what cuts have left of solids by the strategies that do not cut.
#pragma once

#include "nmgs_cad/layout_options.h"
#include "nmgs_cad/split.h"

#include <optional>
#include <span>

namespace nmgs::cad {

struct FillPiecesOptions {
    LayoutOptions layout;
    int attempts = 3;              // as LayoutOptions has it
    std::span<const int> doubtful; // pieces that may well not be filled: these first, each alone
    // Segments of an edge between pieces when the faces there are laid out before the pieces; 0:
    // whatever the first piece makes of them. One after the other until the quality is good.
    std::span<const double> segments;
};

// A layout of all pieces whose worst scaled Jacobian is above 0.2, or nothing and why; `culprit`:
// the piece that could not be filled last, 0 where that is no single one. Pieces that have what
// lies between two as a wall of their sweep go before those that have it as a cap.
std::optional<Layout> fill_pieces(const Pieces &pieces, const FillPiecesOptions &options,
                                  int &culprit, Refusal &refusal, const Progress &progress);

// Whether a piece can be filled if it stands alone, with a worst scaled Jacobian above `quality`.
bool fills_alone(const CadShape &cad, int piece, const LayoutOptions &options, int attempts,
                 double quality, Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
