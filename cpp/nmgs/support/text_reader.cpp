// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/text_reader.h"

#include "nmgs/support/error.h"
#include "nmgs/support/numbers.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace nmgs {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;
constexpr std::ptrdiff_t longest_word = 4096;
constexpr std::size_t longest_line = std::size_t{1} << 20;

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

// Printable, and not longer than an error message should be.
std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 40)) {
        text += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? '?' : c;
    }
    return "'" + to_utf8(text) + (word.size() > 40 ? "...'" : "'");
}

} // namespace

std::string to_utf8(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    bool valid = true;
    for (std::size_t i = 0; i < text.size() && valid;) {
        const unsigned b = byte(i);
        const std::size_t more = b < 0x80 ? 0 : b < 0xC2 ? 9 : b < 0xE0 ? 1 : b < 0xF0 ? 2 : 3;
        valid = b < 0xF5 && more < 9 && i + more < text.size();
        for (std::size_t k = 1; valid && k <= more; ++k) {
            valid = (byte(i + k) & 0xC0U) == 0x80;
        }
        if (valid && more >= 2) {
            // Overlong forms, surrogates, and beyond U+10FFFF.
            const unsigned c = byte(i + 1);
            valid = !((b == 0xE0 && c < 0xA0) || (b == 0xED && c > 0x9F) ||
                      (b == 0xF0 && c < 0x90) || (b == 0xF4 && c > 0x8F));
        }
        i += more + 1;
    }
    if (valid) {
        return std::string(text);
    }
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned b = byte(i);
        if (b < 0x80) {
            result += static_cast<char>(b);
        } else {
            result += static_cast<char>(0xC0U | b >> 6U);
            result += static_cast<char>(0x80U | (b & 0x3FU));
        }
    }
    return result;
}

TextReader::TextReader(const std::string &path, Comments comments)
    : path_(path), comments_(comments), buffer_(buffer_size) {
    namespace fs = std::filesystem;
    const fs::path place(path);
    if (fs::is_directory(place)) {
        throw fs::filesystem_error("cannot read", place,
                                   std::make_error_code(std::errc::is_a_directory));
    }
    size_ = static_cast<std::int64_t>(fs::file_size(place));
    file_.open(place, std::ios::binary);
    if (!file_) {
        throw fs::filesystem_error("cannot read", place,
                                   std::error_code(errno, std::generic_category()));
    }
    at_ = end_ = buffer_.data();
    fill();
    if (end_ - at_ >= 3 && std::memcmp(at_, "\xEF\xBB\xBF", 3) == 0) {
        at_ += 3;
    }
}

bool TextReader::fill() {
    if (end_of_file_) {
        return false;
    }
    const auto kept = static_cast<std::size_t>(end_ - at_);
    std::memmove(buffer_.data(), at_, kept);
    file_.read(buffer_.data() + kept, static_cast<std::streamsize>(buffer_.size() - kept));
    const auto got = file_.gcount();
    if (file_.bad()) {
        throw std::filesystem::filesystem_error("cannot read", path_,
                                                std::make_error_code(std::errc::io_error));
    }
    end_of_file_ = got == 0;
    read_ += got;
    at_ = buffer_.data();
    end_ = at_ + kept + got;
    return got > 0;
}

double TextReader::fraction() const {
    return size_ > 0 ? std::min(1.0, static_cast<double>(read_) / static_cast<double>(size_)) : 1.0;
}

void TextReader::skip_space() {
    for (;;) {
        while (at_ < end_ && *at_ != '\n' && is_space(*at_)) {
            ++at_;
        }
        if (at_ < end_ || !fill()) {
            return;
        }
    }
}

void TextReader::skip_line() {
    for (;;) {
        const auto left = static_cast<std::size_t>(end_ - at_);
        const char *found =
            left > 0 ? static_cast<const char *>(std::memchr(at_, '\n', left)) : nullptr;
        if (found != nullptr) {
            at_ = found + 1;
            ++line_;
            line_start_ = true;
            return;
        }
        at_ = end_;
        if (!fill()) {
            return;
        }
    }
}

// An explanation in parentheses may run over several lines (Table C.3 has such).
void TextReader::skip_parenthesis() {
    const std::int64_t begin = line_;
    std::string text;
    int depth = 0;
    do {
        if (at_ == end_ && !fill()) {
            throw FormatError(path_, begin,
                              "expected ')' to end the explanation, found the end "
                              "of the file");
        }
        const char c = *at_++;
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        line_ += c == '\n' ? 1 : 0;
        if (listener_) {
            text += c;
        }
    } while (depth > 0);
    if (listener_) {
        listener_(std::string_view(text).substr(1, text.size() - 2), begin);
    }
}

bool TextReader::skip_comment() {
    if (comments_ == Comments::hash && *at_ == '#') {
        const bool keep = line_start_;
        // Up to the line end, which stays: it ends the line at hand.
        for (;;) {
            const auto left = static_cast<std::size_t>(end_ - at_);
            const char *found =
                left > 0 ? static_cast<const char *>(std::memchr(at_, '\n', left)) : nullptr;
            at_ = found != nullptr ? found : end_;
            if (found != nullptr || !fill()) {
                break;
            }
        }
        line_start_ = keep;
        return true;
    }
    if (comments_ == Comments::explanations && line_start_) {
        if (end_ - at_ < 3) {
            fill();
        }
        if (end_ - at_ >= 3 && std::memcmp(at_, "---", 3) == 0) {
            skip_line();
            ++explanations_;
            return true;
        }
        if (*at_ == '(') {
            skip_parenthesis();
            ++explanations_;
            return true;
        }
    }
    return false;
}

std::string_view TextReader::take() {
    if (end_ - at_ <= longest_word) {
        fill();
    }
    const char *first = at_;
    const char *limit = end_ - first > longest_word ? first + longest_word : end_;
    while (at_ < limit && !is_space(*at_) && !(*at_ == '#' && comments_ == Comments::hash)) {
        ++at_;
    }
    line_start_ = false;
    word_line_ = line_;
    if (at_ - first == longest_word) {
        throw FormatError(path_, line_,
                          "expected a number or word, found one of more than " +
                              std::to_string(longest_word) + " bytes");
    }
    return {first, static_cast<std::size_t>(at_ - first)};
}

bool TextReader::skip_to_text() {
    for (;;) {
        while (at_ < end_ && is_space(*at_)) {
            if (*at_ == '\n') {
                ++line_;
                line_start_ = true;
            }
            ++at_;
        }
        if (at_ == end_) {
            if (!fill()) {
                word_line_ = line_;
                return false;
            }
            continue;
        }
        if (!skip_comment()) {
            return true;
        }
    }
}

std::string_view TextReader::word() {
    return skip_to_text() ? take() : std::string_view();
}

bool TextReader::at_line_end() {
    for (;;) {
        skip_space();
        if (at_ == end_ || *at_ == '\n') {
            return true;
        }
        const std::int64_t before = line_;
        if (!skip_comment()) {
            return false;
        }
        if (line_ != before) {
            return true;
        }
    }
}

std::string_view TextReader::word_on_line() {
    if (at_line_end()) {
        word_line_ = line_;
        return {};
    }
    return take();
}

TextReader::Line TextReader::raw_line() {
    word_line_ = line_;
    std::string text;
    for (;;) {
        const auto left = static_cast<std::size_t>(end_ - at_);
        const char *found =
            left > 0 ? static_cast<const char *>(std::memchr(at_, '\n', left)) : nullptr;
        const char *stop = found != nullptr ? found : end_;
        text.append(at_, stop);
        if (text.size() > longest_line) {
            throw FormatError(path_, line_,
                              "expected a line of text, found one of more than " +
                                  std::to_string(longest_line) + " bytes");
        }
        at_ = stop;
        if (found != nullptr) {
            ++at_;
            ++line_;
            line_start_ = true;
            break;
        }
        if (!fill()) {
            if (text.empty()) {
                return {{}, false};
            }
            break;
        }
    }
    if (!text.empty() && text.back() == '\r') {
        text.pop_back();
    }
    return {to_utf8(text), true};
}

void TextReader::fail(const std::string &expected, std::string_view found) const {
    throw FormatError(path_, word_line_,
                      "expected " + expected + ", found " +
                          (found.empty() ? std::string("the end of the file") : shown(found)));
}

void TextReader::expect_end() {
    const auto found = word();
    if (!found.empty()) {
        fail("the end of the file", found);
    }
}

double TextReader::real(std::string_view word, const char *what) const {
    const auto value = parse_double(word);
    if (!value || !std::isfinite(*value)) {
        fail(std::string(what) + " (a finite number)", word);
    }
    return *value;
}

std::int64_t TextReader::integer(std::string_view word, const char *what, std::int64_t low,
                                 std::int64_t high) const {
    const auto value = parse_integer(word);
    if (!value || *value < low || *value > high) {
        std::string expected = std::string(what) + " (a whole number";
        if (low != std::numeric_limits<std::int64_t>::min()) {
            expected += " from " + std::to_string(low);
        }
        if (high != std::numeric_limits<std::int64_t>::max()) {
            expected += " to " + std::to_string(high);
        }
        fail(expected + ")", word);
    }
    return *value;
}

double TextReader::real(const char *what) {
    return real(word(), what);
}

std::int64_t TextReader::integer(const char *what, std::int64_t low, std::int64_t high) {
    return integer(word(), what, low, high);
}

void TextReader::require_numbers(std::int64_t numbers, const char *what) const {
    // A digit and a space each, but for the last one's space.
    const std::int64_t left = size_ - read_ + (end_ - at_);
    if (numbers > (left + 1) / 2) {
        throw FormatError(path_, word_line_,
                          "expected " + std::string(what) + ", " + std::to_string(numbers) +
                              " numbers or more, but only " + std::to_string(left) +
                              " bytes are left in the file");
    }
}

} // namespace nmgs
