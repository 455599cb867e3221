// SPDX-License-Identifier: LGPL-2.1-or-later
// A file that appears whole or not at all: it is written under a temporary name in the same folder
// and renamed by commit().
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs/support/text_buffer.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace nmgs {

class AtomicFile {
public:
    // Creates the temporary file. A link is followed: the file that it points to is replaced.
    // Raises std::filesystem::filesystem_error, as the others do.
    explicit AtomicFile(const std::string &path);
    // Without a commit(), removes the temporary file and leaves the old one as it was.
    ~AtomicFile();
    AtomicFile(const AtomicFile &) = delete;
    AtomicFile &operator=(const AtomicFile &) = delete;

    void write(std::string_view text);
    // To the disk, and under the final name.
    void commit();

private:
    [[noreturn]] void fail(int code) const;

    struct Close {
        // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): called by the unique_ptr that owns it
        // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): this is the owner's end.
        void operator()(std::FILE *file) const { std::fclose(file); }
    };
    std::filesystem::path path_;
    std::filesystem::path temporary_;
    std::unique_ptr<std::FILE, Close> file_;
};

// Writes the text of items [0, count) in order; the chunks are formatted by all threads, a few
// megabytes at a time. `format` appends items [first, last) to the buffer. Polls progress between
// batches, mapping the work to [from, to] of the whole.
void write_items(
    AtomicFile &file, std::int64_t count, std::int64_t grain,
    const std::function<void(std::int64_t first, std::int64_t last, TextBuffer &)> &format,
    const Progress &progress = {}, double from = 0.0, double to = 1.0);

} // namespace nmgs
