// SPDX-License-Identifier: LGPL-2.1-or-later
// Words and lines of a text file, with errors that name file, line, what was expected and what was
// found. The file passes through a buffer of fixed size, so reading needs no memory for the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nmgs {

// What a reader leaves out. Line ends may be LF or CRLF in all of them.
enum class Comments {
    none,
    hash,        // from '#' to the end of the line (TetGen)
    explanations // lines that begin with "---"; a parenthesis that begins a line, to its end (NMGS)
};

class TextReader {
public:
    // Raises std::filesystem::filesystem_error when the file cannot be opened.
    explicit TextReader(const std::string &path, Comments comments = Comments::none);

    // The next word, on this line or a later one; empty at the end of the file. Valid until the
    // next call. A word of more than 4096 bytes is a FormatError.
    std::string_view word();
    // As word(), but only on the line at hand: empty at the end of the line.
    std::string_view word_on_line();
    // True when only white space and comments are left on the line.
    bool at_line_end();
    // To the next word, on this line or a later one, without taking it; false at the end of file.
    bool skip_to_text();
    // Leaves the rest of the line out.
    void skip_line();
    // The rest of the line as it is, comments included, without its line end; then the next line
    // begins. Latin-1 text is turned into UTF-8. `more` is false at the end of the file.
    struct Line {
        std::string text;
        bool more;
    };
    Line raw_line();
    // Only white space and comments may follow. Raises FormatError.
    void expect_end();

    // The next word as a number. `what` says in words what is expected, for example "the number of
    // elements". Raise FormatError for anything else, at the end of the file, and for a number out
    // of [low, high]; real() also for NaN and infinity.
    double real(const char *what);
    std::int64_t integer(const char *what,
                         std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                         std::int64_t high = std::numeric_limits<std::int64_t>::max());
    // A word already taken, as a number.
    double real(std::string_view word, const char *what) const;
    std::int64_t integer(std::string_view word, const char *what,
                         std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                         std::int64_t high = std::numeric_limits<std::int64_t>::max()) const;

    // Raises FormatError at once when fewer than `numbers` numbers can be left in the file: a count
    // is checked with this before memory is allocated for it.
    void require_numbers(std::int64_t numbers, const char *what) const;

    // Raises FormatError: "expected `expected`, found 'found'", at the line of the last word.
    [[noreturn]] void fail(const std::string &expected, std::string_view found) const;

    [[nodiscard]] const std::string &path() const { return path_; }
    // 1-based line of the last word or line.
    [[nodiscard]] std::int64_t line() const { return word_line_; }
    // Lines and parentheses of explanation that were left out so far.
    [[nodiscard]] std::int64_t explanations() const { return explanations_; }
    // Fraction of the file that was read, for progress.
    [[nodiscard]] double fraction() const;
    // Called with the text and the line of each parenthesis left out from now on.
    using Listener = std::function<void(std::string_view text, std::int64_t line)>;
    void on_parenthesis(Listener listener) { listener_ = std::move(listener); }

private:
    bool fill();         // more bytes behind [at_, end_); false at the end of the file
    void skip_space();   // within the line
    bool skip_comment(); // true when there was one
    void skip_parenthesis();
    std::string_view take(); // the word at at_

    std::string path_;
    std::ifstream file_;
    Comments comments_;
    std::vector<char> buffer_;
    const char *at_ = nullptr;
    const char *end_ = nullptr;
    bool end_of_file_ = false;
    bool line_start_ = true;
    std::int64_t line_ = 1;
    std::int64_t word_line_ = 1;
    std::int64_t explanations_ = 0;
    std::int64_t read_ = 0;
    std::int64_t size_ = 0;
    Listener listener_;
};

// Valid UTF-8 as it is; anything else is taken for Latin-1.
std::string to_utf8(std::string_view text);

} // namespace nmgs
