// SPDX-License-Identifier: LGPL-2.1-or-later
// The errors of the kernel. They derive from the standard exceptions, and the bindings turn each
// into the Python type of the same name; ArgumentError becomes ValueError.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace nmgs {

// Base of all that is the input's fault and not the call's.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// An argument is out of its range; the message names the argument and its value.
struct ArgumentError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

// A file is not what its format says. line is 1-based; 0 where the whole file is meant.
struct FormatError : Error {
    FormatError(std::string path_, std::int64_t line_, const std::string &what_)
        : Error(path_ + (line_ > 0 ? ":" + std::to_string(line_) : std::string()) + ": " + what_),
          path(std::move(path_)), line(line_) {}
    std::string path;
    std::int64_t line;
};

// A shape, or a part of it, cannot be used. entities are named as FreeCAD does: "Solid1.Face7".
struct GeometryError : Error {
    GeometryError(const std::string &what_, std::vector<std::string> entities_)
        : Error(what_), entities(std::move(entities_)) {}
    std::vector<std::string> entities;
};

// A model of blocks cannot be made or meshed. reasons[i] belongs to entities[i].
struct BlockingError : Error {
    BlockingError(const std::string &what_, std::vector<std::string> entities_,
                  std::vector<std::string> reasons_)
        : Error(what_), entities(std::move(entities_)), reasons(std::move(reasons_)) {}
    std::vector<std::string> entities;
    std::vector<std::string> reasons;
};

// The caller's progress callback asked to stop.
struct Cancelled : Error {
    Cancelled() : Error("cancelled") {}
};

} // namespace nmgs
