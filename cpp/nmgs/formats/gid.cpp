// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/gid.h"

#include "nmgs/support/atomic_file.h"
#include "nmgs/support/error.h"
#include "nmgs/support/text_reader.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>

namespace nmgs {
namespace {

// Lower case; quotes and '=' are white space; one blank between words; nothing behind a '#'.
std::vector<std::string> words_of(const std::string &line) {
    std::vector<std::string> words;
    bool inside = false;
    for (const char c : line) {
        if (c == '#') {
            break;
        }
        const auto u = static_cast<unsigned char>(c);
        if (std::isspace(u) != 0 || c == '"' || c == '=') {
            inside = false;
            continue;
        }
        if (!inside) {
            words.emplace_back();
            inside = true;
        }
        words.back() += static_cast<char>(std::tolower(u));
    }
    return words;
}

struct Reading {
    TextReader &reader;
    GidMesh mesh;
    std::unordered_map<std::int64_t, std::int32_t> numbers;
    enum { outside, coordinates, elements } part = outside;

    void header(const std::vector<std::string> &words) {
        for (std::size_t i = 0; i + 1 < words.size(); ++i) {
            if (words[i] == "nnode") {
                mesh.columns = static_cast<int>(reader.integer(words[i + 1], "nnode", 1, 27));
            }
            if (words[i] == "dimension" && words[i + 1] != "3") {
                reader.fail("dimension 3", words[i + 1]);
            }
        }
        const int n = mesh.columns;
        if (n != 3 && n != 4 && n != 6 && n != 10) {
            reader.fail("triangles or tetrahedra: nnode 3, 4, 6 or 10", std::to_string(n));
        }
    }

    void row(const std::vector<std::string> &words) {
        const std::size_t wanted =
            1 + (part == coordinates ? 3 : static_cast<std::size_t>(mesh.columns));
        // A cell may have its material's number at the end.
        if (words.size() < wanted || words.size() > wanted + (part == elements ? 1 : 0)) {
            reader.fail(std::to_string(wanted) + " numbers", std::to_string(words.size()));
        }
        const std::int64_t number = reader.integer(words[0], "a number");
        if (part == coordinates) {
            const auto place = static_cast<std::int32_t>(mesh.points.size());
            if (!numbers.try_emplace(number, place).second) {
                reader.fail("every node once", words[0]);
            }
            mesh.points.push_back({reader.real(words[1], "x"), reader.real(words[2], "y"),
                                   reader.real(words[3], "z")});
            return;
        }
        for (std::size_t k = 1; k < wanted; ++k) {
            const auto node = numbers.find(reader.integer(words[k], "a node"));
            if (node == numbers.end()) {
                reader.fail("a node that has coordinates", words[k]);
            }
            mesh.nodes.push_back(node->second);
        }
    }

    void line(const std::vector<std::string> &words) {
        if (words.empty()) {
            return;
        }
        if (words[0] == "end" && words.size() > 1 && part != outside) {
            part = outside;
        } else if (part == outside && words[0] == "mesh") {
            header(words);
        } else if (part == outside && words[0] == "coordinates") {
            part = coordinates;
        } else if (part == outside && words[0] == "elements") {
            if (mesh.columns == 0) {
                reader.fail("'mesh dimension = 3 elemtype ... nnode = ...' first", words[0]);
            }
            part = elements;
        } else if (part != outside) {
            row(words);
        } // else the user's reference text
    }
};

} // namespace

GidMesh read_gid(const std::string &path) {
    TextReader reader(path);
    Reading reading{reader, {}, {}};
    for (;;) {
        const TextReader::Line line = reader.raw_line();
        reading.line(words_of(line.text));
        if (!line.more) {
            break;
        }
    }
    if (reading.mesh.columns == 0 || reading.mesh.points.empty() || reading.part != 0) {
        reader.fail("a GiD mesh up to its 'end elements'", "the end of the file");
    }
    return std::move(reading.mesh);
}

void write_gid(const std::string &path, const GidMesh &mesh) {
    const auto k = static_cast<std::size_t>(mesh.columns);
    const bool triangles = k == 3 || k == 6;
    AtomicFile file(path);
    file.write("mesh dimension = 3 elemtype " +
               std::string(triangles ? "triangle" : "tetrahedron") +
               " nnode = " + std::to_string(k) + "\ncoordinates\n");
    write_items(file, static_cast<std::int64_t>(mesh.points.size()), 4096,
                [&](std::int64_t begin, std::int64_t end, TextBuffer &text) {
                    for (std::int64_t i = begin; i < end; ++i) {
                        const Vec3 p = mesh.points[static_cast<std::size_t>(i)];
                        text.add(i + 1);
                        for (const double c : {p.x, p.y, p.z}) {
                            text.add(' ');
                            text.add(c);
                        }
                        text.add('\n');
                    }
                });
    file.write("end coordinates\nelements\n");
    write_items(file, static_cast<std::int64_t>(mesh.nodes.size() / k), 4096,
                [&](std::int64_t begin, std::int64_t end, TextBuffer &text) {
                    for (std::int64_t i = begin; i < end; ++i) {
                        text.add(i + 1);
                        for (std::size_t c = 0; c < k; ++c) {
                            text.add(' ');
                            text.add(mesh.nodes[static_cast<std::size_t>(i) * k + c] + 1);
                        }
                        text.add('\n');
                    }
                });
    file.write("end elements\n");
    file.commit();
}

} // namespace nmgs
