// SPDX-License-Identifier: LGPL-2.1-or-later
// Quads over the faces of a section.
#pragma once

#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// Lays all faces of the shape out, in one conforming layout. False and why: one cannot be.
bool layout_section(const CadShape &section, Layout &flat, const LayoutOptions &options,
                    Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
