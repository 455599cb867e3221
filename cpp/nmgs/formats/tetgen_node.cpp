// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/tetgen_node.h"

#include "nmgs/support/atomic_file.h"

#include <limits>

namespace nmgs {
namespace {

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

// The rest of a header or row may be left out; what is left out is 0.
std::int64_t optional_integer(TextReader &reader, const char *what, std::int64_t low,
                              std::int64_t high) {
    const std::string_view word = reader.word_on_line();
    return word.empty() ? 0 : reader.integer(word, what, low, high);
}

} // namespace

void read_points(TextReader &reader, Plc &plc, std::int32_t &first) {
    const std::int64_t count = reader.integer("the number of points", 0, most);
    const std::string_view dimension = reader.word_on_line();
    if (!dimension.empty() && reader.integer(dimension, "the dimension", 2, 3) != 3) {
        reader.fail("the dimension 3", "2");
    }
    const std::int64_t attributes =
        optional_integer(reader, "the number of point attributes", 0, 1000000);
    const bool markers = optional_integer(reader, "the number of point markers", 0, 1) > 0;
    reader.skip_line();
    if (count == 0) {
        return;
    }
    reader.require_numbers(4 * count, "the points");
    plc.points.reserve(static_cast<std::size_t>(count));
    plc.attribute_count = static_cast<std::int32_t>(attributes);
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t number =
            reader.integer("the number of a point", i == 0 ? 0 : first + i, first + i + (i == 0));
        if (i == 0) {
            first = static_cast<std::int32_t>(number);
        }
        const double x = reader.real("x of a point");
        const double y = reader.real("y of a point");
        const double z = reader.real("z of a point");
        plc.points.push_back({x, y, z});
        for (std::int64_t k = 0; k < attributes; ++k) {
            const std::string_view word = reader.word_on_line();
            plc.point_attributes.push_back(
                word.empty() ? 0.0 : reader.real(word, "an attribute of a point"));
        }
        if (markers) {
            plc.point_markers.push_back(static_cast<std::int32_t>(
                optional_integer(reader, "the marker of a point", -most - 1, most)));
        }
        reader.skip_line();
    }
}

Plc read_node(const std::string &path, std::int32_t *first) {
    TextReader reader(path, Comments::hash);
    Plc plc;
    std::int32_t number = 0;
    read_points(reader, plc, number);
    reader.expect_end();
    if (first != nullptr) {
        *first = number;
    }
    return plc;
}

void add_point_line(TextBuffer &text, const Plc &plc, std::size_t point, std::int32_t first) {
    const Vec3 p = plc.points[point];
    text.add(static_cast<std::int64_t>(point) + first);
    for (const double c : {p.x, p.y, p.z}) {
        text.add(' ');
        text.add(c);
    }
    const auto k = static_cast<std::size_t>(plc.attribute_count);
    for (std::size_t a = 0; a < k; ++a) {
        text.add(' ');
        text.add(plc.point_attributes[point * k + a]);
    }
    if (!plc.point_markers.empty()) {
        text.add(' ');
        text.add(plc.point_markers[point]);
    }
    text.add('\n');
}

void write_node(const std::string &path, const Plc &plc, std::int32_t first) {
    AtomicFile file(path);
    file.write(std::to_string(plc.points.size()) + " 3 " + std::to_string(plc.attribute_count) +
               (plc.point_markers.empty() ? " 0\n" : " 1\n"));
    write_items(file, static_cast<std::int64_t>(plc.points.size()), 4096,
                [&](std::int64_t begin, std::int64_t end, TextBuffer &text) {
                    for (std::int64_t i = begin; i < end; ++i) {
                        add_point_line(text, plc, static_cast<std::size_t>(i), first);
                    }
                });
    file.commit();
}

} // namespace nmgs
