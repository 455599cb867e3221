// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace nmgs::cad {

// Version of the OpenCASCADE that this was built with, e.g. "7.6.3".
const char *occt_version();

} // namespace nmgs::cad
