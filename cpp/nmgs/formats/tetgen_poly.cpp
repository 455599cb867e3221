// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/tetgen_poly.h"

#include "nmgs/formats/tetgen_node.h"
#include "nmgs/support/atomic_file.h"
#include "nmgs/support/error.h"

#include <filesystem>
#include <limits>

namespace nmgs {
namespace {

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

struct Reading {
    TextReader &reader;
    Plc &plc;
    std::int32_t first;
    bool markers;

    // A polygon's nodes may go on over several lines.
    void polygon(std::int64_t size) {
        const auto points = static_cast<std::int64_t>(plc.points.size());
        reader.require_numbers(size, "a polygon");
        for (std::int64_t k = 0; k < size; ++k) {
            plc.polygon_nodes.push_back(static_cast<std::int32_t>(
                reader.integer("a node of a polygon", first, first + points - 1) - first));
        }
        plc.end_polygon();
    }

    void marker() {
        const std::string_view word = reader.word_on_line();
        if (markers) {
            plc.facet_markers.push_back(word.empty()
                                            ? 0
                                            : static_cast<std::int32_t>(reader.integer(
                                                  word, "the marker of a facet", -most - 1, most)));
        }
    }

    void smesh_facet() {
        polygon(reader.integer("the number of nodes of a facet", 1, most));
        marker();
        reader.skip_line();
        plc.end_facet();
    }

    void poly_facet() {
        const std::int64_t polygons = reader.integer("the number of polygons of a facet", 1, most);
        const std::string_view word = reader.word_on_line();
        const std::int64_t holes =
            word.empty() ? 0 : reader.integer(word, "the number of holes of a facet", 0, most);
        marker();
        reader.skip_line();
        for (std::int64_t p = 0; p < polygons; ++p) {
            polygon(reader.integer("the number of nodes of a polygon", 1, most));
            reader.skip_line();
        }
        for (std::int64_t h = 0; h < holes; ++h) {
            plc.facet_holes.push_back(place("a hole of a facet"));
            reader.skip_line();
        }
        plc.end_facet();
    }

    Vec3 place(const char *what) {
        reader.integer("a number in a list", -most, most);
        const double x = reader.real(reader.word_on_line(), what);
        const double y = reader.real(reader.word_on_line(), what);
        return {x, y, reader.real(reader.word_on_line(), what)};
    }

    void holes() {
        const std::string_view word = reader.word();
        if (word.empty()) {
            return;
        }
        const std::int64_t count = reader.integer(word, "the number of holes", 0, most);
        reader.skip_line();
        for (std::int64_t h = 0; h < count; ++h) {
            plc.holes.push_back(place("a hole"));
            reader.skip_line();
        }
    }

    // A missing volume is the attribute: with -a alone the one number is the volume.
    void regions() {
        const std::string_view word = reader.word();
        if (word.empty()) {
            return;
        }
        const std::int64_t count = reader.integer(word, "the number of regions", 0, most);
        reader.skip_line();
        for (std::int64_t r = 0; r < count; ++r) {
            const Vec3 point = place("a region");
            const double attribute = reader.real("the attribute of a region");
            const std::string_view last = reader.word_on_line();
            plc.regions.push_back(
                {point, attribute,
                 last.empty() ? attribute : reader.real(last, "the volume of a region")});
            reader.skip_line();
        }
    }
};

bool is_plain(const Plc &plc, std::size_t f) {
    return plc.facet_offsets[f + 1] - plc.facet_offsets[f] == 1 &&
           plc.facet_hole_offsets[f + 1] == plc.facet_hole_offsets[f];
}

void add_place(TextBuffer &text, std::int64_t number, Vec3 p) {
    text.add(number);
    for (const double c : {p.x, p.y, p.z}) {
        text.add(' ');
        text.add(c);
    }
}

void add_facet(TextBuffer &text, const Plc &plc, std::size_t f, PolyKind kind, std::int32_t first) {
    const std::int64_t begin = plc.facet_offsets[f];
    const std::int64_t end = plc.facet_offsets[f + 1];
    const std::int64_t hole_begin = plc.facet_hole_offsets[f];
    const std::int64_t hole_end = plc.facet_hole_offsets[f + 1];
    const auto add_marker = [&] {
        if (!plc.facet_markers.empty()) {
            text.add(' ');
            text.add(plc.facet_markers[f]);
        }
    };
    if (kind == PolyKind::poly) {
        text.add(end - begin);
        text.add(' ');
        text.add(hole_end - hole_begin);
        add_marker();
        text.add('\n');
    }
    for (std::int64_t p = begin; p < end; ++p) {
        const auto at = static_cast<std::size_t>(p);
        text.add(plc.polygon_offsets[at + 1] - plc.polygon_offsets[at]);
        for (std::int64_t n = plc.polygon_offsets[at]; n < plc.polygon_offsets[at + 1]; ++n) {
            text.add(' ');
            text.add(plc.polygon_nodes[static_cast<std::size_t>(n)] + first);
        }
        if (kind == PolyKind::smesh) {
            add_marker();
        }
        text.add('\n');
    }
    for (std::int64_t h = hole_begin; h < hole_end; ++h) {
        add_place(text, h - hole_begin + 1, plc.facet_holes[static_cast<std::size_t>(h)]);
        text.add('\n');
    }
}

} // namespace

Plc read_poly(const std::string &path, PolyKind kind) {
    TextReader reader(path, Comments::hash);
    Plc plc;
    std::int32_t first = 0;
    read_points(reader, plc, first);
    if (plc.points.empty()) {
        plc = read_node(std::filesystem::path(path).replace_extension(".node").string(), &first);
    }
    Reading reading{reader, plc, first, false};
    const std::string_view word = reader.word();
    const std::int64_t facets =
        word.empty() ? 0 : reader.integer(word, "the number of facets", 0, most);
    const std::string_view flag = reader.word_on_line();
    reading.markers =
        !flag.empty() && reader.integer(flag, "the number of facet markers", 0, most) == 1;
    reader.skip_line();
    reader.require_numbers(2 * facets, "the facets");
    for (std::int64_t f = 0; f < facets; ++f) {
        kind == PolyKind::poly ? reading.poly_facet() : reading.smesh_facet();
    }
    reading.holes();
    reading.regions();
    reader.expect_end();
    return plc;
}

void write_poly(const std::string &path, const Plc &plc, PolyKind kind, std::int32_t first) {
    for (std::size_t f = 0; kind == PolyKind::smesh && f < plc.facet_count(); ++f) {
        if (!is_plain(plc, f)) {
            throw ArgumentError("facet " + std::to_string(f) +
                                " has several polygons or holes; .smesh cannot hold it, .poly can");
        }
    }
    AtomicFile file(path);
    file.write(std::to_string(plc.points.size()) + " 3 " + std::to_string(plc.attribute_count) +
               (plc.point_markers.empty() ? " 0\n" : " 1\n"));
    write_items(file, static_cast<std::int64_t>(plc.points.size()), 4096,
                [&](std::int64_t begin, std::int64_t end, TextBuffer &text) {
                    for (std::int64_t i = begin; i < end; ++i) {
                        add_point_line(text, plc, static_cast<std::size_t>(i), first);
                    }
                });
    file.write(std::to_string(plc.facet_count()) + (plc.facet_markers.empty() ? " 0\n" : " 1\n"));
    write_items(file, static_cast<std::int64_t>(plc.facet_count()), 4096,
                [&](std::int64_t begin, std::int64_t end, TextBuffer &text) {
                    for (std::int64_t f = begin; f < end; ++f) {
                        add_facet(text, plc, static_cast<std::size_t>(f), kind, first);
                    }
                });
    TextBuffer text;
    text.add(static_cast<std::int64_t>(plc.holes.size()));
    text.add('\n');
    for (std::size_t h = 0; h < plc.holes.size(); ++h) {
        add_place(text, static_cast<std::int64_t>(h) + 1, plc.holes[h]);
        text.add('\n');
    }
    text.add(static_cast<std::int64_t>(plc.regions.size()));
    text.add('\n');
    for (std::size_t r = 0; r < plc.regions.size(); ++r) {
        add_place(text, static_cast<std::int64_t>(r) + 1, plc.regions[r].point);
        text.add(' ');
        text.add(plc.regions[r].attribute);
        text.add(' ');
        text.add(plc.regions[r].volume);
        text.add('\n');
    }
    file.write(text.text());
    file.commit();
}

} // namespace nmgs
