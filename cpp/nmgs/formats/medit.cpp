// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/formats/medit.h"

#include "nmgs/support/text_reader.h"

#include <limits>
#include <optional>

namespace nmgs {
namespace {

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

std::optional<CellType> type_of(std::string_view word) {
    if (word == "Edges") {
        return CellType::line;
    }
    if (word == "Triangles") {
        return CellType::triangle;
    }
    if (word == "Quadrilaterals") {
        return CellType::quad;
    }
    if (word == "Tetrahedra") {
        return CellType::tetra;
    }
    if (word == "Hexahedra") {
        return CellType::hexahedron;
    }
    return std::nullopt;
}

bool is_word(std::string_view word) {
    return (word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z');
}

struct Reading {
    TextReader &reader;
    MeditMesh mesh;

    std::int32_t reference() {
        return static_cast<std::int32_t>(reader.integer("a reference number", -most - 1, most));
    }

    void vertices(int dimension) {
        const std::int64_t count = reader.integer("the number of vertices", 0, most);
        reader.require_numbers((dimension + 1) * count, "the vertices");
        mesh.points.reserve(static_cast<std::size_t>(count));
        for (std::int64_t i = 0; i < count; ++i) {
            const double x = reader.real("x of a vertex");
            const double y = reader.real("y of a vertex");
            const double z = dimension == 3 ? reader.real("z of a vertex") : 0.0;
            mesh.points.push_back({x, y, z});
            mesh.point_references.push_back(reference());
        }
    }

    void cells(CellType type) {
        const std::int64_t count = reader.integer("the number of cells", 0, most);
        const auto points = static_cast<std::int64_t>(mesh.points.size());
        const int k = node_count(type);
        reader.require_numbers((k + 1) * count, "the cells");
        MeditCells block{type, {}, {}};
        for (std::int64_t c = 0; c < count; ++c) {
            for (int n = 0; n < k; ++n) {
                block.nodes.push_back(
                    static_cast<std::int32_t>(reader.integer("a node of a cell", 1, points)) - 1);
            }
            block.references.push_back(reference());
        }
        mesh.cells.push_back(std::move(block));
    }
};

} // namespace

MeditMesh read_medit(const std::string &path) {
    TextReader reader(path, Comments::hash);
    const std::string first(reader.word());
    if (!first.starts_with("MeshVersionFormatted")) {
        reader.fail("'MeshVersionFormatted'", first);
    }
    reader.integer("the version", 0, 4);
    Reading reading{reader, {}};
    int dimension = 3;
    bool ended = false;
    for (std::string word(reader.word()); !word.empty() && !ended; word = reader.word()) {
        if (word == "Dimension") {
            dimension = static_cast<int>(reader.integer("the dimension", 2, 3));
        } else if (word == "Vertices") {
            reading.vertices(dimension);
        } else if (const auto type = type_of(word)) {
            reading.cells(*type);
        } else if (word == "End") {
            ended = true;
        } else if (is_word(word)) {
            continue; // a part that is left out; its numbers follow
        } else if (reader.line() > 0) {
            reader.real(word, "a keyword of Medit's, or a number of a part that is left out");
        }
    }
    if (reading.mesh.points.empty()) {
        reader.fail("'Vertices'", "the end of the file");
    }
    return std::move(reading.mesh);
}

} // namespace nmgs
