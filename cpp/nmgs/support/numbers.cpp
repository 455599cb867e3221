// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

namespace nmgs {
namespace {

// from_chars takes no plus; "+-1" stays wrong.
std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') {
        word.remove_prefix(1);
    }
    return word;
}

std::optional<double> parse_plain(std::string_view word) {
    double value = 0;
    const char *end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end) {
        return std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        // Below the smallest double is zero; beyond the largest is no number.
        const auto e = word.find_first_of("eE");
        const auto digit = word.find_first_not_of('-');
        const bool tiny =
            e != std::string_view::npos
                ? word.substr(e + 1, 1) == "-"
                : digit != std::string_view::npos && (word[digit] == '0' || word[digit] == '.');
        return tiny ? std::optional<double>(word[0] == '-' ? -0.0 : 0.0) : std::nullopt;
    }
    return error == std::errc() ? std::optional<double>(value) : std::nullopt;
}

} // namespace

std::optional<double> parse_double(std::string_view word) {
    word = without_plus(word);
    if (word.empty()) {
        return std::nullopt;
    }
    const auto value = parse_plain(word);
    if (value) {
        return value;
    }
    const auto d = word.find_first_of("dD");
    std::array<char, 512> copy{};
    if (d == std::string_view::npos || d == 0 || word.size() > copy.size()) {
        return std::nullopt;
    }
    std::copy(word.begin(), word.end(), copy.begin());
    copy[d] = 'e';
    // from_chars takes "1e+5" as it takes "1e5", so Fortran's "1.0D+05" needs no more.
    return parse_plain({copy.data(), word.size()});
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
    word = without_plus(word);
    std::int64_t value = 0;
    const char *end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return stop == end && error == std::errc() ? std::optional<std::int64_t>(value) : std::nullopt;
}

char *print(char *out, double value) {
    return std::to_chars(out, out + max_number_length, value).ptr;
}

char *print(char *out, std::int64_t value) {
    return std::to_chars(out, out + max_number_length, value).ptr;
}

} // namespace nmgs
