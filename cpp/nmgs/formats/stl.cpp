// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/stl.h"

#include "nmgs/support/atomic_file.h"
#include "nmgs/support/error.h"
#include "nmgs/support/text_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace nmgs {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t record_size = 50;

// Both are little-endian in the file.
template <class T>
T from_file(const char *bytes) {
    std::array<char, sizeof(T)> value{};
    std::copy_n(bytes, sizeof(T), value.begin());
    if constexpr (std::endian::native == std::endian::big) {
        std::reverse(value.begin(), value.end());
    }
    return std::bit_cast<T>(value);
}

template <class T>
void to_file(std::string &text, T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) {
        std::reverse(bytes.begin(), bytes.end());
    }
    text.append(bytes.data(), bytes.size());
}

void add_triangle(Plc &plc) {
    const auto last = static_cast<std::int32_t>(plc.points.size());
    plc.polygon_nodes.insert(plc.polygon_nodes.end(), {last - 3, last - 2, last - 1});
    plc.end_polygon();
    plc.end_facet();
}

// Triangles of a binary file; -1 when the file's size does not fit its count.
std::int64_t binary_count(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, header_size + 4> head{};
    if (!file.read(head.data(), head.size())) {
        return -1;
    }
    const auto count = from_file<std::uint32_t>(head.data() + header_size);
    const auto size = std::filesystem::file_size(path);
    return size == head.size() + record_size * std::uintmax_t{count} ? std::int64_t{count} : -1;
}

Plc read_binary(const std::string &path, std::int64_t count) {
    std::ifstream file(path, std::ios::binary);
    file.seekg(header_size + 4);
    Plc plc;
    plc.points.reserve(static_cast<std::size_t>(3 * count));
    std::array<char, record_size> record{};
    for (std::int64_t t = 0; t < count; ++t) {
        if (!file.read(record.data(), record.size())) {
            throw FormatError(path, 0, "the file ends inside triangle " + std::to_string(t + 1));
        }
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const char *at = record.data() + 12 * (corner + 1);
            const Vec3 p{from_file<float>(at), from_file<float>(at + 4), from_file<float>(at + 8)};
            if (!is_finite(p)) {
                throw FormatError(path, 0, "triangle " + std::to_string(t + 1) + " is not finite");
            }
            plc.points.push_back(p);
        }
        add_triangle(plc);
    }
    return plc;
}

std::string lower(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

Plc read_text(const std::string &path) {
    TextReader reader(path);
    Plc plc;
    bool any = false;
    std::size_t corners = 0;
    for (std::string word = lower(reader.word()); !word.empty(); word = lower(reader.word())) {
        if (!any && word != "solid") {
            reader.fail("'solid', or a binary STL file of the length that it says", word);
        }
        any = true;
        if (word == "vertex") {
            const double x = reader.real("x of a vertex");
            const double y = reader.real("y of a vertex");
            const double z = reader.real("z of a vertex");
            plc.points.push_back({x, y, z});
            ++corners;
        } else if (word == "endfacet") {
            if (corners != 3) {
                reader.fail("three vertices in a facet", std::to_string(corners));
            }
            corners = 0;
            add_triangle(plc);
        } else if (word == "solid" || word == "endsolid" || word == "facet" || word == "outer") {
            reader.skip_line();
        } else if (word != "endloop") {
            reader.fail("a word of an STL file", word);
        }
    }
    if (!any) {
        reader.fail("'solid'", "");
    }
    if (corners != 0) {
        reader.fail("'endfacet'", "");
    }
    return plc;
}

std::array<Vec3, 3> corners_of(const Plc &plc, std::size_t f) {
    const auto p = static_cast<std::size_t>(plc.facet_offsets[f]);
    const auto n = static_cast<std::size_t>(plc.polygon_offsets[p]);
    if (plc.facet_offsets[f + 1] - plc.facet_offsets[f] != 1 ||
        plc.polygon_offsets[p + 1] - plc.polygon_offsets[p] != 3) {
        throw ArgumentError("facet " + std::to_string(f) +
                            " is not a triangle; .stl cannot hold it, .poly can");
    }
    std::array<Vec3, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = plc.points[static_cast<std::size_t>(plc.polygon_nodes[n + k])];
    }
    return corners;
}

Vec3 unit_normal(const std::array<Vec3, 3> &c) {
    const Vec3 n = cross(c[1] - c[0], c[2] - c[0]);
    const double length = norm(n);
    return length > 0 ? (1 / length) * n : Vec3{0, 0, 0};
}

} // namespace

Plc read_stl(const std::string &path) {
    const std::int64_t count = binary_count(path);
    return count >= 0 ? read_binary(path, count) : read_text(path);
}

void write_stl(const std::string &path, const Plc &plc, bool binary) {
    AtomicFile file(path);
    TextBuffer text;
    std::string bytes(binary ? header_size : 0, ' ');
    if (binary) {
        to_file(bytes, static_cast<std::uint32_t>(plc.facet_count()));
    } else {
        text.add("solid nmgs\n");
    }
    const auto add = [&text](std::string_view word, Vec3 p) {
        text.add(word);
        for (const double c : {p.x, p.y, p.z}) {
            text.add(' ');
            text.add(c);
        }
        text.add('\n');
    };
    for (std::size_t f = 0; f < plc.facet_count(); ++f) {
        const auto corners = corners_of(plc, f);
        const Vec3 normal = unit_normal(corners);
        if (binary) {
            for (const Vec3 p : {normal, corners[0], corners[1], corners[2]}) {
                to_file(bytes, static_cast<float>(p.x));
                to_file(bytes, static_cast<float>(p.y));
                to_file(bytes, static_cast<float>(p.z));
            }
            bytes.append(2, '\0');
        } else {
            add("facet normal", normal);
            text.add("outer loop\n");
            for (const Vec3 p : corners) {
                add("vertex", p);
            }
            text.add("endloop\nendfacet\n");
        }
    }
    if (!binary) {
        text.add("endsolid nmgs\n");
    }
    file.write(binary ? std::string_view(bytes) : text.text());
    file.commit();
}

} // namespace nmgs
