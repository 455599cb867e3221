// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace nmgs::cad {

// Why a strategy does not apply, in words, and the entities that stand in the way ("Edge3").
struct Refusal {
    std::string reason;
    std::vector<std::string> blockers;
};

} // namespace nmgs::cad
