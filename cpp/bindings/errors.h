// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace nmgs::bindings {

// Makes every error of support/error.h leave the module as the Python type of the same name in
// freecad.NMGSWorkbench.nmgs.errors, with its data as attributes. Call once in each module.
void register_errors();

} // namespace nmgs::bindings
