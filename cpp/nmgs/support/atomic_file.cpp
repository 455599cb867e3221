// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/atomic_file.h"

#include "nmgs/support/parallel.h"

#include <algorithm>
#include <cerrno>
#include <random>
#include <system_error>
#include <vector>

namespace nmgs {
namespace fs = std::filesystem;

AtomicFile::AtomicFile(const std::string &path) : path_(path) {
    if (fs::is_directory(path_)) {
        fail(EISDIR);
    }
    if (fs::is_symlink(path_)) {
        path_ = fs::weakly_canonical(path_);
    }
    std::random_device random;
    for (int attempt = 0; attempt < 100 && !file_; ++attempt) {
        temporary_ = path_;
        temporary_.replace_filename("." + path_.filename().string() + "." +
                                    std::to_string(random()) + ".tmp");
        errno = 0;
        // The unique_ptr owns it. NOLINTNEXTLINE(cppcoreguidelines-owning-memory)
        file_.reset(std::fopen(temporary_.string().c_str(), "wbx"));
        if (!file_ && errno != EEXIST) {
            fail(errno);
        }
    }
    if (!file_) {
        fail(EEXIST);
    }
    std::setvbuf(file_.get(), nullptr, _IOFBF, std::size_t{1} << 16);
    std::error_code ignored;
    const auto old = fs::status(path_, ignored);
    if (fs::exists(old)) {
        fs::permissions(temporary_, old.permissions(), ignored);
    }
}

AtomicFile::~AtomicFile() {
    if (!temporary_.empty()) {
        file_.reset();
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }
}

void AtomicFile::fail(int code) const {
    throw fs::filesystem_error("cannot write", path_,
                               std::error_code(code, std::generic_category()));
}

void AtomicFile::write(std::string_view text) {
    if (text.empty()) {
        return; // its data may be null, which fwrite must not get
    }
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) {
        fail(errno != 0 ? errno : EIO);
    }
}

void AtomicFile::commit() {
    errno = 0;
    if (std::fflush(file_.get()) != 0 || std::fclose(file_.release()) != 0) {
        fail(errno != 0 ? errno : EIO);
    }
    fs::rename(temporary_, path_);
    temporary_.clear();
}

void write_items(AtomicFile &file, std::int64_t count, std::int64_t grain,
                 const std::function<void(std::int64_t, std::int64_t, TextBuffer &)> &format,
                 const Progress &progress, double from, double to) {
    const auto batch = static_cast<std::size_t>(threads()) * 4;
    std::vector<TextBuffer> buffers(batch);
    for (std::int64_t start = 0; start < count;) {
        const std::int64_t left = (count - start + grain - 1) / grain;
        const auto chunks = std::min<std::size_t>(batch, static_cast<std::size_t>(left));
        parallel_for(chunks, 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t c = first; c < last; ++c) {
                const std::int64_t begin = start + static_cast<std::int64_t>(c) * grain;
                buffers[c].clear();
                format(begin, std::min(count, begin + grain), buffers[c]);
            }
        });
        for (std::size_t c = 0; c < chunks; ++c) {
            file.write(buffers[c].text());
        }
        start = std::min(count, start + static_cast<std::int64_t>(chunks) * grain);
        poll(progress,
             from + (to - from) * static_cast<double>(start) / static_cast<double>(count));
    }
}

} // namespace nmgs
