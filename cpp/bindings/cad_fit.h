// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "nmgs_cad/cad_blocks.h"

#include <pybind11/pybind11.h>

namespace nmgs::bindings {

// {nodes, offsets, entities, report} of fitted blocks.
pybind11::dict fit_dict(cad::CadBlocks &&blocks);

} // namespace nmgs::bindings
