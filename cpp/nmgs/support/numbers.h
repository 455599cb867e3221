// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers to and from text, independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace nmgs {

// The whole word as a number, or nothing. A leading plus and Fortran's D exponents are accepted;
// a number beyond double's range is none. "nan" and "inf" are numbers here; most callers refuse
// them with is_finite.
std::optional<double> parse_double(std::string_view word);
// Decimal; nothing when it is not whole or does not fit.
std::optional<std::int64_t> parse_integer(std::string_view word);

// The most characters that print() writes.
constexpr int max_number_length = 32;
// The shortest text that reads back to the same double or integer; returns the end. No terminator.
char *print(char *out, double value);
char *print(char *out, std::int64_t value);

} // namespace nmgs
