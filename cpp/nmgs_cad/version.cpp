// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/version.h"

#include <Standard_Version.hxx>

namespace nmgs::cad {

const char *occt_version() {
    return OCC_VERSION_COMPLETE;
}

} // namespace nmgs::cad
