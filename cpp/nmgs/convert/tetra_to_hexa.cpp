// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/tetra_to_hexa.h"

#include "nmgs/mesh/faces.h"
#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <limits>
#include <map>

namespace nmgs {
namespace {

// For each corner: the three others, right-handed; mid-sides (tetra10) and faces (cell_topology)
// between them.
struct Corner {
    std::array<int, 3> mids;  // of the edges to the three
    std::array<int, 3> faces; // with the first two, the first and the last, the last two
};
constexpr Corner corners[4] = {
    {{4, 6, 7}, {0, 1, 3}}, // to 1, 2, 3
    {{5, 4, 8}, {0, 2, 1}}, // to 2, 0, 3
    {{6, 5, 9}, {0, 3, 2}}, // to 0, 1, 3
    {{7, 9, 8}, {3, 1, 2}}, // to 0, 2, 1
};

} // namespace

HexahedraOfTetrahedra split_tetrahedra(std::int32_t first_face,
                                       std::span<const std::int32_t> tetrahedra,
                                       std::span<const std::int32_t> triangles,
                                       const Progress &progress) {
    const CellView view{CellType::tetra10, tetrahedra};
    const Faces faces =
        find_faces(static_cast<std::size_t>(first_face), {&view, 1}, progress, 0, 0.7);
    HexahedraOfTetrahedra result;
    std::map<std::array<std::int32_t, 3>, std::int32_t> number;
    for (const Face &face : faces.faces) {
        result.face_corners.push_back({face.key[0], face.key[1], face.key[2]});
    }
    if (!triangles.empty()) {
        for (std::size_t f = 0; f < result.face_corners.size(); ++f) {
            number.emplace(result.face_corners[f], static_cast<std::int32_t>(f));
        }
    }
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
        std::array<std::int32_t, 3> key{triangles[t], triangles[t + 1], triangles[t + 2]};
        std::sort(key.begin(), key.end());
        if (key[0] < 0 || key[2] >= first_face) {
            throw ArgumentError("cells: triangle " + std::to_string(t / 3) +
                                " has a node that the mesh does not have");
        }
        const auto [at, fresh] =
            number.emplace(key, static_cast<std::int32_t>(result.face_corners.size()));
        if (fresh) {
            result.face_corners.push_back(key);
        }
        result.face_of_triangle.push_back(at->second);
    }
    const std::size_t count = view.size();
    const std::size_t first_centre =
        static_cast<std::size_t>(first_face) + result.face_corners.size();
    if (first_centre + count > std::numeric_limits<std::int32_t>::max()) {
        throw ArgumentError("cells: the mesh would have " + std::to_string(first_centre + count) +
                            " nodes; node numbers end at 2147483647");
    }
    result.hexahedra = Array<std::int32_t>(32 * count);
    parallel_for(
        count, 1 << 13,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t c = first; c < last; ++c) {
                const std::int32_t *t = tetrahedra.data() + 10 * c;
                std::int32_t *out = result.hexahedra.data() + 32 * c;
                for (std::size_t v = 0; v < 4; ++v) {
                    const auto face = [&](std::size_t i) {
                        return first_face + faces.of_cells[0][4 * c + static_cast<std::size_t>(
                                                                          corners[v].faces[i])];
                    };
                    out[0] = t[v];
                    out[1] = t[corners[v].mids[0]];
                    out[2] = face(0);
                    out[3] = t[corners[v].mids[1]];
                    out[4] = t[corners[v].mids[2]];
                    out[5] = face(1);
                    out[6] = static_cast<std::int32_t>(first_centre + c);
                    out[7] = face(2);
                    out += 8;
                }
            }
        },
        progress, 0.7, 1.0);
    return result;
}

} // namespace nmgs
