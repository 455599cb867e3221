// SPDX-License-Identifier: AGPL-3.0-or-later
#include "nmgs_tet/frame.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <limits>

namespace nmgs::tet {
namespace {

constexpr std::size_t largest_transfer = std::size_t{1} << 30;

void write_exactly(int descriptor, const void *data, std::size_t size) {
    const auto *bytes = static_cast<const char *>(data);
    while (size > 0) {
        const ssize_t count = ::write(descriptor, bytes, std::min(size, largest_transfer));
        if (count > 0) {
            bytes += count;
            size -= static_cast<std::size_t>(count);
        } else if (errno != EINTR) {
            std::_Exit(EXIT_FAILURE);
        }
    }
}

} // namespace

void read_exactly(int descriptor, void *data, std::size_t size) {
    auto *bytes = static_cast<char *>(data);
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count =
            ::read(descriptor, bytes + done, std::min(size - done, largest_transfer));
        if (count > 0) {
            done += static_cast<std::size_t>(count);
        } else if (count == 0 && done == 0) {
            throw EndOfInput("the request ended before 'go'");
        } else if (count == 0) {
            throw ProtocolError("the request broke off inside a frame");
        } else if (errno != EINTR) {
            throw ProtocolError("the request cannot be read");
        }
    }
}

FrameHeader read_header(int descriptor) {
    FrameHeader header{};
    read_exactly(descriptor, &header, sizeof header);
    if (header.magic != frame_magic) {
        throw ProtocolError("not a frame of nmgs-tet");
    }
    if (header.scalar > static_cast<std::uint32_t>(Scalar::float64)) {
        throw ProtocolError("frame " + std::to_string(header.kind) + ": no such scalar " +
                            std::to_string(header.scalar));
    }
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max() / 8;
    if (header.columns != 0 && header.rows > most / header.columns) {
        throw ProtocolError("frame " + std::to_string(header.kind) + ": too long");
    }
    return header;
}

void write_frame(int descriptor, std::uint32_t kind, Scalar scalar, const void *data,
                 std::uint64_t rows, std::uint64_t columns, std::int32_t code) {
    const FrameHeader header{frame_magic, kind, static_cast<std::uint32_t>(scalar),
                             code,        rows, columns};
    write_exactly(descriptor, &header, sizeof header);
    write_exactly(descriptor, data, rows * columns * scalar_size(scalar));
}

void write_text(int descriptor, Kind kind, std::string_view text, std::int32_t code) {
    write_frame(descriptor, static_cast<std::uint32_t>(kind), Scalar::bytes, text.data(),
                text.size(), 1, code);
}

} // namespace nmgs::tet
