// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <exception>
#include <optional>
#include <string>

namespace nmgs::cad {

// What a failure of OpenCASCADE says; nothing for other exceptions. Its failures are no
// std::exception.
std::optional<std::string> occt_failure(const std::exception_ptr &thrown);

} // namespace nmgs::cad
