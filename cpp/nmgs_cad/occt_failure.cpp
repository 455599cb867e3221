// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/occt_failure.h"

#include <Standard_Failure.hxx>

namespace nmgs::cad {

std::optional<std::string> occt_failure(const std::exception_ptr &thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const Standard_Failure &failure) {
        return std::string(failure.DynamicType()->Name()) + " " + failure.GetMessageString();
    } catch (...) {
        return std::nullopt;
    }
}

} // namespace nmgs::cad
