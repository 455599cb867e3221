// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/off.h"

#include "nmgs/support/atomic_file.h"
#include "nmgs/support/error.h"
#include "nmgs/support/text_reader.h"

#include <limits>

namespace nmgs {
namespace {

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

// OFF with any of the prefixes ST, C, N; four- and n-dimensional files are something else.
bool is_header(std::string_view word) {
    for (const std::string_view prefix : {"ST", "C", "N"}) {
        if (word.starts_with(prefix)) {
            word.remove_prefix(prefix.size());
        }
    }
    return word == "OFF";
}

} // namespace

Plc read_off(const std::string &path) {
    TextReader reader(path, Comments::hash);
    const std::string header(reader.word());
    if (!is_header(header)) {
        reader.fail("'OFF'", header);
    }
    Plc plc;
    const std::int64_t points = reader.integer("the number of points", 0, most);
    const std::int64_t faces = reader.integer("the number of faces", 0, most);
    reader.skip_line(); // the number of edges means nothing
    reader.require_numbers(3 * points, "the points");
    reader.require_numbers(faces, "the faces");
    plc.points.reserve(static_cast<std::size_t>(points));
    for (std::int64_t i = 0; i < points; ++i) {
        const double x = reader.real("x of a point");
        const double y = reader.real("y of a point");
        const double z = reader.real("z of a point");
        plc.points.push_back({x, y, z});
        reader.skip_line();
    }
    for (std::int64_t f = 0; f < faces; ++f) {
        const std::int64_t size = reader.integer("the number of nodes of a face", 1, most);
        reader.require_numbers(size, "a face");
        for (std::int64_t k = 0; k < size; ++k) {
            plc.polygon_nodes.push_back(
                static_cast<std::int32_t>(reader.integer("a node of a face", 0, points - 1)));
        }
        plc.end_polygon();
        plc.end_facet();
        reader.skip_line();
    }
    return plc;
}

void write_off(const std::string &path, const Plc &plc) {
    for (std::size_t f = 0; f < plc.facet_count(); ++f) {
        if (plc.facet_offsets[f + 1] - plc.facet_offsets[f] != 1) {
            throw ArgumentError("facet " + std::to_string(f) +
                                " has several polygons; .off cannot hold it, .poly can");
        }
    }
    AtomicFile file(path);
    file.write("OFF\n" + std::to_string(plc.points.size()) + " " +
               std::to_string(plc.facet_count()) + " 0\n");
    TextBuffer text;
    for (const Vec3 p : plc.points) {
        text.add(p.x);
        text.add(' ');
        text.add(p.y);
        text.add(' ');
        text.add(p.z);
        text.add('\n');
    }
    for (std::size_t f = 0; f < plc.facet_count(); ++f) {
        const auto p = static_cast<std::size_t>(plc.facet_offsets[f]);
        text.add(plc.polygon_offsets[p + 1] - plc.polygon_offsets[p]);
        for (std::int64_t n = plc.polygon_offsets[p]; n < plc.polygon_offsets[p + 1]; ++n) {
            text.add(' ');
            text.add(plc.polygon_nodes[static_cast<std::size_t>(n)]);
        }
        text.add('\n');
    }
    file.write(text.text());
    file.commit();
}

} // namespace nmgs
