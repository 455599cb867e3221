// SPDX-License-Identifier: LGPL-2.1-or-later
// NMGS problem setup files: N2S (8-node patches, thesis Table C.1) and N3S (20-node blocks, C.2).
// The grading, which the thesis's format has no place for, follows the last number as lines
// "(spacing of element E along xi: 0 ... 1)": readers skip lines in parentheses, and programs that
// stop after the last number never see them.
#pragma once

#include "nmgs/blocking/block_model.h"
#include "nmgs/support/atomic_file.h"
#include "nmgs/support/text_reader.h"

#include <span>
#include <string>

namespace nmgs {

// How a file lists an element's nodes. perimeter: round it, corner, mid-side, corner, ... from
// corner 1; of a block the bottom so, then the four middles of the vertical edges, then the top.
enum class Numbering { corners_first, perimeter };

struct SetupFile {
    BlockModel model;
    std::string reference; // the user's text, UTF-8, one line
};

// dimension: 2 for N2S, 3 for N3S. Raises FormatError, std::filesystem::filesystem_error; a file
// whose patches fold over themselves as read, but not in the other numbering, is a FormatError
// that says so.
SetupFile read_setup_file(const std::string &path, int dimension,
                          Numbering numbering = Numbering::corners_first);

// Raises ArgumentError when the model is not valid (see validate) or the reference is not one line.
void write_setup_file(const std::string &path, const BlockModel &model,
                      const std::string &reference);

// The parts that result files have too.
namespace setup_section {
// Reads the file id, which must be that of the dimension, the reference text after it and the
// set-up; what spacing lines come later is collected into the model, which must stay where it is.
// Raises ArgumentError for a dimension other than 2 and 3.
void open(TextReader &reader, int dimension, std::span<const char *const, 2> file_ids,
          Numbering numbering, BlockModel &model, std::string &reference);
// Raises FormatError when the lines do not suit the model.
void check_spacing(const TextReader &reader, const BlockModel &model);

void write_head(AtomicFile &file, const std::string &file_id, const std::string &reference);
void write(AtomicFile &file, const BlockModel &model);
void write_spacing(AtomicFile &file, const BlockModel &model);
} // namespace setup_section

} // namespace nmgs
