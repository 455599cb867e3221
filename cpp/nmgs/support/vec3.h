// SPDX-License-Identifier: LGPL-2.1-or-later
// Vec3 is in support/, where all rooms may use it; this is its old place.
#pragma once

#include "nmgs/support/vec3.h" // IWYU pragma: export
