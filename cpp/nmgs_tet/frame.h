// SPDX-License-Identifier: AGPL-3.0-or-later
// The messages between the workbench and the worker: frames on pipes, in the machine's own byte
// order (both ends run on one machine). A frame is a header of 32 bytes and rows * columns scalars.
//
// Request (standard input):  hello, arrays in any order, go. Afterwards the input stays open: it is
// the worker's life line, and its end ends the worker.
// Answer (standard output):  hello, arrays, done; or hello, perhaps arrays, error.
// TetGen's own words go to standard error as they are printed, so that a crash loses none of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace nmgs::tet {

constexpr std::uint32_t frame_magic = 0x54474D4E; // "NMGT"
constexpr std::int64_t protocol_version = 1;

enum class Scalar : std::uint32_t { bytes = 0, int32 = 1, int64 = 2, float64 = 3 };

// Frames that are no arrays. Arrays are numbered from 100 on: see request.h and result.h.
enum class Kind : std::uint32_t { hello = 1, go = 2, error = 3, done = 4 };

struct FrameHeader {
    std::uint32_t magic;
    std::uint32_t kind;
    std::uint32_t scalar;
    std::int32_t code; // of an error; 0 otherwise
    std::uint64_t rows;
    std::uint64_t columns;
};
static_assert(sizeof(FrameHeader) == 32);

// The other end does not speak this protocol, or broke off inside a frame.
struct ProtocolError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The peer closed the pipe between two frames.
struct EndOfInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

constexpr std::size_t scalar_size(Scalar scalar) {
    return scalar == Scalar::bytes ? 1 : scalar == Scalar::int32 ? 4 : 8;
}

// Reads exactly size bytes. Raises EndOfInput when the pipe ends before the first one,
// ProtocolError when it ends later.
void read_exactly(int descriptor, void *data, std::size_t size);

// Reads and checks a header. Raises ProtocolError, EndOfInput.
FrameHeader read_header(int descriptor);

// Writes a frame whole. Ends the process when the reader is gone: nobody is left to tell.
void write_frame(int descriptor, std::uint32_t kind, Scalar scalar, const void *data,
                 std::uint64_t rows, std::uint64_t columns, std::int32_t code = 0);

void write_text(int descriptor, Kind kind, std::string_view text, std::int32_t code = 0);

} // namespace nmgs::tet
