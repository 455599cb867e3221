// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/setup_file.h"

#include "nmgs/element/validity.h"
#include "nmgs/support/error.h"
#include "nmgs/support/memory.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

namespace nmgs {
namespace {

constexpr const char *file_ids[] = {"NMGS-SSMG Problem Setup File", "NMGS-SVMG Problem Setup File"};
constexpr const char *direction_names[] = {"xi", "eta", "zeta"};

// Position in the file -> node of the element, for the perimeter numbering.
constexpr std::array<std::size_t, 8> perimeter8{0, 4, 1, 5, 2, 6, 3, 7};
constexpr std::array<std::size_t, 20> perimeter20{0,  8,  1, 9,  2, 10, 3, 11, 16, 17,
                                                  18, 19, 4, 12, 5, 13, 6, 14, 7,  15};

std::size_t node_at(int dimension, Numbering numbering, std::size_t position) {
    if (numbering == Numbering::corners_first) {
        return position;
    }
    return dimension == 2 ? perimeter8[position] : perimeter20[position];
}

// Upper case and white space runs as one space: ids are compared like this.
std::string normal(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            if (!result.empty() && result.back() != ' ') {
                result += ' ';
            }
        } else {
            result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        }
    }
    while (!result.empty() && result.back() == ' ') {
        result.pop_back();
    }
    return result;
}

bool folds(const BlockModel &model, std::size_t e) {
    const auto nodes = model.element(e);
    const auto validity = model.dimension == 2 ? check_validity(nodes.first<8>()).validity
                                               : check_validity(nodes.first<20>()).validity;
    return validity == Validity::folded;
}

// Elements that fold as read and do not when read in the other numbering give the mistake away.
void check_numbering(const TextReader &reader, const BlockModel &model, Numbering numbering,
                     std::int64_t first_line) {
    const auto n = static_cast<std::size_t>(model.nodes_per_element());
    BlockModel other;
    other.dimension = model.dimension;
    other.nodes.resize(n);
    other.divisions.resize(1);
    for (std::size_t e = 0; e < model.size(); ++e) {
        if (!folds(model, e)) {
            continue;
        }
        const auto nodes = model.element(e);
        for (std::size_t i = 0; i < n; ++i) {
            // nodes[node_at(as read, i)] was at position i of the file.
            const auto swapped = numbering == Numbering::corners_first ? Numbering::perimeter
                                                                       : Numbering::corners_first;
            other.nodes[node_at(model.dimension, swapped, i)] =
                nodes[node_at(model.dimension, numbering, i)];
        }
        if (!folds(other, 0)) {
            const bool corners = numbering == Numbering::corners_first;
            throw FormatError(
                reader.path(), first_line,
                "element " + std::to_string(e + 1) + ": expected its nodes " +
                    (corners ? "corners first" : "round the perimeter") +
                    ", found an element that folds over itself; it does not when its nodes are "
                    "taken " +
                    (corners ? "round the perimeter: read with numbering=\"perimeter\""
                             : "corners first: read with numbering=\"corners-first\""));
        }
    }
}

void parse_spacing(TextReader &reader, BlockModel &model, std::string_view text,
                   std::int64_t line) {
    constexpr std::string_view begin = "spacing of element ";
    if (!text.starts_with(begin)) {
        return;
    }
    text.remove_prefix(begin.size());
    const auto fail = [&](const std::string &what) {
        throw FormatError(reader.path(), line, what);
    };
    const auto next = [&]() {
        const auto first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
        const auto last = std::min(text.find_first_of(" \t\r\n", first), text.size());
        const auto word = text.substr(first, last - first);
        text.remove_prefix(last);
        return word;
    };
    const auto element = parse_integer(next());
    if (!element || *element < 1 || *element > static_cast<std::int64_t>(model.size())) {
        fail("expected a spacing of an element from 1 to " + std::to_string(model.size()));
    }
    if (next() != "along") {
        fail("expected 'along' in the spacing");
    }
    const auto name = next();
    int direction = 0;
    while (direction < model.dimension && name != std::string(direction_names[direction]) + ":") {
        ++direction;
    }
    if (direction == model.dimension) {
        fail("expected a spacing along xi, eta" +
             std::string(model.dimension == 3 ? ", zeta" : "") + ", found '" + to_utf8(name) + "'");
    }
    const auto per_element = static_cast<std::size_t>(model.dimension);
    model.spacing.resize(model.size() * per_element);
    auto &values = model.spacing[(static_cast<std::size_t>(*element) - 1) * per_element +
                                 static_cast<std::size_t>(direction)];
    values.clear();
    for (auto word = next(); !word.empty(); word = next()) {
        const auto value = parse_double(word);
        if (!value) {
            fail("expected positions from 0 to 1, found '" + to_utf8(word) + "'");
        }
        values.push_back(*value);
    }
    if (values.empty()) {
        fail("expected positions from 0 to 1, found none");
    }
}

} // namespace

namespace setup_section {
namespace {

std::string read_head(TextReader &reader, const std::string &file_id) {
    if (!reader.skip_to_text()) {
        reader.fail("'" + file_id + "'", {});
    }
    const bool explained = reader.explanations() > 0;
    const auto id = reader.raw_line();
    if (normal(id.text) != normal(file_id)) {
        reader.fail("'" + file_id + "'", id.text);
    }
    for (;;) {
        const auto line = reader.raw_line();
        if (!line.more) {
            reader.fail("the reference text", {});
        }
        if (explained) {
            const auto first = line.text.find_first_not_of(" \t");
            const std::string_view text =
                std::string_view(line.text).substr(std::min(first, line.text.size()));
            if (text.starts_with("(")) {
                continue;
            }
            if (text.starts_with("---")) {
                return {};
            }
        }
        return line.text;
    }
}

BlockModel read(TextReader &reader, int dimension, Numbering numbering) {
    BlockModel model;
    model.dimension = dimension;
    const auto n = static_cast<std::size_t>(model.nodes_per_element());
    const std::int64_t count =
        reader.integer(dimension == 2 ? "the number of eight-noded elements"
                                      : "the number of twenty-noded elements",
                       1, std::numeric_limits<std::int32_t>::max());
    reader.require_numbers(count * (dimension + 3 * model.nodes_per_element()),
                           "divisions and nodes of the elements");
    for (std::int64_t e = 0; e < count; ++e) {
        std::array<std::int32_t, 3> g{};
        for (int d = 0; d < dimension; ++d) {
            const std::string what = "the divisions of element " + std::to_string(e + 1) +
                                     " along " + direction_names[d];
            g[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(
                reader.integer(what.c_str(), 1, std::numeric_limits<std::int32_t>::max()));
        }
        model.divisions.push_back(g);
    }
    model.nodes.resize(static_cast<std::size_t>(count) * n);
    std::int64_t first_line = 0;
    for (std::size_t e = 0; e < model.size(); ++e) {
        for (std::size_t i = 0; i < n; ++i) {
            Vec3 &p = model.nodes[e * n + node_at(dimension, numbering, i)];
            p.x = reader.real("x of an element's node");
            first_line = first_line == 0 ? reader.line() : first_line;
            p.y = reader.real("y of an element's node");
            p.z = reader.real("z of an element's node");
        }
    }
    check_numbering(reader, model, numbering, first_line);
    return model;
}

void listen(TextReader &reader, BlockModel &model) {
    reader.on_parenthesis([&reader, &model](std::string_view text, std::int64_t line) {
        parse_spacing(reader, model, text, line);
    });
}

} // namespace

void open(TextReader &reader, int dimension, std::span<const char *const, 2> file_ids,
          Numbering numbering, BlockModel &model, std::string &reference) {
    if (dimension != 2 && dimension != 3) {
        throw ArgumentError("dimension: expected 2 or 3, got " + std::to_string(dimension));
    }
    reference = read_head(reader, file_ids[static_cast<std::size_t>(dimension) - 2]);
    model = read(reader, dimension, numbering);
    listen(reader, model);
}

void check_spacing(const TextReader &reader, const BlockModel &model) {
    try {
        validate(model);
    } catch (const ArgumentError &e) {
        throw FormatError(reader.path(), 0, e.what());
    }
}

void write_head(AtomicFile &file, const std::string &file_id, const std::string &reference) {
    if (reference.find_first_of("\r\n") != std::string::npos) {
        throw ArgumentError("reference: expected one line of text");
    }
    file.write(file_id + "\n" + reference + "\n");
}

void write(AtomicFile &file, const BlockModel &model) {
    file.write(std::to_string(model.size()) + "\n");
    const auto count = static_cast<std::int64_t>(model.size());
    write_items(file, count, 4096, [&](std::int64_t first, std::int64_t last, TextBuffer &out) {
        for (std::int64_t e = first; e < last; ++e) {
            const auto g = model.divisions[static_cast<std::size_t>(e)];
            for (int d = 0; d < model.dimension; ++d) {
                out.add(g[static_cast<std::size_t>(d)]);
                out.add(d + 1 < model.dimension ? ' ' : '\n');
            }
        }
    });
    write_items(file, count, 256, [&](std::int64_t first, std::int64_t last, TextBuffer &out) {
        for (std::int64_t e = first; e < last; ++e) {
            for (const Vec3 &p : model.element(static_cast<std::size_t>(e))) {
                out.add(p.x);
                out.add(' ');
                out.add(p.y);
                out.add(' ');
                out.add(p.z);
                out.add('\n');
            }
        }
    });
}

void write_spacing(AtomicFile &file, const BlockModel &model) {
    const auto per_element = static_cast<std::size_t>(model.dimension);
    TextBuffer out;
    for (std::size_t at = 0; at < model.spacing.size(); ++at) {
        if (model.spacing[at].empty()) {
            continue;
        }
        out.add("(spacing of element ");
        out.add(static_cast<std::int64_t>(at / per_element + 1));
        out.add(" along ");
        out.add(direction_names[at % per_element]);
        out.add(':');
        for (const double value : model.spacing[at]) {
            out.add(' ');
            out.add(value);
        }
        out.add(")\n");
    }
    file.write(out.text());
}

} // namespace setup_section

SetupFile read_setup_file(const std::string &path, int dimension, Numbering numbering) {
    TextReader reader(path, Comments::explanations);
    SetupFile file;
    setup_section::open(reader, dimension, file_ids, numbering, file.model, file.reference);
    reader.expect_end();
    setup_section::check_spacing(reader, file.model);
    return file;
}

void write_setup_file(const std::string &path, const BlockModel &model,
                      const std::string &reference) {
    validate(model);
    AtomicFile file(path);
    setup_section::write_head(file, file_ids[model.dimension - 2], reference);
    setup_section::write(file, model);
    setup_section::write_spacing(file, model);
    file.commit();
}

} // namespace nmgs
